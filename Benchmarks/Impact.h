#pragma once

#include "Build/BuildOptions.h"
#include "Model/CopyMesh.h"
#include "Model/ErrorBounds.h"
#include "Model/Hierarchy.h"
#include "Model/Interfaces.h"
#include "Model/NativeData.h"
#include "Model/Simulation.h"

#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <vector>

namespace strata::benchmarks
{
/// The impact at t = 15 with 32, 64 or 128 cells along x: its materials and the field `density`.
struct Impact
{
  Simulation simulation;
  std::shared_ptr<const NativeData> native;
  Interfaces interfaces;
};

/// The resolutions whose raw files are there.
std::vector<int> availableSeries();
/// Reads the raw file of a resolution (export_grid.py); without native data and interfaces.
Simulation readImpact(int series);
/// Reads a resolution, its native data and its interfaces once; later calls return the same.
const Impact& impact(int series);

/// Interface error bound in length units, density bound in g/cm^3.
ErrorBounds bounds(double interfaceError, double density);

/// Registers a benchmark for each resolution at hand with one and with two threads: function(state, series).
void registerSeries(const std::string& name, void (*function)(benchmark::State&, int));

/// Counters that the stages report: cells, cells per second and bytes per cell (none for 0 bytes).
void countCells(benchmark::State& state, Index cells, std::size_t bytes);

/// How well the threads share the work: processor time of all threads over that of the calling one. On an idle machine
/// this is what they gain, and unlike the time that passes it can be read on a busy one.
class ThreadShare
{
public:
  ThreadShare();
  /// Sets the counter `share` for the work since construction.
  void report(benchmark::State& state) const;

private:
  double processSeconds_;
  double threadSeconds_;
};

/// Memory of what travels between the stages.
std::size_t bytesOf(const Hierarchy& hierarchy);

/// Largest resident memory of this process so far, MiB: that of one benchmark if it runs alone (--benchmark_filter).
double peakMebibytes();
}
