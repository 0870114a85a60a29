// Growing the hierarchy until its direct level meets the bounds, from native data and interfaces at hand.

#include "Levels.h"

using namespace strata;
using namespace strata::benchmarks;

namespace
{
void build(benchmark::State& state, int series, const NamedBounds& wanted)
{
  const Impact& data = impact(series);
  Progress progress;
  Index cells = 0;
  Index levelCells = 0;
  std::size_t bytes = 0;
  const ThreadShare share;
  for (auto _ : state)
  {
    HierarchyBuilder builder(data.native, data.interfaces, {}, progress);
    levelCells = buildLevel(builder, bounds(wanted.interfaceError, wanted.density), progress).cellCount;
    cells = static_cast<Index>(builder.hierarchy().cells.size());
    bytes = bytesOf(builder.hierarchy());
  }
  share.report(state);
  countCells(state, cells, bytes);
  state.counters["level cells"] = static_cast<double>(levelCells);
  state.counters["native cells"] = static_cast<double>(cellCount(data.simulation.grid));
  state.counters["peak MiB"] = peakMebibytes();
}

void buildCoarse(benchmark::State& state, int series)
{
  build(state, series, coarse);
}

void buildFine(benchmark::State& state, int series)
{
  build(state, series, fine);
}
}

int main(int argc, char** argv)
{
  registerSeries(std::string("build") + coarse.name, buildCoarse);
  registerSeries(std::string("build") + fine.name, buildFine);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
