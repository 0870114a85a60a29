#pragma once

#include "Model/Simulation.h"

#include <functional>
#include <memory>
#include <string>

namespace strata::test
{
/// Materials named m0, m1, ...
inline Materials namedMaterials(std::size_t count)
{
  Materials materials;
  for (std::size_t m = 0; m < count; ++m)
  {
    materials.push_back({ "m" + std::to_string(m), true });
  }
  return materials;
}

/// An array that owns its values.
inline ValueArray ownedArray(std::vector<double> values, int components = 1)
{
  const auto memory = std::make_shared<const std::vector<double>>(std::move(values));
  return ValueArray(memory->data(), static_cast<Index>(memory->size()) / components, components, memory);
}

/// Coordinates of n equal cells between two ends.
inline std::vector<double> evenCoordinates(double from, double to, int cells)
{
  std::vector<double> result;
  for (int i = 0; i <= cells; ++i)
  {
    result.push_back(from + (to - from) * i / cells);
  }
  return result;
}

/// A rectilinear grid of n^3 cells over the cube [from, to]^3.
inline RectilinearGrid cubeGrid(int cells, double from = 0.0, double to = 1.0)
{
  RectilinearGrid grid;
  grid.coordinates.fill(evenCoordinates(from, to, cells));
  return grid;
}

/// The box of a cell.
inline Box cellBox(const RectilinearGrid& grid, Index cell)
{
  const Index i = cell % grid.cellCount(0);
  const Index j = cell / grid.cellCount(0) % grid.cellCount(1);
  const Index k = cell / grid.cellCount(0) / grid.cellCount(1);
  const auto& c = grid.coordinates;
  Box box;
  box.add(Vector(c[0][i], c[1][j], c[2][k]));
  box.add(Vector(c[0][i + 1], c[1][j + 1], c[2][k + 1]));
  return box;
}

/// The fractions of all materials in a box.
using FractionsOf = std::function<std::vector<double>(const Box&)>;

/// A simulation with volume fractions on a rectilinear grid.
inline Simulation fractionSimulation(const RectilinearGrid& grid, std::size_t materialCount, const FractionsOf& of)
{
  Simulation simulation;
  simulation.grid.emplace<RectilinearGrid>(grid);
  simulation.materials = namedMaterials(materialCount);
  std::vector<std::vector<double>> values(materialCount);
  for (Index cell = 0; cell < grid.cellCount(); ++cell)
  {
    const std::vector<double> fractions = of(cellBox(grid, cell));
    for (std::size_t m = 0; m < materialCount; ++m)
    {
      values[m].push_back(fractions[m]);
    }
  }
  for (std::vector<double>& v : values)
  {
    simulation.fractions.push_back(ownedArray(std::move(v)));
  }
  return simulation;
}

/// The same cells and points as hexahedra of an unstructured grid.
inline UnstructuredGrid asHexahedra(const RectilinearGrid& grid)
{
  UnstructuredGrid result;
  const auto& c = grid.coordinates;
  for (double z : c[2])
  {
    for (double y : c[1])
    {
      for (double x : c[0])
      {
        result.points.emplace_back(x, y, z);
      }
    }
  }
  const Index row = grid.pointCount(0);
  const Index layer = row * grid.pointCount(1);
  result.cornerOffsets.push_back(0);
  for (Index cell = 0; cell < grid.cellCount(); ++cell)
  {
    const Index i = cell % grid.cellCount(0);
    const Index j = cell / grid.cellCount(0) % grid.cellCount(1);
    const Index k = cell / grid.cellCount(0) / grid.cellCount(1);
    const Index p = i + row * j + layer * k;
    for (Index corner : { p, p + 1, p + 1 + row, p + row })
    {
      result.corners.push_back(corner);
    }
    for (Index corner : { p, p + 1, p + 1 + row, p + row })
    {
      result.corners.push_back(corner + layer);
    }
    result.shapes.push_back(CellShape::Hexahedron);
    result.cornerOffsets.push_back(static_cast<Index>(result.corners.size()));
  }
  result.hidden = grid.hidden;
  return result;
}
}
