#include "Pipeline.h"

#include "Build/HierarchyBuilder.h"
#include "Emit/MissingMaterials.h"
#include "FittedLevel.h"
#include "Model/Errors.h"
#include "Select/Front.h"
#include "Select/Saturate.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <tuple>

namespace strata
{
namespace
{
/// Shares of the progress bar.
constexpr double buildShare = 0.9;

void check(const SelectOptions& options, const std::vector<Field>& fields, const BuildOptions& build)
{
  const ErrorBounds& bounds = options.bounds;
  const Index rootCount = Index{ 6 } * build.baseCubes[0] * build.baseCubes[1] * build.baseCubes[2];
  if (options.maximumNumberOfCells < rootCount)
  {
    throw InvalidInput("the maximum number of cells is " + std::to_string(options.maximumNumberOfCells) +
                       "; the base mesh alone has " + std::to_string(rootCount));
  }
  if (!(bounds.interfaceError > 0.0))
  {
    throw InvalidInput(
      "the interface error bound is " + std::to_string(bounds.interfaceError) + "; it must be greater than zero");
  }
  if (bounds.fieldErrors.size() != fields.size())
  {
    throw InvalidInput("there are " + std::to_string(bounds.fieldErrors.size()) + " field error bounds for " +
                       std::to_string(fields.size()) + " fields");
  }
  for (std::size_t f = 0; f < fields.size(); ++f)
  {
    if (!(bounds.fieldErrors[f] > 0.0))
    {
      throw InvalidInput("the error bound of field '" + fields[f].name + "' is " +
                         std::to_string(bounds.fieldErrors[f]) + "; it must be greater than zero");
    }
  }
}

/// The bounds down to which saturated and accumulated errors look: never looser than the level's own.
ErrorBounds finestOf(const SelectOptions& select)
{
  ErrorBounds finest = select.bounds;
  if (select.finestBounds.interfaceError > 0.0)
  {
    finest.interfaceError = std::min(finest.interfaceError, select.finestBounds.interfaceError);
  }
  for (std::size_t f = 0; f < select.finestBounds.fieldErrors.size(); ++f)
  {
    const double bound = select.finestBounds.fieldErrors[f];
    finest.fieldErrors[f] = bound > 0.0 ? std::min(finest.fieldErrors[f], bound) : finest.fieldErrors[f];
  }
  return finest;
}

/// Positive floats are ordered as their bit patterns are.
std::uint32_t bitsOf(float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

float floatOf(std::uint32_t bits)
{
  float value = 0.0f;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// The smallest scale of at least one at which fits(scale) holds, which must be monotone and hold at the
/// largest float.
template<typename Fits>
double smallestScale(const Fits& fits)
{
  std::uint32_t low = bitsOf(1.0f);
  std::uint32_t high = bitsOf(std::numeric_limits<float>::max());
  while (low < high)
  {
    const std::uint32_t middle = low + (high - low) / 2;
    const bool enough = fits(static_cast<double>(floatOf(middle)));
    high = enough ? middle : high;
    low = enough ? low : middle + 1;
  }
  return static_cast<double>(floatOf(high));
}

ErrorBounds scaled(ErrorBounds bounds, double scale)
{
  bounds.interfaceError *= scale;
  for (double& bound : bounds.fieldErrors)
  {
    bound *= scale;
  }
  return bounds;
}

/// Values are stored as floats: no bound can be met below a few of their steps.
constexpr double resolution = 4.0 * static_cast<double>(std::numeric_limits<float>::epsilon());

/// The bounds, but for those that no refinement could meet.
ErrorBounds attainable(ErrorBounds bounds, const NativeData& native)
{
  bounds.interfaceError = std::max(bounds.interfaceError, resolution * native.box().diagonal());
  for (std::size_t f = 0; f < bounds.fieldErrors.size(); ++f)
  {
    const double smallest = resolution * native.magnitude(FieldId(static_cast<Index>(f)));
    bounds.fieldErrors[f] = std::max(bounds.fieldErrors[f], smallest);
  }
  return bounds;
}

bool meets(const Achieved& achieved, const ErrorBounds& bounds)
{
  bool result = achieved.interfaceError <= bounds.interfaceError;
  for (std::size_t f = 0; f < bounds.fieldErrors.size(); ++f)
  {
    result = result && achieved.fieldErrors[f] <= bounds.fieldErrors[f];
  }
  return result;
}

/// Says why a level that refinement took for finished does not meet the bounds.
std::string reasonOf(const Achieved& achieved, const ErrorBounds& attainableBounds, bool everywhere)
{
  return everywhere && meets(achieved, attainableBounds) ? "resolution of the stored values" : "maximum level";
}

/// The values that the vertices lack, as they would be if a cell round them held the material.
std::vector<ExtraValues> extraValues(
  const HierarchyBuilder& builder, const std::vector<MissingMaterial>& missing, Progress& progress)
{
  std::vector<ExtraValues> extra(missing.size());
  tbb::parallel_for(std::size_t{ 0 }, missing.size(), [&](std::size_t i) {
    progress.check();
    extra[i] = { missing[i].vertex, missing[i].material, builder.valuesAt(missing[i].vertex, missing[i].material) };
  });
  return extra;
}

/// Gives vertices the materials that win on a face of a cell which holds none of them, so that no region ends at
/// a face.
void closeRegions(
  const HierarchyBuilder& builder, const Hierarchy& values, Level& level, LevelCells& cells, Progress& progress)
{
  std::vector<std::uint8_t> changed;
  for (;;)
  {
    const std::vector<MissingMaterial> missing = missingMaterials(values, level, cells, changed, progress);
    if (missing.empty())
    {
      return;
    }
    changed.assign(cells.vertices.size(), 0);
    for (const MissingMaterial& m : missing)
    {
      cells.needs[static_cast<std::size_t>(m.number)].insert(m.material);
      changed[static_cast<std::size_t>(m.number)] = 1;
    }
    std::vector<ExtraValues> extra = extraValues(builder, missing, progress);
    const auto known = static_cast<std::ptrdiff_t>(level.extra.size());
    level.extra.insert(level.extra.end(), std::make_move_iterator(extra.begin()), std::make_move_iterator(extra.end()));
    std::inplace_merge(level.extra.begin(), level.extra.begin() + known, level.extra.end(),
      [](const ExtraValues& a, const ExtraValues& b) {
        return std::tie(a.vertex, a.material) < std::tie(b.vertex, b.material);
      });
  }
}

/// Closes the regions of a level and writes it.
Mesh emitClosed(const HierarchyBuilder& builder, const Hierarchy& values, Level& level, const EmitOptions& emitted,
  Progress& progress)
{
  progress.stage("Writing the mesh", buildShare, 1.0);
  LevelCells cells = levelCells(values, level, progress);
  closeRegions(builder, values, level, cells, progress);
  return emitMesh(values, level, std::move(cells), emitted, progress);
}

/// Fitting serves levels by bounds; a budget, a region or a view takes the direct method.
bool isFitted(const SelectOptions& options)
{
  return options.errorMethod == ErrorMethod::Fitted && options.interest.everything() &&
         options.maximumNumberOfCells == std::numeric_limits<Index>::max();
}
}

struct Multiresolution::State
{
  std::shared_ptr<const NativeData> native;
  Interfaces interfaces;
  BuildOptions options;
  std::unique_ptr<HierarchyBuilder> builder;

  const Hierarchy& hierarchy() const { return builder->hierarchy(); }
  void grow(Front& front, const Criterion& criterion, double scale, Index maximumNumberOfCells, Progress& progress);
  Level select(const SelectOptions& select, Progress& progress);
  Level selectDirect(const SelectOptions& select, Progress& progress);
  Level selectWithinFinest(const SelectOptions& select, Progress& progress);
  Mesh emitSelected(const SelectOptions& select, const EmitOptions& emitted, Progress& progress);
  Mesh emitFitted(const SelectOptions& select, const EmitOptions& emitted, Progress& progress);
};

void Multiresolution::State::grow(
  Front& front, const Criterion& criterion, double scale, Index maximumNumberOfCells, Progress& progress)
{
  for (int round = 1;; ++round)
  {
    const std::vector<DiamondId> missing = front.advance(hierarchy(), criterion, scale, maximumNumberOfCells);
    if (missing.empty() || front.cellCount() > maximumNumberOfCells)
    {
      return;
    }
    builder->split(missing, progress);
    // The number of rounds is not known beforehand: each does a share of what is left.
    progress.update(1.0 - std::exp(-0.1 * round));
  }
}

Level Multiresolution::State::selectDirect(const SelectOptions& select, Progress& progress)
{
  const Criterion criterion(select.bounds, select.interest, options.maximumLevel);
  const bool everythingFits = select.maximumNumberOfCells == std::numeric_limits<Index>::max();
  const bool resumable = !everythingFits || !select.interest.everything();
  Front fitting(hierarchy(), resumable);
  const auto fits = [&](double scale) {
    Front finer = fitting;
    grow(finer, criterion, scale, select.maximumNumberOfCells, progress);
    const bool enough = finer.cellCount() <= select.maximumNumberOfCells;
    if (enough)
    {
      fitting = std::move(finer);
    }
    return enough;
  };
  const bool limited = !fits(1.0);
  if (limited)
  {
    smallestScale(fits);
  }
  Level level = fitting.level(hierarchy());
  level.achieved.boundMet = !resumable || fitting.meetsBounds(hierarchy());
  level.achieved.stoppedBy = limited ? "maximum number of cells" : "bounds met";
  return level;
}

Level Multiresolution::State::selectWithinFinest(const SelectOptions& select, Progress& progress)
{
  SelectOptions finestOptions = select;
  finestOptions.bounds = attainable(finestOf(select), *native);
  finestOptions.maximumNumberOfCells = std::numeric_limits<Index>::max();
  const Level finest = selectDirect(finestOptions, progress);
  const bool accumulate = select.errorMethod == ErrorMethod::Accumulated;
  const auto at = [&](double scale) {
    return selectSaturated(hierarchy(), finest, scaled(select.bounds, scale), accumulate);
  };
  Level level = at(1.0);
  level.achieved.stoppedBy = "bounds met";
  if (level.cellCount > select.maximumNumberOfCells)
  {
    level = at(smallestScale([&](double scale) { return at(scale).cellCount <= select.maximumNumberOfCells; }));
    level.achieved.stoppedBy = "maximum number of cells";
  }
  return level;
}

Level Multiresolution::State::select(const SelectOptions& select, Progress& progress)
{
  if (!select.interest.everything())
  {
    return selectDirect(select, progress);
  }
  switch (select.errorMethod)
  {
    case ErrorMethod::Direct:
      return selectDirect(select, progress);
    case ErrorMethod::Saturated:
    case ErrorMethod::Accumulated:
      return selectWithinFinest(select, progress);
    case ErrorMethod::Fitted:
      return selectDirect(select, progress);
  }
  return {};
}

Mesh Multiresolution::State::emitSelected(const SelectOptions& chosen, const EmitOptions& emitted, Progress& progress)
{
  Level level = select(chosen, progress);
  builder->arrange(level);
  return emitClosed(*builder, hierarchy(), level, emitted, progress);
}

Mesh Multiresolution::State::emitFitted(const SelectOptions& select, const EmitOptions& emitted, Progress& progress)
{
  FitOptions fit;
  fit.maximumLevel = options.maximumLevel;
  FittedLevel fitted = fitLevel(*builder, select.bounds, fit, progress);
  fitted.level.achieved.stoppedBy = "bounds met";
  return emitClosed(*builder, fitted.values, fitted.level, emitted, progress);
}

Multiresolution::Multiresolution(
  std::shared_ptr<const NativeData> native, Interfaces interfaces, const BuildOptions& options) :
  state_(new State{ std::move(native), std::move(interfaces), options, nullptr })
{}

Multiresolution::~Multiresolution() = default;
Multiresolution::Multiresolution(Multiresolution&&) noexcept = default;
Multiresolution& Multiresolution::operator=(Multiresolution&&) noexcept = default;

const Hierarchy* Multiresolution::hierarchy() const
{
  return state_->builder ? &state_->builder->hierarchy() : nullptr;
}

Mesh Multiresolution::level(const SelectOptions& options, Progress& progress, const EmitOptions& emitted)
{
  check(options, state_->native->fields(), state_->options);
  SelectOptions attained = options;
  attained.bounds = attainable(options.bounds, *state_->native);
  try
  {
    progress.stage("Refining", 0.0, buildShare);
    if (!state_->builder)
    {
      state_->builder =
        std::make_unique<HierarchyBuilder>(state_->native, state_->interfaces, state_->options, progress);
    }
    Mesh mesh = isFitted(attained) ? state_->emitFitted(attained, emitted, progress)
                                   : state_->emitSelected(attained, emitted, progress);
    if (options.interest.everything())
    {
      mesh.achieved.boundMet = meets(mesh.achieved, options.bounds);
    }
    if (!mesh.achieved.boundMet && mesh.achieved.stoppedBy == "bounds met")
    {
      mesh.achieved.stoppedBy = reasonOf(mesh.achieved, attained.bounds, options.interest.everything());
    }
    return mesh;
  }
  catch (...)
  {
    // A computation that stopped halfway leaves nothing that can be gone on with.
    state_->builder.reset();
    throw;
  }
}
}
