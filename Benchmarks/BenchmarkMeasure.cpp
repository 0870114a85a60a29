// How long it takes to measure a representation: certified Hausdorff distances between surfaces with tens of thousands
// of triangles, and all errors of a sphere in a cube.

#include "Geometry/TetrahedronLocator.h"
#include "Measure/FieldErrors.h"
#include "Measure/Measure.h"
#include "Measure/MisclassifiedVolume.h"
#include "Measure/RepresentedRegions.h"
#include "Support/PointData.h"
#include "Support/RepresentationCube.h"
#include "Support/TriangulatedShapes.h"

#include <benchmark/benchmark.h>

using namespace strata;
using namespace strata::test;

namespace
{
const MaterialId inside(0);
const MaterialId outside(1);
const FieldId density(0);
const Vector center(0.5, 0.5, 0.5);
constexpr double radius = 0.35;

Box unitBox()
{
  Box box;
  box.add(Vector(0, 0, 0));
  box.add(Vector(1, 1, 1));
  return box;
}

Mesh sphereInCube(int n)
{
  Mesh mesh = kuhnMesh(unitBox(), n, { { "inside" }, { "outside" } }, { { "density", 1 } });
  setTwoMaterials(mesh, outside, inside, [](const Vector& p) { return (p - center).norm() - radius; });
  for (const MaterialId m : { inside, outside })
  {
    setValues(mesh, density, m, [](const Vector& p, int) { return p.squaredNorm(); });
  }
  return mesh;
}

PointData samples(int n)
{
  PointData data(unitBox(), { { "inside" }, { "outside" } }, { { "density", 1 } });
  data.setField(density, [](MaterialId, const Vector& p, int) { return p.squaredNorm(); });
  data.addGrid(n, [](const Vector& p) { return MaterialSet::of((p - center).norm() < radius ? inside : outside); });
  return data;
}

Interfaces sphere(int subdivisions)
{
  Interfaces interfaces;
  interfaces.surfaces.push_back({ outside, inside, {} });
  for (const auto& triangle : sphereSurface(center, radius, subdivisions))
  {
    const auto first = static_cast<std::int32_t>(interfaces.points.size());
    interfaces.points.insert(interfaces.points.end(), triangle.begin(), triangle.end());
    interfaces.surfaces.back().triangles.push_back({ first, first + 1, first + 2 });
  }
  return interfaces;
}

/// Tolerance in units of 1e-5 of the diagonal of the unit box.
void hausdorff(benchmark::State& state)
{
  const TriangleSoup original{ sphereSurface(center, radius, 5) };
  const Mesh mesh = sphereInCube(static_cast<int>(state.range(0)));
  Progress progress;
  const TriangleSoup represented = representedRegions(view(mesh), {}, progress).surfaces.begin()->second;
  const double tolerance = 1e-5 * static_cast<double>(state.range(1)) * unitBox().diagonal();
  HausdorffDistance found;
  for (auto _ : state)
  {
    found = hausdorffDistance(original, represented, tolerance, progress);
  }
  state.counters["triangles"] = static_cast<double>(original.triangles.size() + represented.triangles.size());
  state.counters["lower"] = found.originalToRepresented.lower;
  state.counters["upper"] = found.originalToRepresented.upper;
}
BENCHMARK(hausdorff)->ArgsProduct({ { 8, 16, 32 }, { 100, 10 } })->Unit(benchmark::kMillisecond)->UseRealTime();

void locateAndMeasureFields(benchmark::State& state)
{
  const Mesh mesh = sphereInCube(static_cast<int>(state.range(0)));
  const PointData data = samples(static_cast<int>(state.range(1)));
  Progress progress;
  for (auto _ : state)
  {
    const TetrahedronLocator locator(mesh.points.data(), mesh.tetrahedra.data(), mesh.cellCount());
    benchmark::DoNotOptimize(measureFields(view(mesh), data, locator, progress));
  }
  state.counters["cells"] = static_cast<double>(mesh.cellCount());
  state.counters["samples/s"] = benchmark::Counter(data.sampleCount(), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(locateAndMeasureFields)->Args({ 16, 128 })->Args({ 54, 128 })->Unit(benchmark::kMillisecond)->UseRealTime();

void regions(benchmark::State& state)
{
  const Mesh mesh = sphereInCube(static_cast<int>(state.range(0)));
  Progress progress;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(representedRegions(view(mesh), {}, progress));
  }
  state.counters["cells/s"] =
    benchmark::Counter(static_cast<double>(mesh.cellCount()), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(regions)->Arg(54)->Unit(benchmark::kMillisecond)->UseRealTime();

void misclassified(benchmark::State& state)
{
  const Mesh mesh = sphereInCube(static_cast<int>(state.range(0)));
  const Interfaces interfaces = sphere(5);
  Progress progress;
  for (auto _ : state)
  {
    const OriginalMaterial original(interfaces, unitBox(), outside);
    benchmark::DoNotOptimize(misclassifiedVolume(view(mesh), original, progress));
  }
  state.counters["cells/s"] =
    benchmark::Counter(static_cast<double>(mesh.cellCount()), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(misclassified)->Arg(16)->Arg(54)->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK_MAIN();
