#include "Impact.h"

#include "Extract/Extract.h"
#include "Native/ReadNativeData.h"

#include <sys/resource.h>
#include <tbb/global_control.h>

#include <array>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>

namespace strata::benchmarks
{
namespace
{
std::string fileOf(int series)
{
  return STRATA_BENCHMARK_DATA "/impact_" + std::to_string(series) + "_04.raw";
}

template<typename T>
void read(std::ifstream& file, T* values, Index count)
{
  const auto bytes = static_cast<std::streamsize>(sizeof(T)) * count;
  if (!file.read(reinterpret_cast<char*>(values), bytes))
  {
    throw std::runtime_error("a raw file ends early");
  }
}

ValueArray readCellArray(std::ifstream& file, Index cells)
{
  auto values = std::make_shared<std::vector<float>>(cells);
  read(file, values->data(), cells);
  return { values->data(), cells, 1, values };
}

double secondsOf(clockid_t clock)
{
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

template<typename T>
std::size_t bytes(const std::vector<T>& values)
{
  return values.capacity() * sizeof(T);
}
}

std::vector<int> availableSeries()
{
  std::vector<int> result;
  for (const int series : { 32, 64, 128 })
  {
    if (std::filesystem::exists(fileOf(series)))
    {
      result.push_back(series);
    }
  }
  return result;
}

Simulation readImpact(int series)
{
  std::ifstream file(fileOf(series), std::ios::binary);
  std::array<std::int64_t, 3> points{};
  read(file, points.data(), 3);
  RectilinearGrid grid;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    grid.coordinates[axis].resize(static_cast<std::size_t>(points[axis]));
    read(file, grid.coordinates[axis].data(), points[axis]);
  }
  const Index cells = grid.cellCount();
  Simulation simulation;
  simulation.grid = std::move(grid);
  simulation.materials = { { "projectile", true }, { "block", true }, { "empty", false } };
  for (std::size_t m = 0; m < simulation.materials.size(); ++m)
  {
    simulation.fractions.push_back(readCellArray(file, cells));
  }
  const ValueArray projectile = readCellArray(file, cells);
  const ValueArray block = readCellArray(file, cells);
  simulation.fields = { { "density", 1, Association::Cells, { projectile, block, ValueArray() } } };
  return simulation;
}

const Impact& impact(int series)
{
  static std::map<int, Impact> known;
  const auto [place, isNew] = known.try_emplace(series);
  Impact& result = place->second;
  if (isNew)
  {
    Progress progress;
    result.simulation = readImpact(series);
    result.native = readNativeData(result.simulation, {}, progress);
    result.interfaces = extractInterfaces(result.simulation, {}, progress).interfaces;
  }
  return result;
}

ErrorBounds bounds(double interfaceError, double density)
{
  return { interfaceError, { density } };
}

void registerSeries(const std::string& name, void (*function)(benchmark::State&, int))
{
  for (const int series : availableSeries())
  {
    for (const int threads : { 1, 2 })
    {
      const std::string fullName = name + "/impact:" + std::to_string(series) + "/threads:" + std::to_string(threads);
      const auto run = [=](benchmark::State& state) {
        const tbb::global_control limit(
          tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
        function(state, series);
      };
      // The processor time of all threads shows how well they share the work even on a busy machine.
      benchmark::RegisterBenchmark(fullName.c_str(), run)
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
    }
  }
}

void countCells(benchmark::State& state, Index cells, std::size_t bytes)
{
  const auto count = static_cast<double>(cells);
  state.counters["cells"] = count;
  state.counters["cells/s"] = benchmark::Counter(count, benchmark::Counter::kIsIterationInvariantRate);
  if (bytes > 0)
  {
    state.counters["bytes/cell"] = static_cast<double>(bytes) / count;
  }
}

ThreadShare::ThreadShare() :
  processSeconds_(secondsOf(CLOCK_PROCESS_CPUTIME_ID)), threadSeconds_(secondsOf(CLOCK_THREAD_CPUTIME_ID))
{}

void ThreadShare::report(benchmark::State& state) const
{
  const double process = secondsOf(CLOCK_PROCESS_CPUTIME_ID) - processSeconds_;
  state.counters["share"] = process / (secondsOf(CLOCK_THREAD_CPUTIME_ID) - threadSeconds_);
}

std::size_t bytesOf(const Hierarchy& hierarchy)
{
  // The table of diamonds holds an id for each slot, half of them taken at most.
  const std::size_t table = 2 * hierarchy.diamonds.size() * sizeof(DiamondId);
  return bytes(hierarchy.cells) + bytes(hierarchy.cellMaterials) + bytes(hierarchy.interfaceErrors) +
         bytes(hierarchy.fieldErrors) + bytes(hierarchy.diamonds) + table + bytes(hierarchy.vertices) +
         bytes(hierarchy.vertexMaterials) + bytes(hierarchy.valueOffsets) + bytes(hierarchy.values);
}

double peakMebibytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}
}
