#include "Native/ReadNativeData.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <random>

using namespace strata;

namespace
{
const Vector center(0.5, 0.5, 0.5);
constexpr double radius = 0.3;

ValueArray ownedArray(std::vector<float> values)
{
  auto owner = std::make_shared<std::vector<float>>(std::move(values));
  return { owner->data(), static_cast<Index>(owner->size()), 1, owner };
}

/// A ball in a block, n^3 cells, with five scalar fields per material (as an impact has density, pressure, velocity).
Simulation ballInBlock(Index n)
{
  Simulation simulation;
  RectilinearGrid grid;
  for (std::vector<double>& axis : grid.coordinates)
  {
    for (Index i = 0; i <= n; ++i)
    {
      axis.push_back(static_cast<double>(i) / static_cast<double>(n));
    }
  }
  std::vector<float> inside;
  std::vector<float> outside;
  std::vector<float> values;
  for (Index cell = 0; cell < grid.cellCount(); ++cell)
  {
    const Vector p(static_cast<double>(cell % n) + 0.5, static_cast<double>((cell / n) % n) + 0.5,
      static_cast<double>(cell / (n * n)) + 0.5);
    const double distance = (p / static_cast<double>(n) - center).norm() - radius;
    inside.push_back(static_cast<float>(std::clamp(0.5 - static_cast<double>(n) * distance, 0.0, 1.0)));
    outside.push_back(1.0f - inside.back());
    values.push_back(static_cast<float>(std::sin(0.1 * p.x()) + p.y() * p.z()));
  }
  simulation.grid = std::move(grid);
  simulation.materials = { { "ball", true }, { "block", true } };
  simulation.fractions = { ownedArray(inside), ownedArray(outside) };
  for (const char* name : { "density", "pressure", "vx", "vy", "vz" })
  {
    const ValueArray shared = ownedArray(values);
    simulation.fields.push_back({ name, 1, Association::Cells, { shared, shared } });
  }
  return simulation;
}

/// The same cells as hexahedra.
Simulation asHexahedra(Simulation simulation)
{
  const auto grid = std::get<RectilinearGrid>(simulation.grid);
  UnstructuredGrid result;
  const Index nx = grid.pointCount(0);
  for (Index p = 0; p < grid.pointCount(); ++p)
  {
    result.points.emplace_back(grid.coordinates[0][static_cast<std::size_t>(p % nx)],
      grid.coordinates[1][static_cast<std::size_t>((p / nx) % nx)],
      grid.coordinates[2][static_cast<std::size_t>(p / (nx * nx))]);
  }
  result.shapes.assign(static_cast<std::size_t>(grid.cellCount()), CellShape::Hexahedron);
  result.cornerOffsets.push_back(0);
  for (Index cell = 0; cell < grid.cellCount(); ++cell)
  {
    const Index n = nx - 1;
    const Index p = cell % n + nx * ((cell / n) % n + nx * (cell / (n * n)));
    for (const Index offset : { Index{ 0 }, Index{ 1 }, nx + 1, nx })
    {
      result.corners.push_back(p + offset);
    }
    for (const Index offset : { Index{ 0 }, Index{ 1 }, nx + 1, nx })
    {
      result.corners.push_back(p + offset + nx * nx);
    }
    result.cornerOffsets.push_back(static_cast<Index>(result.corners.size()));
  }
  simulation.grid = std::move(result);
  return simulation;
}

/// Points at distances from the ball's surface within [lower, upper), in cells of 1/n.
std::vector<Vector> pointsAtDistances(double lower, double upper, Index n)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::uniform_real_distribution<double> distance(lower / static_cast<double>(n), upper / static_cast<double>(n));
  std::vector<Vector> result;
  for (int i = 0; i < 4096; ++i)
  {
    const double x = number(random);
    const double y = number(random);
    const Vector direction = Vector(x, y, number(random)).normalized();
    result.push_back(center + (radius + distance(random)) * direction);
  }
  return result;
}

constexpr Index gridSize = 64;

void evaluate(benchmark::State& state, const Simulation& simulation)
{
  Progress progress;
  const auto data = readNativeData(simulation, {}, progress);
  const std::vector<Vector> points =
    pointsAtDistances(static_cast<double>(state.range(0)), static_cast<double>(state.range(1)), gridSize);
  std::vector<double> result(static_cast<std::size_t>(data->componentCount()));
  std::size_t i = 0;
  for (auto _ : state)
  {
    const Vector& point = points[i++ % points.size()];
    const Vector closest = center + radius * (point - center).normalized();
    const bool inside = (point - center).norm() < radius;
    data->evaluate(MaterialId(0), point, inside, closest, GhostMethod::DataThenLinear, result.data());
    benchmark::DoNotOptimize(result.data());
  }
  state.SetItemsProcessed(state.iterations());
}

void evaluateRectilinear(benchmark::State& state)
{
  evaluate(state, ballInBlock(gridSize));
}

void evaluateHexahedra(benchmark::State& state)
{
  evaluate(state, asHexahedra(ballInBlock(gridSize)));
}

void readGrid(benchmark::State& state, const Simulation& simulation)
{
  for (auto _ : state)
  {
    Progress progress;
    benchmark::DoNotOptimize(readNativeData(simulation, {}, progress));
  }
  state.SetItemsProcessed(state.iterations() * cellCount(simulation.grid));
}

void readRectilinear(benchmark::State& state)
{
  readGrid(state, ballInBlock(state.range(0)));
}

void readHexahedra(benchmark::State& state)
{
  readGrid(state, asHexahedra(ballInBlock(state.range(0))));
}
}

// Distances from the ball's surface in cells: well inside, ghosts near (data and filled corners), ghosts far.
BENCHMARK(evaluateRectilinear)->Args({ -16, -4 })->Args({ -1, 0 })->Args({ 0, 1 })->Args({ 4, 12 });
BENCHMARK(evaluateHexahedra)->Args({ -16, -4 })->Args({ 0, 1 })->Args({ 4, 12 });
BENCHMARK(readRectilinear)->Arg(150)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(readHexahedra)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();
