#pragma once

#include "Support/FractionsOnGrids.h"

#include <array>
#include <functional>
#include <map>

namespace strata::test
{
/// The leaves of a tree over the unit cube, as hexahedra that share their points where these coincide.
struct Octree
{
  UnstructuredGrid grid;
  std::vector<Box> boxes; ///< by cell
};

namespace detail
{
class OctreeBuilder
{
public:
  /// Whether a cell of a level is divided.
  using Divides = std::function<bool(const Box&, int level)>;

  OctreeBuilder(int ratio, int levels, Divides divides) : ratio_(ratio), levels_(levels), divides_(std::move(divides))
  {
    tree_.grid.cornerOffsets = { 0 };
  }

  Octree build(int cubes)
  {
    int step = 1;
    for (int level = 0; level < levels_; ++level)
    {
      step *= ratio_;
    }
    size_ = step * cubes;
    divide({ 0, 0, 0 }, step * cubes, cubes, -1);
    return tree_;
  }

private:
  using Place = std::array<int, 3>;

  void divide(const Place& lower, int size, int parts, int level)
  {
    const int step = size / parts;
    for (int i = 0; i < parts * parts * parts; ++i)
    {
      const Place at{ lower[0] + i % parts * step, lower[1] + i / parts % parts * step,
        lower[2] + i / parts / parts * step };
      const Box box = boxOf(at, step);
      if (level + 1 < levels_ && divides_(box, level + 1))
      {
        divide(at, step, ratio_, level + 1);
      }
      else
      {
        addCell(at, step, box);
      }
    }
  }

  Vector position(const Place& at) const { return Vector(at[0], at[1], at[2]) / static_cast<double>(size_); }

  Box boxOf(const Place& at, int step) const
  {
    Box box;
    box.add(position(at));
    box.add(position({ at[0] + step, at[1] + step, at[2] + step }));
    return box;
  }

  void addCell(const Place& at, int step, const Box& box)
  {
    constexpr int corners[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
      { 1, 1, 1 }, { 0, 1, 1 } };
    UnstructuredGrid& grid = tree_.grid;
    for (const auto& c : corners)
    {
      const Place place{ at[0] + c[0] * step, at[1] + c[1] * step, at[2] + c[2] * step };
      const auto [entry, isNew] = points_.try_emplace(place, grid.pointCount());
      if (isNew)
      {
        grid.points.push_back(position(place));
      }
      grid.corners.push_back(entry->second);
    }
    grid.shapes.push_back(CellShape::Hexahedron);
    grid.cornerOffsets.push_back(static_cast<Index>(grid.corners.size()));
    tree_.boxes.push_back(box);
  }

  int ratio_;
  int levels_;
  Divides divides_;
  int size_ = 0;
  Octree tree_;
  std::map<Place, Index> points_;
};
}

/// cubes^3 cells, each divided into ratio^3 where `divides` says so, up to `levels` times.
inline Octree makeOctree(int cubes, int ratio, int levels, const detail::OctreeBuilder::Divides& divides)
{
  return detail::OctreeBuilder(ratio, levels, divides).build(cubes);
}

inline Simulation fractionsOnOctree(const Octree& tree, std::size_t materialCount, const FractionsOf& of)
{
  Simulation simulation;
  simulation.grid.emplace<UnstructuredGrid>(tree.grid);
  simulation.materials = namedMaterials(materialCount);
  std::vector<std::vector<double>> values(materialCount);
  for (const Box& box : tree.boxes)
  {
    const std::vector<double> fractions = of(box);
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
}
