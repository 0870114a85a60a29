#include "Measure/Measure.h"

#include "Measure/FieldErrors.h"
#include "Measure/InterfaceErrors.h"
#include "Measure/MisclassifiedVolume.h"
#include "Measure/Requirements.h"

#include <algorithm>
#include <limits>

namespace strata
{
namespace
{
/// The values of the field named density, one array per material; empty if there is none.
std::vector<const float*> densityOf(const Representation& representation)
{
  const auto found = std::find_if(representation.fields.begin(), representation.fields.end(),
    [](const Field& field) { return field.name == "density" && field.components == 1; });
  return found == representation.fields.end()
           ? std::vector<const float*>()
           : representation.values[static_cast<std::size_t>(found - representation.fields.begin())];
}

std::vector<VolumeErrorReport> volumeReports(const RepresentedRegions& regions, const OriginalVolumes& volumes)
{
  std::vector<VolumeErrorReport> reports(regions.volumes.size());
  for (std::size_t m = 0; m < reports.size(); ++m)
  {
    reports[m].material = MaterialId(static_cast<Index>(m));
    reports[m].represented = regions.volumes[m];
    reports[m].original = volumes.volumes[m];
    reports[m].representedMass = regions.masses[m];
    reports[m].originalMass = volumes.masses.empty() ? std::numeric_limits<double>::quiet_NaN() : volumes.masses[m];
  }
  return reports;
}
}

RepresentationErrors measureRepresentation(const Representation& representation, const NativeData& native,
  const Interfaces& original, const OriginalVolumes& volumes, Progress& progress, double hausdorffTolerance)
{
  requireMeasurable(representation, native, original, volumes);
  progress.stage("Locate cells", 0.0, 0.1);
  const TetrahedronLocator locator(
    representation.points, representation.tetrahedra, representation.cellCount, [&progress] { progress.check(); });
  RepresentationErrors errors;
  progress.stage("Measure fields", 0.1, 0.4);
  errors.fields = measureFields(representation, native, locator, progress);
  progress.stage("Measure volumes", 0.4, 0.5);
  const RepresentedRegions regions = representedRegions(representation, densityOf(representation), progress);
  errors.volumes = volumeReports(regions, volumes);
  progress.stage("Measure interfaces", 0.5, 0.7);
  const double tolerance = hausdorffTolerance * locator.bounds().diagonal();
  errors.interfaces = measureInterfaces(representation, original, regions.surfaces, locator, tolerance, progress);
  progress.stage("Measure regions", 0.7, 0.8);
  errors.regions = measureRegions(original, regions.surfaces, errors.interfaces, tolerance, progress);
  progress.stage("Measure misclassified volume", 0.8, 1.0);
  const auto largest = std::max_element(volumes.volumes.begin(), volumes.volumes.end()) - volumes.volumes.begin();
  const OriginalMaterial truth(original, native.box(), MaterialId(largest));
  const VolumeEstimate misclassified = misclassifiedVolume(representation, truth, progress);
  errors.misclassifiedVolume = misclassified.volume;
  errors.misclassifiedVolumeError = misclassified.standardError;
  errors.misclassifiedNearGaps = misclassified.nearGaps;
  return errors;
}
}
