// The paper's choices beside Strata's own at equal bounds, on the impact (the target `compare` runs it).

#include "Extract/Extract.h"
#include "Impact.h"
#include "Native/ReadNativeData.h"
#include "Pipeline.h"

#include <cstdio>
#include <ctime>
#include <map>
#include <string>

using namespace strata;
using namespace strata::benchmarks;

namespace
{
struct Choices
{
  const char* name;
  DistanceMethod distance;
  GhostMethod ghost;
  ErrorMethod error;
  /// How much tighter than the level's bounds the hierarchy is built: nested errors look that deep.
  double depth = 1.0;
  NativeElements elements = NativeElements::Points;
  std::array<int, 3> baseCubes = { 1, 1, 1 };
  /// One field over all materials, as a refinement that knows of none would see it.
  bool separated = true;
};

constexpr auto paperDistance = DistanceMethod::ClosestVertex;
constexpr auto paperGhosts = GhostMethod::Constant;
constexpr auto ownDistance = DistanceMethod::ClosestPoint;
constexpr auto ownGhosts = GhostMethod::DataThenLinear;
constexpr Choices all[] = {
  { "paper", paperDistance, paperGhosts, ErrorMethod::Accumulated },
  { "paper, hierarchy 3x finer", paperDistance, paperGhosts, ErrorMethod::Accumulated, 3.0 },
  { "closest point, constant", ownDistance, paperGhosts, ErrorMethod::Direct },
  { "closest point, linear", ownDistance, GhostMethod::Linear, ErrorMethod::Direct },
  { "Strata", ownDistance, ownGhosts, ErrorMethod::Direct },
  { "Strata fitted", ownDistance, ownGhosts, ErrorMethod::Fitted },
  { "Strata saturated, 3x finer", ownDistance, ownGhosts, ErrorMethod::Saturated, 3.0 },
  { "Strata accumulated, 3x finer", ownDistance, ownGhosts, ErrorMethod::Accumulated, 3.0 },
  { "certified", ownDistance, ownGhosts, ErrorMethod::Direct, 1.0, NativeElements::Cells },
  { "certified, constant ghosts", ownDistance, paperGhosts, ErrorMethod::Direct, 1.0, NativeElements::Cells },
  { "certified, linear ghosts", ownDistance, GhostMethod::Linear, ErrorMethod::Direct, 1.0, NativeElements::Cells },
  { "certified, 2x2x3 base cubes", ownDistance, ownGhosts, ErrorMethod::Direct, 1.0, NativeElements::Cells,
    { 2, 2, 3 } },
  { "certified, fitted", ownDistance, ownGhosts, ErrorMethod::Fitted, 1.0, NativeElements::Cells },
  { "certified, saturated, 2x finer", ownDistance, ownGhosts, ErrorMethod::Saturated, 2.0, NativeElements::Cells },
  { "no separation of materials", ownDistance, ownGhosts, ErrorMethod::Direct, 1.0, NativeElements::Points, { 1, 1, 1 },
    false },
};

/// The paper's choices never meet some bounds at points: cells stop here, 2^10 times finer along each edge than the
/// box.
constexpr int maximumLevel = 30;

struct Outcome
{
  Index cells;
  double seconds; ///< processor time of all threads
  Achieved achieved;
};

/// The same grid as one material, with the mean density of each cell.
std::shared_ptr<const NativeData> withoutMaterials(const Impact& data)
{
  Simulation simulation = data.simulation;
  const ValueArray projectile = simulation.fields[0].values[0];
  const ValueArray block = simulation.fields[0].values[1];
  auto mixed = std::make_shared<std::vector<double>>();
  for (Index cell = 0; cell < std::get<RectilinearGrid>(simulation.grid).cellCount(); ++cell)
  {
    mixed->push_back(simulation.fractions[0](cell) * projectile(cell) + simulation.fractions[1](cell) * block(cell));
  }
  const auto count = static_cast<Index>(mixed->size());
  simulation.materials = { { "all", true } };
  simulation.fields[0].values = { ValueArray(mixed->data(), count, 1, mixed) };
  const auto ones = std::make_shared<std::vector<double>>(mixed->size(), 1.0);
  simulation.fractions = { ValueArray(ones->data(), count, 1, ones) };
  Progress progress;
  return readNativeData(simulation, {}, progress);
}

Outcome run(const Impact& data, const Interfaces& interfaces, const Choices& choices, const ErrorBounds& wanted)
{
  BuildOptions build;
  build.nativeElements = choices.elements;
  build.baseCubes = choices.baseCubes;
  if (choices.elements == NativeElements::Points)
  {
    build.maximumLevel = maximumLevel;
  }
  build.distanceMethod = choices.distance;
  build.ghostMethod = choices.ghost;
  SelectOptions select;
  select.bounds = wanted;
  select.finestBounds = bounds(wanted.interfaceError / choices.depth, wanted.fieldErrors.front() / choices.depth);
  select.errorMethod = choices.error;
  Progress progress;
  const std::clock_t start = std::clock();
  const Mesh mesh = choices.separated
                      ? Multiresolution(data.native, interfaces, build).level(select, progress)
                      : Multiresolution(withoutMaterials(data), Interfaces(), build).level(select, progress);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return { mesh.cellCount(), seconds, mesh.achieved };
}

/// What bounds over whole cells cost beside bounds at points, both timed in this run.
void showCostOfCertainty(const std::map<std::string, Outcome>& outcomes)
{
  for (const auto& [certified, points] : { std::pair("certified", "Strata"), { "certified, fitted", "Strata fitted" } })
  {
    const Outcome& dear = outcomes.at(certified);
    const Outcome& cheap = outcomes.at(points);
    const double times = dear.seconds / cheap.seconds;
    std::printf("%s: %.1f times the time of \"%s\", %.1f times per cell\n", certified, times, points,
      times * static_cast<double>(cheap.cells) / static_cast<double>(dear.cells));
  }
}

void compare(const Impact& data, const Interfaces& interfaces, const ErrorBounds& wanted)
{
  std::printf("\ninterface bound %g, density bound %g\n", wanted.interfaceError, wanted.fieldErrors.front());
  std::printf("%-30s %10s %9s %10s %9s %9s  %s\n", "choices", "cells", "of paper", "interface", "density", "seconds",
    "stopped by");
  double ofPaper = 0.0;
  std::map<std::string, Outcome> outcomes;
  for (const Choices& choices : all)
  {
    const Outcome outcome = run(data, interfaces, choices, wanted);
    const auto cells = static_cast<double>(outcome.cells);
    ofPaper = ofPaper > 0.0 ? ofPaper : cells;
    std::printf("%-30s %10.0f %9.3f %10.4f %9.4f %9.3f  %s\n", choices.name, cells, cells / ofPaper,
      outcome.achieved.interfaceError, outcome.achieved.fieldErrors.front(), outcome.seconds,
      outcome.achieved.stoppedBy.c_str());
    outcomes[choices.name] = outcome;
  }
  showCostOfCertainty(outcomes);
}
}

/// Arguments: the resolution, 32 by default; then an interface and a density bound in place of the usual three pairs.
int main(int argc, char** argv)
{
  const int series = argc > 1 ? std::stoi(argv[1]) : 32;
  const Impact& data = impact(series);
  std::vector<ErrorBounds> levels = { bounds(0.15, 3.0), bounds(0.15, 0.3), bounds(0.05, 0.5) };
  if (argc > 3)
  {
    levels = { bounds(std::stod(argv[2]), std::stod(argv[3])) };
  }
  Progress progress;
  for (const bool corrected : { false, true })
  {
    ExtractOptions options;
    options.volumeCorrection = corrected;
    const Interfaces interfaces = extractInterfaces(data.simulation, options, progress).interfaces;
    std::printf("\nimpact %d, interfaces from fractions %s: %ld triangles\n", series,
      corrected ? "with corrected volumes" : "on the dual grid (the paper's way)",
      static_cast<long>(interfaces.triangleCount()));
    for (const ErrorBounds& wanted : levels)
    {
      compare(data, interfaces, wanted);
    }
  }
}
