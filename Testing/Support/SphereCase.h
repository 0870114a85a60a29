#pragma once

#include "Model/Interfaces.h"
#include "Model/Simulation.h"
#include "Native/ReadNativeData.h"
#include "Support/FractionsOfBox.h"
#include "Support/FractionsOnGrids.h"
#include "Support/TriangulatedShapes.h"

#include <functional>
#include <map>
#include <memory>
#include <tuple>

namespace strata::test
{
/// Triangles that share their points, as one interface.
inline Interfaces interfaceBetween(const Triangles& triangles, MaterialId positive, MaterialId negative)
{
  Interfaces result;
  result.surfaces.push_back({ positive, negative, {} });
  std::map<std::tuple<double, double, double>, std::int32_t> pointAt;
  for (const auto& triangle : triangles)
  {
    std::array<std::int32_t, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto key = std::make_tuple(triangle[i].x(), triangle[i].y(), triangle[i].z());
      const auto next = static_cast<std::int32_t>(result.points.size());
      const auto [entry, isNew] = pointAt.emplace(key, next);
      if (isNew)
      {
        result.points.push_back(triangle[i]);
      }
      corners[i] = entry->second;
    }
    result.surfaces.back().triangles.push_back(corners);
  }
  return result;
}

/// Values of a scalar field at a place, by material.
using FieldOf = std::function<double(std::size_t material, const Vector&)>;

/// A ball (material 0) in a cube (material 1): unit cube, n^3 cells, cell data.
struct SphereCase
{
  Vector center{ 0.45, 0.55, 0.5 };
  double radius = 0.3;
  Simulation simulation;
  std::shared_ptr<const NativeData> native;
  Interfaces interfaces;
};

inline SphereCase sphereCase(int cells, int subdivisions, const FieldOf& field)
{
  SphereCase result;
  const RectilinearGrid grid = cubeGrid(cells);
  const auto distance = [&](const Vector& p) { return (p - result.center).norm() - result.radius; };
  result.simulation = fractionSimulation(grid, 2, [&](const Box& box) {
    const double inside = fractionInside(box, distance, 3);
    return std::vector<double>{ inside, 1.0 - inside };
  });
  SimulationField density;
  density.name = "density";
  for (std::size_t m = 0; m < 2; ++m)
  {
    std::vector<double> values;
    for (Index cell = 0; cell < grid.cellCount(); ++cell)
    {
      values.push_back(field(m, cellBox(grid, cell).center()));
    }
    density.values.push_back(ownedArray(std::move(values)));
  }
  result.simulation.fields.push_back(density);
  Progress progress;
  result.native = readNativeData(result.simulation, {}, progress);
  // The sphere's normals point outwards: into material 1.
  result.interfaces =
    interfaceBetween(sphereSurface(result.center, result.radius, subdivisions), MaterialId(1), MaterialId(0));
  return result;
}

/// A field that curves in both materials and jumps between them.
inline double wavyField(std::size_t material, const Vector& p)
{
  return material == 0 ? 10.0 + p.squaredNorm() : std::sin(3.0 * p.x()) * p.y() + 2.0 * p.z() * p.z();
}
}
