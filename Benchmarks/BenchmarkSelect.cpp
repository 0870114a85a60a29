// Choosing a level in a hierarchy that has been built: what a slider's move costs before the mesh is written.

#include "Levels.h"
#include "Select/Saturate.h"

using namespace strata;
using namespace strata::benchmarks;

namespace
{
/// A hierarchy built down to the fine bounds, and the level that meets them.
struct Built
{
  HierarchyBuilder builder;
  Level finest;
};

Built built(int series, Progress& progress)
{
  const Impact& data = impact(series);
  HierarchyBuilder builder(data.native, data.interfaces, {}, progress);
  Level finest = buildLevel(builder, bounds(fine.interfaceError, fine.density), progress);
  return { std::move(builder), std::move(finest) };
}

void selectDirect(benchmark::State& state, int series)
{
  Progress progress;
  Built data = built(series, progress);
  Index cells = 0;
  const ThreadShare share;
  for (auto _ : state)
  {
    cells = buildLevel(data.builder, bounds(fine.interfaceError, fine.density), progress).cellCount;
  }
  share.report(state);
  countCells(state, cells, data.finest.active.size());
}

void selectNested(benchmark::State& state, int series, bool accumulate)
{
  Progress progress;
  const Built data = built(series, progress);
  const ErrorBounds wanted = bounds(2.0 * fine.interfaceError, 2.0 * fine.density);
  Index cells = 0;
  const ThreadShare share;
  for (auto _ : state)
  {
    cells = selectSaturated(
      data.builder.hierarchy(), data.finest, data.builder.hierarchy().interfaceErrors, wanted, accumulate)
              .cellCount;
  }
  share.report(state);
  countCells(state, cells, data.finest.active.size());
}

void selectSaturatedLevel(benchmark::State& state, int series)
{
  selectNested(state, series, false);
}

void selectAccumulatedLevel(benchmark::State& state, int series)
{
  selectNested(state, series, true);
}
}

int main(int argc, char** argv)
{
  registerSeries("select/direct", selectDirect);
  registerSeries("select/saturated", selectSaturatedLevel);
  registerSeries("select/accumulated", selectAccumulatedLevel);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
