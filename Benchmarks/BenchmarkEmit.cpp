// Writing a level as a mesh: with all arrays, and with the composite values alone.

#include "Emit/Emit.h"
#include "Levels.h"

using namespace strata;
using namespace strata::benchmarks;

namespace
{
void emit(benchmark::State& state, int series, const EmitOptions& options)
{
  const Impact& data = impact(series);
  Progress progress;
  HierarchyBuilder builder(data.native, data.interfaces, {}, progress);
  const Level level = buildLevel(builder, bounds(fine.interfaceError, fine.density), progress);
  Mesh mesh;
  const ThreadShare share;
  for (auto _ : state)
  {
    mesh = emitMesh(builder.hierarchy(), level, levelCells(builder.hierarchy(), level, progress), options, progress);
  }
  share.report(state);
  countCells(state, mesh.cellCount(), bytesOf(mesh));
}

void emitAll(benchmark::State& state, int series)
{
  emit(state, series, {});
}

void emitComposite(benchmark::State& state, int series)
{
  emit(state, series, { false, false, false });
}
}

int main(int argc, char** argv)
{
  registerSeries("emit/all", emitAll);
  registerSeries("emit/composite", emitComposite);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
