#include "Conversion/CellVolumes.h"

#include "Model/ShapeFaces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace strata::conversion
{
namespace
{
const Vector& pointAt(const UnstructuredGrid& grid, Index point)
{
  return grid.points[static_cast<std::size_t>(point)];
}

double sixVolumes(const Vector& a, const Vector& b, const Vector& c, const Vector& d)
{
  return (b - a).cross(c - a).dot(d - a);
}

/// Magnitudes are added, since files list the faces in either direction.
double polyhedronVolume(const UnstructuredGrid& grid, Index cell)
{
  const auto c = static_cast<std::size_t>(cell);
  const Vector& apex = pointAt(grid, grid.corners[static_cast<std::size_t>(grid.cornerOffsets[c])]);
  double sum = 0.0;
  for (Index f = grid.faceOffsets[c]; f < grid.faceOffsets[c + 1]; ++f)
  {
    const Index* begin = grid.faceCorners.data() + grid.faceStart[static_cast<std::size_t>(f)];
    const Index* end = grid.faceCorners.data() + grid.faceStart[static_cast<std::size_t>(f) + 1];
    double ofFace = 0.0;
    for (const Index* k = begin + 1; k + 1 < end; ++k)
    {
      ofFace += sixVolumes(apex, pointAt(grid, *begin), pointAt(grid, k[0]), pointAt(grid, k[1]));
    }
    sum += std::abs(ofFace);
  }
  return sum / 6.0;
}

double volumeAt(const RectilinearGrid& grid, Index cell)
{
  double volume = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const Index count = grid.cellCount(static_cast<int>(axis));
    const auto i = static_cast<std::size_t>(cell % count);
    volume *= grid.coordinates[axis][i + 1] - grid.coordinates[axis][i];
    cell /= count;
  }
  return volume;
}

double volumeAt(const UnstructuredGrid& grid, Index cell)
{
  return cellVolume(grid, cell);
}

/// Calls `visit(point)` for the corner points of a cell.
template<typename Visit>
void forEachCorner(const RectilinearGrid& grid, Index cell, const Visit& visit)
{
  const Index i = cell % grid.cellCount(0);
  const Index j = cell / grid.cellCount(0) % grid.cellCount(1);
  const Index k = cell / (grid.cellCount(0) * grid.cellCount(1));
  for (Index corner = 0; corner < 8; ++corner)
  {
    visit(
      i + (corner & 1) + grid.pointCount(0) * (j + (corner >> 1 & 1) + grid.pointCount(1) * (k + (corner >> 2 & 1))));
  }
}

template<typename Visit>
void forEachCorner(const UnstructuredGrid& grid, Index cell, const Visit& visit)
{
  const auto c = static_cast<std::size_t>(cell);
  for (Index k = grid.cornerOffsets[c]; k < grid.cornerOffsets[c + 1]; ++k)
  {
    visit(grid.corners[static_cast<std::size_t>(k)]);
  }
}

/// The share of a material in a cell; fractions at points count as their mean over the corners.
template<typename AnyGrid>
double share(const Simulation& simulation, const AnyGrid& grid, std::size_t material, Index cell)
{
  if (simulation.fractions.empty())
  {
    return simulation.materialIds[static_cast<std::size_t>(cell)] == static_cast<std::int32_t>(material) ? 1.0 : 0.0;
  }
  const ValueArray& fraction = simulation.fractions[material];
  if (simulation.fractionAssociation == Association::Cells)
  {
    return fraction(cell);
  }
  double sum = 0.0;
  int count = 0;
  forEachCorner(grid, cell, [&](Index point) {
    sum += fraction(point);
    ++count;
  });
  return sum / std::max(count, 1);
}

const SimulationField* cellDensity(const Simulation& simulation)
{
  const auto at = std::find_if(simulation.fields.begin(), simulation.fields.end(), [](const SimulationField& field) {
    return field.name == "density" && field.components == 1 && field.association == Association::Cells;
  });
  return at == simulation.fields.end() ? nullptr : &*at;
}

template<typename AnyGrid>
OriginalVolumes volumesOf(const Simulation& simulation, const AnyGrid& grid)
{
  const std::size_t count = simulation.materials.size();
  const SimulationField* density = cellDensity(simulation);
  OriginalVolumes result;
  result.volumes.assign(count, 0.0);
  if (density)
  {
    result.masses.assign(count, 0.0);
  }
  for (Index cell = 0; cell < grid.cellCount(); ++cell)
  {
    const double volume = volumeAt(grid, cell);
    for (std::size_t m = 0; m < count; ++m)
    {
      const double part = volume * share(simulation, grid, m, cell);
      result.volumes[m] += part;
      if (density && density->values[m] && part > 0.0)
      {
        result.masses[m] += part * density->values[m](cell);
      }
    }
  }
  for (std::size_t m = 0; density && m < count; ++m)
  {
    result.masses[m] = density->values[m] ? result.masses[m] : std::numeric_limits<double>::quiet_NaN();
  }
  return result;
}
}

double cellVolume(const UnstructuredGrid& grid, Index cell)
{
  const auto c = static_cast<std::size_t>(cell);
  if (grid.shapes[c] == CellShape::Polyhedron)
  {
    return polyhedronVolume(grid, cell);
  }
  const Index* corners = grid.corners.data() + grid.cornerOffsets[c];
  const auto p = [&](int k) -> const Vector& { return pointAt(grid, corners[k]); };
  double sum = 0.0;
  for (const auto& f : facesOf(grid.shapes[c]))
  {
    if (cornerCount(f) == 3)
    {
      sum += sixVolumes(p(0), p(f[0]), p(f[1]), p(f[2]));
      continue;
    }
    // The mean of the two ways to cut a warped face is the volume below its bilinear surface.
    sum += 0.5 * (sixVolumes(p(0), p(f[0]), p(f[1]), p(f[2])) + sixVolumes(p(0), p(f[0]), p(f[2]), p(f[3])) +
                   sixVolumes(p(0), p(f[0]), p(f[1]), p(f[3])) + sixVolumes(p(0), p(f[1]), p(f[2]), p(f[3])));
  }
  return sum / 6.0;
}

OriginalVolumes originalVolumes(const Simulation& simulation)
{
  OriginalVolumes result = std::visit([&](const auto& grid) { return volumesOf(simulation, grid); }, simulation.grid);
  // What no cell fills of the box is outside.
  const auto& materials = simulation.materials;
  const auto outside = std::find_if(
    materials.begin(), materials.end(), [](const Material& material) { return material.name == "outside"; });
  if (outside != materials.end() && std::holds_alternative<UnstructuredGrid>(simulation.grid))
  {
    double filled = 0.0;
    for (const double volume : result.volumes)
    {
      filled += volume;
    }
    result.volumes[static_cast<std::size_t>(outside - materials.begin())] +=
      std::max(0.0, bounds(simulation.grid).volume() - filled);
  }
  return result;
}
}
