// Slicing and what else the kernel serves, on a sphere in a box of 6 n^3 cells; n = 55 has a million.
#include "Contour/Contour.h"
#include "Geometry/CutTetrahedron.h"
#include "Geometry/CutVolumes.h"
#include "Pieces/Pieces.h"
#include "Sample/Sample.h"
#include "Slice/Slice.h"
#include "Slice/SliceIndex.h"
#include "Support/RandomRegions.h"

#include <benchmark/benchmark.h>

using namespace strata;
using namespace strata::test;

namespace
{
/// Three materials: a ball, and two halves of the rest. One scalar field.
Mesh ballMesh(int n)
{
  Box box;
  box.add(Vector(0, 0, 0));
  box.add(Vector(1, 1, 1));
  Mesh mesh = kuhnMesh(box, n, { { "ball", true }, { "lower", true }, { "upper", true } }, { { "scalar", 1 } });
  const Vector center(0.5, 0.5, 0.5);
  const auto outside = [&](const Vector& p) { return (p - center).norm() - 0.3; };
  setDistances(mesh, MaterialId(0), [&](const Vector& p) { return std::max(0.0, outside(p)); });
  setDistances(mesh, MaterialId(1), [&](const Vector& p) { return std::max({ 0.0, -outside(p), p[2] - 0.5 }); });
  setDistances(mesh, MaterialId(2), [&](const Vector& p) { return std::max({ 0.0, -outside(p), 0.5 - p[2] }); });
  for (int m = 0; m < 3; ++m)
  {
    setValues(mesh, FieldId(0), MaterialId(m), [m](const Vector& p, int) { return m + p[0]; });
  }
  return mesh;
}

void sliceBall(benchmark::State& state, bool indexed)
{
  const Mesh mesh = ballMesh(static_cast<int>(state.range(0)));
  Progress progress;
  const SliceIndex index(view(mesh), progress);
  Index polygons = 0;
  int run = 0;
  for (auto _ : state)
  {
    // A plane that moves from run to run, as one that a user drags.
    SlicePlane plane;
    plane.origin = Vector::Constant(0.3 + 0.4 * (run++ % 97) / 97.0);
    plane.normal = Vector(1.0, 0.3, 0.2);
    polygons = slice(view(mesh), plane, allMaterials(mesh), indexed ? &index : nullptr, progress).material.size();
  }
  state.counters["cells"] = static_cast<double>(mesh.cellCount());
  state.counters["polygons"] = static_cast<double>(polygons);
}

void cutRandom(benchmark::State& state, RandomDistances draw)
{
  const int functions = static_cast<int>(state.range(0));
  const Mesh mesh = randomRegions(8, functions, draw, 1);
  TetrahedronCut cut;
  std::vector<CornerValues> values(static_cast<std::size_t>(functions));
  Index cell = 0;
  for (auto _ : state)
  {
    const std::int64_t* corners = &mesh.tetrahedra[4 * (cell++ % mesh.cellCount())];
    for (int m = 0; m < functions; ++m)
    {
      const Buffer<float>& d = mesh.distances[static_cast<std::size_t>(m)];
      values[static_cast<std::size_t>(m)] = { m, { d[corners[0]], d[corners[1]], d[corners[2]], d[corners[3]] } };
    }
    cut.cut({ corners[0], corners[1], corners[2], corners[3] }, values.data(), functions);
    benchmark::DoNotOptimize(cut.faces().data());
  }
}
}

static void SliceIndexed(benchmark::State& state)
{
  sliceBall(state, true);
}
BENCHMARK(SliceIndexed)
  ->Arg(16)
  ->Arg(32)
  ->Arg(55)
  ->MeasureProcessCPUTime()
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);

static void SliceWithoutIndex(benchmark::State& state)
{
  sliceBall(state, false);
}
BENCHMARK(SliceWithoutIndex)
  ->Arg(16)
  ->Arg(32)
  ->Arg(55)
  ->MeasureProcessCPUTime()
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);

static void MakeSliceIndex(benchmark::State& state)
{
  const Mesh mesh = ballMesh(static_cast<int>(state.range(0)));
  Progress progress;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(SliceIndex(view(mesh), progress).cellCount());
  }
}
BENCHMARK(MakeSliceIndex)->Arg(55)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);

static void ContourBall(benchmark::State& state)
{
  const Mesh mesh = ballMesh(static_cast<int>(state.range(0)));
  Progress progress;
  Index polygons = 0;
  for (auto _ : state)
  {
    // Planes of constant x in each of the three materials.
    polygons = contour(view(mesh), FieldId(0), { 0.4, 1.4, 2.6 }, allMaterials(mesh), progress).material.size();
  }
  state.counters["cells"] = static_cast<double>(mesh.cellCount());
  state.counters["polygons"] = static_cast<double>(polygons);
}
BENCHMARK(ContourBall)->Arg(55)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);

static void CutPieces(benchmark::State& state)
{
  const Mesh mesh = ballMesh(static_cast<int>(state.range(0)));
  Progress progress;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(cutPieces(view(mesh), allMaterials(mesh), progress).material.size());
  }
}
BENCHMARK(CutPieces)->Arg(55)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);

static void RepresentedInterfaces(benchmark::State& state)
{
  const Mesh mesh = ballMesh(static_cast<int>(state.range(0)));
  Progress progress;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(representedInterfaces(view(mesh), progress).positive.size());
  }
}
BENCHMARK(RepresentedInterfaces)->Arg(55)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);

static void SampleMillionPoints(benchmark::State& state)
{
  const Mesh mesh = ballMesh(static_cast<int>(state.range(0)));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> real(0.0, 1.0);
  std::vector<double> points(3000000);
  for (double& x : points)
  {
    x = real(random);
  }
  Progress progress;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(sample(view(mesh), points.data(), 1000000, progress).cell.size());
  }
}
BENCHMARK(SampleMillionPoints)->Arg(32)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);

static void CutOneTetrahedron(benchmark::State& state)
{
  cutRandom(state, RandomDistances::Reals);
}
BENCHMARK(CutOneTetrahedron)->DenseRange(1, 6);

static void CutOneTetrahedronOfTies(benchmark::State& state)
{
  cutRandom(state, RandomDistances::Ties);
}
BENCHMARK(CutOneTetrahedronOfTies)->DenseRange(1, 6);
