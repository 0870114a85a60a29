#include "Pipeline.h"

#include "Bounds.h"
#include "Build/HierarchyBuilder.h"
#include "CloseRegions.h"
#include "FittedLevel.h"
#include "InterfaceCertificate.h"
#include "KeptLevels.h"
#include "Model/CopyMesh.h"
#include "Select/Front.h"
#include "Select/Saturate.h"

#include <cmath>

namespace strata
{
namespace
{
/// Shares of the progress bar.
constexpr double buildShare = 0.9;
/// Fitted levels that are kept take no more: some four million cells.
constexpr std::size_t mostKeptBytes = std::size_t{ 256 } << 20;

/// A level of the hierarchy, and what is known of its interfaces.
struct Selection
{
  Level level;
  std::unique_ptr<InterfaceCertificate> certificate; ///< null where errors are taken at points
  /// Cells that were split for what the certificate found, with the error found.
  std::vector<std::pair<CellId, double>> raised;
};

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
  std::shared_ptr<PreparedInterfaces> interfaces;
  BuildOptions options;
  std::unique_ptr<HierarchyBuilder> builder;
  KeptLevels fittedLevels{ mostKeptBytes };

  const Hierarchy& hierarchy() const { return builder->hierarchy(); }
  bool isCertified() const { return options.nativeElements == NativeElements::Cells; }
  const InterfaceTrees* certifiedAgainst() const;
  void grow(Front& front, const Criterion& criterion, double scale, Index maximumNumberOfCells, Progress& progress);
  void split(Front& front, const std::vector<CellId>& cells, Progress& progress);
  Selection select(const SelectOptions& select, Progress& progress);
  Selection selectDirect(const SelectOptions& select, Progress& progress);
  Selection selectWithinFinest(const SelectOptions& select, Progress& progress);
  void certify(Selection& selection, const Criterion& criterion, Progress& progress);
  bool refineInterfaces(
    Front& front, const Criterion& criterion, Index maximumNumberOfCells, Selection& selection, Progress& progress);
  static void complete(
    InterfaceCertificate* certificate, const Hierarchy& values, Achieved& achieved, Progress& progress);
  Mesh emitSelected(const SelectOptions& select, const EmitOptions& emitted, Progress& progress);
  Mesh emitFitted(const SelectOptions& select, const EmitOptions& emitted, Progress& progress);
};

/// The original interfaces where they are certified, else null.
const InterfaceTrees* Multiresolution::State::certifiedAgainst() const
{
  return isCertified() ? &interfaces->trees() : nullptr;
}

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

void Multiresolution::State::split(Front& front, const std::vector<CellId>& cells, Progress& progress)
{
  for (std::vector<DiamondId> missing = front.split(hierarchy(), cells); !missing.empty();
       missing = front.split(hierarchy(), cells))
  {
    builder->split(missing, progress);
  }
}

/// Measures the interfaces of a level both ways, where that is asked for.
void Multiresolution::State::certify(Selection& selection, const Criterion& criterion, Progress& progress)
{
  if (!isCertified())
  {
    return;
  }
  if (!selection.certificate)
  {
    selection.certificate = std::make_unique<InterfaceCertificate>(*builder, *certifiedAgainst(), criterion);
  }
  selection.certificate->measure(hierarchy(), selection.level, progress);
}

/// Splits cells whose interfaces are too far from the original ones, or the originals from them, until there are none;
/// false if that takes too many cells. The rounds follow from the first mesh, so the result depends on the options
/// alone.
bool Multiresolution::State::refineInterfaces(
  Front& front, const Criterion& criterion, Index maximumNumberOfCells, Selection& selection, Progress& progress)
{
  for (;;)
  {
    selection.level = front.level(hierarchy());
    certify(selection, criterion, progress);
    const std::vector<CellId> tooCoarse =
      isCertified() ? selection.certificate->tooCoarse(hierarchy()) : std::vector<CellId>();
    if (tooCoarse.empty())
    {
      return true;
    }
    Front finer = front;
    split(finer, tooCoarse, progress);
    grow(finer, criterion, 1.0, maximumNumberOfCells, progress);
    if (finer.cellCount() > maximumNumberOfCells)
    {
      return false;
    }
    for (const CellId cell : tooCoarse)
    {
      selection.raised.push_back({ cell, selection.certificate->error(cell) });
    }
    front = std::move(finer);
  }
}

Selection Multiresolution::State::selectDirect(const SelectOptions& select, Progress& progress)
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
  Selection selection;
  bool limited = !fits(1.0);
  if (limited)
  {
    smallestScale(fits);
    selection.level = fitting.level(hierarchy());
    certify(selection, criterion, progress);
  }
  else
  {
    limited = !refineInterfaces(fitting, criterion, select.maximumNumberOfCells, selection, progress);
  }
  Achieved& achieved = selection.level.achieved;
  achieved.boundMet =
    (!resumable || fitting.meetsBounds(hierarchy())) && (!selection.certificate || selection.certificate->boundsHold());
  achieved.stoppedBy = limited ? "maximum number of cells" : "bounds met";
  return selection;
}

Selection Multiresolution::State::selectWithinFinest(const SelectOptions& select, Progress& progress)
{
  SelectOptions finestOptions = select;
  finestOptions.bounds = attainable(finestOf(select), *native);
  finestOptions.maximumNumberOfCells = std::numeric_limits<Index>::max();
  const Selection finest = selectDirect(finestOptions, progress);
  std::vector<float> interfaceErrors = hierarchy().interfaceErrors;
  for (const auto& [cell, error] : finest.raised)
  {
    interfaceErrors[static_cast<std::size_t>(cell.value)] = roundedUp(error);
  }
  const bool accumulate = select.errorMethod == ErrorMethod::Accumulated;
  const auto at = [&](double scale) {
    return selectSaturated(hierarchy(), finest.level, interfaceErrors, scaled(select.bounds, scale), accumulate);
  };
  Selection selection;
  selection.level = at(1.0);
  const bool limited = selection.level.cellCount > select.maximumNumberOfCells;
  if (limited)
  {
    selection.level =
      at(smallestScale([&](double scale) { return at(scale).cellCount <= select.maximumNumberOfCells; }));
  }
  certify(selection, Criterion(select.bounds, {}, options.maximumLevel), progress);
  // The finest level has done what can be done.
  const bool holds = !selection.certificate || selection.certificate->boundsHold() ||
                     selection.level.cellCount == finest.level.cellCount;
  selection.level.achieved.stoppedBy = limited ? "maximum number of cells" : holds ? "bounds met" : "nested errors";
  return selection;
}

Selection Multiresolution::State::select(const SelectOptions& select, Progress& progress)
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

/// Brings the certificate to its end, before ids may change.
void Multiresolution::State::complete(
  InterfaceCertificate* certificate, const Hierarchy& values, Achieved& achieved, Progress& progress)
{
  if (certificate)
  {
    certificate->complete(progress);
    if (achieved.stoppedBy == "bounds met" && certificate->leavesThinParts(values))
    {
      achieved.stoppedBy = "parts of interfaces too thin for the bound";
    }
  }
}

Mesh Multiresolution::State::emitSelected(const SelectOptions& chosen, const EmitOptions& emitted, Progress& progress)
{
  Selection selection = select(chosen, progress);
  complete(selection.certificate.get(), hierarchy(), selection.level.achieved, progress);
  // Ids change, and regions are closed again.
  selection.level.extra.clear();
  builder->arrange(selection.level, progress);
  Mesh mesh = emitClosed(*builder, hierarchy(), selection.level, emitted, progress);
  if (selection.certificate)
  {
    selection.certificate->writeErrors(mesh);
  }
  return mesh;
}

Mesh Multiresolution::State::emitFitted(const SelectOptions& select, const EmitOptions& emitted, Progress& progress)
{
  const KeptLevels::Key key{ select.bounds, emitted };
  if (const Mesh* kept = fittedLevels.find(key))
  {
    return copyOf(*kept);
  }
  FitOptions fit;
  fit.maximumLevel = options.maximumLevel;
  FittedLevel fitted = fitLevel(*builder, certifiedAgainst(), select.bounds, fit, progress);
  fitted.level.achieved.stoppedBy = "bounds met";
  complete(fitted.certificate.get(), fitted.values, fitted.level.achieved, progress);
  Mesh mesh = emitClosed(*builder, fitted.values, fitted.level, emitted, progress);
  if (fitted.certificate)
  {
    fitted.certificate->writeErrors(mesh);
  }
  fittedLevels.keep(key, mesh);
  return mesh;
}

Multiresolution::Multiresolution(
  std::shared_ptr<const NativeData> native, Interfaces interfaces, const BuildOptions& options) :
  Multiresolution(std::move(native), std::make_shared<PreparedInterfaces>(std::move(interfaces)), options)
{}

Multiresolution::Multiresolution(std::shared_ptr<const NativeData> native,
  std::shared_ptr<PreparedInterfaces> interfaces, const BuildOptions& options) :
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
      state_->builder = std::make_unique<HierarchyBuilder>(state_->native,
        state_->interfaces->geometry(*state_->native, state_->options.distanceMethod), state_->options, progress);
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
