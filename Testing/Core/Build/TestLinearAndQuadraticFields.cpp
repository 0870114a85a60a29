#include "CertifiedCells.h"

#include "../Native/UnstructuredGrids.h"
#include "Extract/Extract.h"

#include <gtest/gtest.h>

#include <cmath>

namespace strata
{
namespace
{
using namespace test;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = 3.14159265358979323846;

enum class Regions
{
  Ball,
  TwoBalls,
  ThreeMeeting ///< a ball on the border between two curved halves
};

enum class GridKind
{
  Rectilinear,
  Hexahedra, ///< with curved faces
  Tetrahedra
};

struct Kind
{
  Regions regions;
  GridKind grid;
  Association association;
};

std::size_t materialAt(Regions regions, const Vector& p)
{
  const auto inBall = [&](
                        double x, double y, double z, double radius) { return (p - Vector(x, y, z)).norm() < radius; };
  switch (regions)
  {
    case Regions::Ball:
      return inBall(0.1, 0.2, 0.0, 0.75) ? 0 : 1;
    case Regions::TwoBalls:
      return inBall(0.0, 0.1, 0.0, 0.6) || inBall(1.0, 0.9, 1.0, 0.65) ? 0 : 1;
    case Regions::ThreeMeeting:
      break;
  }
  const double border = 0.5 + 0.1 * std::sin(2.0 * p.x()) * p.y();
  return inBall(0.1, 0.0, 0.6, 0.6) ? 0 : p.z() < border ? 1 : 2;
}

std::size_t materialCount(Regions regions)
{
  return regions == Regions::ThreeMeeting ? 3 : 2;
}

/// The interfaces between the regions, from fractions on a grid of their own.
Interfaces interfacesOf(Regions regions)
{
  constexpr int samples = 6;
  const Simulation fractions = fractionSimulation(cubeGrid(16), materialCount(regions), [&](const Box& box) {
    std::vector<double> result(materialCount(regions), 0.0);
    for (int i = 0; i < samples * samples * samples; ++i)
    {
      const Vector u(i % samples + 0.5, i / samples % samples + 0.5, i / (samples * samples) + 0.5);
      result[materialAt(regions, box.lower + box.size().cwiseProduct(u) / samples)] += std::pow(samples, -3);
    }
    return result;
  });
  Progress progress;
  return extractInterfaces(fractions, {}, progress).interfaces;
}

/// Moves points smoothly, those on the walls of the unit cube along them.
Vector bent(const Vector& p)
{
  const Vector s(std::sin(pi * p.x()), std::sin(pi * p.y()), std::sin(pi * p.z()));
  return p + 0.06 * Vector(s.x() * (p.y() - p.z()), s.y() * (p.z() - p.x()), s.z() * (p.x() - p.y()));
}

UnstructuredGrid gridOf(GridKind kind, int cells)
{
  const CellShape shape = kind == GridKind::Tetrahedra ? CellShape::Tetrahedron : CellShape::Hexahedron;
  UnstructuredGrid grid = unstructured(cubeGrid(cells), shape);
  if (kind != GridKind::Rectilinear)
  {
    std::transform(grid.points.begin(), grid.points.end(), grid.points.begin(), bent);
  }
  return grid;
}

/// Exact for the cells of these grids but for bent hexahedra, whose centres of volume are asked for below.
Vector centreOf(const UnstructuredGrid& grid, Index cell)
{
  const auto c = static_cast<std::size_t>(cell);
  Vector sum = Vector::Zero();
  for (Index i = grid.cornerOffsets[c]; i < grid.cornerOffsets[c + 1]; ++i)
  {
    sum += grid.points[static_cast<std::size_t>(grid.corners[static_cast<std::size_t>(i)])];
  }
  return sum / static_cast<double>(grid.cornerOffsets[c + 1] - grid.cornerOffsets[c]);
}

std::shared_ptr<const NativeData> dataOf(const Kind& kind, int cells, const FieldOf& field)
{
  const UnstructuredGrid grid = gridOf(kind.grid, cells);
  Simulation simulation;
  simulation.materials = namedMaterials(materialCount(kind.regions));
  for (Index cell = 0; cell < grid.cellCount(); ++cell)
  {
    simulation.materialIds.push_back(static_cast<std::int32_t>(materialAt(kind.regions, centreOf(grid, cell))));
  }
  if (kind.grid == GridKind::Rectilinear)
  {
    simulation.grid = cubeGrid(cells);
  }
  else
  {
    simulation.grid = grid;
  }
  const bool atPoints = kind.association == Association::Points;
  SimulationField values{ "density", 1, kind.association, {} };
  const Index count = atPoints ? grid.pointCount() : grid.cellCount();
  values.values.assign(
    simulation.materials.size(), ownedArray(std::vector<double>(static_cast<std::size_t>(count), 0.0)));
  simulation.fields = { values };
  Progress progress;
  const auto places = readNativeData(simulation, {}, progress);
  for (std::size_t m = 0; m < simulation.materials.size(); ++m)
  {
    std::vector<double> numbers;
    for (SampleIndex sample = 0; sample < places->sampleCount(); ++sample)
    {
      Vector p;
      places->positions(&sample, 1, &p);
      numbers.push_back(field(m, p));
    }
    simulation.fields[0].values[m] = ownedArray(std::move(numbers));
  }
  return readNativeData(simulation, {}, progress);
}

class FieldsPerMaterial : public testing::TestWithParam<Kind>
{
};

std::vector<Kind> everyKind()
{
  std::vector<Kind> result;
  for (const Regions regions : { Regions::Ball, Regions::TwoBalls, Regions::ThreeMeeting })
  {
    for (const GridKind grid : { GridKind::Rectilinear, GridKind::Hexahedra, GridKind::Tetrahedra })
    {
      result.push_back({ regions, grid, Association::Points });
      result.push_back({ regions, grid, Association::Cells });
    }
  }
  return result;
}

INSTANTIATE_TEST_SUITE_P(EveryKind, FieldsPerMaterial, testing::ValuesIn(everyKind()));

TEST_P(FieldsPerMaterial, LinearOnesHaveNoErrorInTheBaseMesh)
{
  const auto linear = [](std::size_t m, const Vector& p) {
    return m == 0   ? 5.0 + p.x() - 2.0 * p.y() + 0.5 * p.z()
           : m == 1 ? -p.x() + 3.0 * p.z()
                    : 2.0 * p.x() + p.y() - p.z() - 8.0;
  };
  const Interfaces interfaces = interfacesOf(GetParam().regions);
  for (const int size : { 9, 12, 16, 20, 24 })
  {
    const auto native = dataOf(GetParam(), size, linear);
    const CertifiedCells cells(native, interfaces, { infinity, { infinity } }, 0);
    ASSERT_EQ(6, cells.cellCount());
    for (Index c = 0; c < 6; ++c)
    {
      EXPECT_EQ(static_cast<Index>(materialCount(GetParam().regions)), cells.hierarchy().materialsOf(CellId(c)).size());
      // Of values up to 10, stored as floats.
      EXPECT_LE(cells.hierarchy().fieldError(CellId(c), 0), 4e-6f) << size << " cells along an axis";
    }
  }
}

TEST_P(FieldsPerMaterial, QuadraticOnesConvergeWithSecondOrderInMixedCells)
{
  const auto quadratic = [](std::size_t m, const Vector& p) {
    return m == 0   ? p.squaredNorm()
           : m == 1 ? 3.0 - p.x() * p.y() + p.z() * p.z()
                    : 2.0 * p.x() * p.x() - p.y() * p.z();
  };
  const auto native = dataOf(GetParam(), 32, quadratic);
  const CertifiedCells cells(native, interfacesOf(GetParam().regions), { 1e-9, { infinity } }, 9);
  // In cubes of 1/2, 1/4 and 1/8: native cells are of 1/32.
  std::array<double, 3> errors = { 0.0, 0.0, 0.0 };
  for (Index c = 0; c < cells.cellCount(); ++c)
  {
    const int level = cells.hierarchy().cell(CellId(c)).level;
    if (level > 0 && level % 3 == 0 && cells.hierarchy().materialsOf(CellId(c)).size() > 1)
    {
      double& error = errors[static_cast<std::size_t>(level / 3 - 1)];
      error = std::max(error, static_cast<double>(cells.hierarchy().fieldError(CellId(c), 0)));
    }
  }
  RecordProperty("FirstRatio", std::to_string(errors[0] / errors[1]));
  RecordProperty("SecondRatio", std::to_string(errors[1] / errors[2]));
  EXPECT_GE(errors[0] / errors[1], 3.0);
  EXPECT_GE(errors[1] / errors[2], 3.0);
}
}
}
