#include "TetrahedraState.h"

#include "SimulationFilterLists.h"

#include "Conversion/InputRepresentation.h"
#include "Conversion/ValueConversion.h"

#include "Native/ReadNativeData.h"

#include "vtkDataObject.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace conversion = strata::conversion;

namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();
/// The default of InterfaceErrorBound, in units of the box's diagonal.
constexpr double defaultInterfaceBound = 0.005;

void checkBound(const std::string& name, double value, bool zeroAllowed)
{
  if (!(value > 0.0 || (zeroAllowed && value == 0.0)))
  {
    std::ostringstream message;
    message << name << " is " << value << "; it must be "
            << (zeroAllowed ? "positive, or 0 for the default" : "positive");
    throw strata::InvalidInput(message.str());
  }
}

void checkAtLeast(const std::string& name, std::int64_t value, std::int64_t least)
{
  if (value < least)
  {
    throw strata::InvalidInput(
      name + " is " + std::to_string(value) + "; it must be at least " + std::to_string(least));
  }
}
}

strata::BuildOptions vtkStrataTetrahedra::Internals::buildOptions(const vtkStrataTetrahedra& filter) const
{
  strata::BuildOptions options;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    checkAtLeast("BaseCubes", filter.BaseCubes[axis], 1);
    options.baseCubes[axis] = filter.BaseCubes[axis];
  }
  checkAtLeast("MaximumLevel", filter.MaximumLevel, 0);
  options.maximumLevel = filter.MaximumLevel;
  options.distanceMethod = static_cast<strata::DistanceMethod>(filter.DistanceMethod);
  options.ghostMethod = static_cast<strata::GhostMethod>(filter.GhostMethod);
  options.nativeElements = static_cast<strata::NativeElements>(filter.NativeElements);
  return options;
}

std::string vtkStrataTetrahedra::Internals::keyOf(const vtkStrataTetrahedra& filter, const Inputs& inputs) const
{
  const Lists& lists = *filter.ArrayLists;
  std::ostringstream text;
  text.precision(17);
  text << inputs.simulation << ' ' << conversion::modifiedTime(inputs.simulation) << ' ' << inputs.interfaces << ' '
       << conversion::modifiedTime(inputs.interfaces) << ' ' << conversion::listed(lists.volumeFractionArrays) << '/'
       << conversion::listed(lists.materialsWithoutFields) << '/' << conversion::listed(lists.fieldArrays) << '/'
       << filter.MaterialIdArray << '/' << filter.BlocksAsMaterials << '/' << filter.RemainderMaterial << '/'
       << filter.MinimumVolumeFraction << ' ' << filter.BaseCubes[0] << ' ' << filter.BaseCubes[1] << ' '
       << filter.BaseCubes[2] << ' ' << filter.MaximumLevel << ' ' << filter.DistanceMethod << ' ' << filter.GhostMethod
       << ' ' << filter.NativeElements;
  return text.str();
}

bool vtkStrataTetrahedra::Internals::prepare(
  const vtkStrataTetrahedra& filter, const Inputs& inputs, strata::Progress& progress)
{
  const std::string wanted = this->keyOf(filter, inputs);
  if (this->multiresolution && this->key == wanted)
  {
    return false;
  }
  this->multiresolution.reset();
  const strata::BuildOptions options = this->buildOptions(filter);
  const conversion::CaseData input = conversion::splitCase(inputs.simulation);
  conversion::ReadSimulationResult read = conversion::readSimulation(input, filter.ArrayLists->options(filter));
  this->warnings = std::move(read.warnings);
  this->deviations = std::move(read.deviations);
  progress.stage("Finding the interfaces", 0.0, 0.0);
  std::shared_ptr<strata::PreparedInterfaces> found = this->interfaces.get(
    input, inputs.interfaces, read.simulation, filter.MinimumVolumeFraction, this->warnings, progress);
  progress.stage("Reading the fields", 0.0, 0.0);
  strata::NativeOptions nativeOptions;
  nativeOptions.minimumVolumeFraction = filter.MinimumVolumeFraction;
  this->native = strata::readNativeData(read.simulation, nativeOptions, progress);
  this->multiresolution = std::make_unique<strata::Multiresolution>(this->native, std::move(found), options);
  this->key = wanted;
  return true;
}

strata::ErrorBounds vtkStrataTetrahedra::Internals::bounds(double interfaceError, double relativeFieldError) const
{
  strata::ErrorBounds result;
  result.interfaceError = interfaceError;
  for (std::size_t f = 0; f < this->native->fields().size(); ++f)
  {
    const strata::FieldId field(static_cast<std::int64_t>(f));
    // Vectors that differ in direction alone have no range of lengths; a field of zeros has neither.
    const double range = this->native->range(field);
    const double scale = range > 0.0 ? range : this->native->magnitude(field);
    result.fieldErrors.push_back(scale > 0.0 ? relativeFieldError * scale : infinity);
  }
  return result;
}

strata::RegionOfInterest vtkStrataTetrahedra::Internals::region(const vtkStrataTetrahedra& filter)
{
  if (!(filter.RegionCoarsening >= 1.0))
  {
    std::ostringstream message;
    message << "RegionCoarsening is " << filter.RegionCoarsening << "; it must be at least 1";
    throw strata::InvalidInput(message.str());
  }
  strata::RegionOfInterest region;
  region.coarsening = filter.RegionCoarsening;
  if (filter.RegionOfInterest == SPHERE)
  {
    checkBound("RegionRadius", filter.RegionRadius, false);
    region.shape = strata::RegionOfInterest::Shape::Sphere;
    region.center = strata::Vector(filter.RegionCenter);
    region.radius = filter.RegionRadius;
    return region;
  }
  const double* bounds = filter.RegionBounds;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(bounds[2 * axis] <= bounds[2 * axis + 1]))
    {
      std::ostringstream message;
      message << "RegionBounds go from " << bounds[2 * axis] << " to " << bounds[2 * axis + 1] << " along "
              << "xyz"[axis] << "; the first must not be the larger";
      throw strata::InvalidInput(message.str());
    }
  }
  region.box.add(strata::Vector(bounds[0], bounds[2], bounds[4]));
  region.box.add(strata::Vector(bounds[1], bounds[3], bounds[5]));
  return region;
}

strata::View vtkStrataTetrahedra::Internals::view(const vtkStrataTetrahedra& filter)
{
  strata::View view;
  view.position = strata::Vector(filter.CameraPosition);
  view.focalPoint = strata::Vector(filter.CameraFocalPoint);
  view.viewUp = strata::Vector(filter.CameraViewUp);
  view.viewAngle = filter.CameraViewAngle;
  view.aspect = filter.ImageAspect;
  view.imageHeight = filter.ImageHeight;
  view.pixelBound = filter.PixelErrorBound;
  view.check();
  return view;
}

strata::Interest vtkStrataTetrahedra::Internals::interest(const vtkStrataTetrahedra& filter) const
{
  strata::Interest interest;
  if (!this->focusMaterials.empty())
  {
    interest.focus = conversion::chosenMaterials(this->focusMaterials, this->native->materials());
  }
  if (filter.RegionOfInterest != NONE)
  {
    interest.region = region(filter);
  }
  if (filter.ViewDependent)
  {
    interest.view = view(filter);
  }
  return interest;
}

strata::SelectOptions vtkStrataTetrahedra::Internals::selection(const vtkStrataTetrahedra& filter) const
{
  checkBound("InterfaceErrorBound", filter.InterfaceErrorBound, true);
  checkBound("FieldErrorBound", filter.FieldErrorBound, false);
  checkBound("FinestInterfaceErrorBound", filter.FinestInterfaceErrorBound, true);
  checkBound("FinestFieldErrorBound", filter.FinestFieldErrorBound, true);
  strata::SelectOptions options;
  const double diagonal = this->native->box().diagonal();
  options.bounds =
    this->bounds(filter.InterfaceErrorBound > 0.0 ? filter.InterfaceErrorBound : defaultInterfaceBound * diagonal,
      filter.FieldErrorBound);
  const std::vector<strata::Field>& fields = this->native->fields();
  for (const auto& [name, bound] : this->absoluteBounds)
  {
    checkBound("The absolute error bound of '" + name + "'", bound, false);
    const auto at = std::find_if(
      fields.begin(), fields.end(), [&wanted = name](const strata::Field& field) { return field.name == wanted; });
    if (at == fields.end())
    {
      throw strata::InvalidInput("AbsoluteFieldErrorBounds names the field '" + name + "', which is not represented");
    }
    options.bounds.fieldErrors[static_cast<std::size_t>(at - fields.begin())] = bound;
  }
  if (filter.FinestInterfaceErrorBound > 0.0 || filter.FinestFieldErrorBound > 0.0)
  {
    options.finestBounds = this->bounds(filter.FinestInterfaceErrorBound, filter.FinestFieldErrorBound);
  }
  options.interest = this->interest(filter);
  options.errorMethod = static_cast<strata::ErrorMethod>(filter.ErrorMethod);
  if (filter.LimitCells)
  {
    checkAtLeast("MaximumNumberOfCells", filter.MaximumNumberOfCells, 1);
    options.maximumNumberOfCells = filter.MaximumNumberOfCells;
  }
  return options;
}

strata::EmitOptions vtkStrataTetrahedra::Internals::emission(const vtkStrataTetrahedra& filter) const
{
  strata::EmitOptions options;
  options.ghosts = filter.PassArrays == ALL;
  options.distances = filter.PassArrays != COMPOSITE_ONLY;
  options.perMaterialValues = filter.PassArrays != COMPOSITE_ONLY;
  return options;
}

void vtkStrataTetrahedra::Internals::report(const strata::Mesh& mesh)
{
  this->achieved = mesh.achieved;
  std::ostringstream text;
  for (std::size_t f = 0; f < mesh.achieved.fieldErrors.size() && f < mesh.fields.size(); ++f)
  {
    text << (f > 0 ? ", " : "") << mesh.fields[f].name << ": " << mesh.achieved.fieldErrors[f];
  }
  this->fieldErrorText = text.str();
}
