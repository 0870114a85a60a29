// Interfaces from volume fractions, with and without correction of the volumes.

#include "Extract/Extract.h"
#include "Impact.h"

using namespace strata;
using namespace strata::benchmarks;

namespace
{
void extract(benchmark::State& state, int series, bool volumeCorrection)
{
  const Simulation simulation = readImpact(series);
  ExtractOptions options;
  options.volumeCorrection = volumeCorrection;
  Progress progress;
  Index triangles = 0;
  const ThreadShare share;
  for (auto _ : state)
  {
    triangles = extractInterfaces(simulation, options, progress).interfaces.triangleCount();
  }
  share.report(state);
  const auto cells = static_cast<double>(cellCount(simulation.grid));
  state.counters["triangles"] = static_cast<double>(triangles);
  state.counters["native cells/s"] = benchmark::Counter(cells, benchmark::Counter::kIsIterationInvariantRate);
}

void extractCorrected(benchmark::State& state, int series)
{
  extract(state, series, true);
}

void extractUncorrected(benchmark::State& state, int series)
{
  extract(state, series, false);
}
}

int main(int argc, char** argv)
{
  registerSeries("extract/corrected", extractCorrected);
  registerSeries("extract/uncorrected", extractUncorrected);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
