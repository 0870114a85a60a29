// Slicing the impact: the first slice of a mesh, which makes the search structure, and a dragged plane's.

#include "Emit/Emit.h"
#include "Levels.h"
#include "Slice/Slice.h"
#include "Slice/SliceIndex.h"

using namespace strata;
using namespace strata::benchmarks;

namespace
{
Mesh fineMesh(int series, Progress& progress)
{
  const Impact& data = impact(series);
  HierarchyBuilder builder(data.native, data.interfaces, {}, progress);
  const Level level = buildLevel(builder, bounds(fine.interfaceError, fine.density), progress);
  return emitMesh(builder.hierarchy(), level, levelCells(builder.hierarchy(), level, progress), {}, progress);
}

const SlicePlane askew{ Vector(4.0, 4.0, -6.0), Vector(0.4, 0.9, 0.15), 0.0 };

MaterialSet withFields()
{
  MaterialSet result = MaterialSet::of(MaterialId(0));
  result.insert(MaterialId(1));
  return result;
}

void dragged(benchmark::State& state, int series)
{
  Progress progress;
  const Mesh mesh = fineMesh(series, progress);
  const SliceIndex index(view(mesh), progress);
  Index polygons = 0;
  const ThreadShare share;
  for (auto _ : state)
  {
    polygons = slice(view(mesh), askew, withFields(), &index, progress).material.size();
  }
  share.report(state);
  countCells(state, mesh.cellCount(), 0);
  state.counters["polygons"] = static_cast<double>(polygons);
}

void first(benchmark::State& state, int series)
{
  Progress progress;
  const Mesh mesh = fineMesh(series, progress);
  const ThreadShare share;
  for (auto _ : state)
  {
    const SliceIndex index(view(mesh), progress);
    benchmark::DoNotOptimize(slice(view(mesh), askew, withFields(), &index, progress));
  }
  share.report(state);
  countCells(state, mesh.cellCount(), 0);
}
}

int main(int argc, char** argv)
{
  registerSeries("slice/first", first);
  registerSeries("slice/dragged", dragged);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
