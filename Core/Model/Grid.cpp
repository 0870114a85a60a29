#include "Model/Grid.h"

namespace strata
{
namespace
{
Box boundsOf(const RectilinearGrid& grid)
{
  Box box;
  if (grid.pointCount() > 0)
  {
    const auto& c = grid.coordinates;
    box.add(Vector(c[0].front(), c[1].front(), c[2].front()));
    box.add(Vector(c[0].back(), c[1].back(), c[2].back()));
  }
  return box;
}

Box boundsOf(const UnstructuredGrid& grid)
{
  Box box;
  for (const Vector& point : grid.points)
  {
    box.add(point);
  }
  return box;
}
}

Box bounds(const Grid& grid)
{
  return std::visit([](const auto& g) { return boundsOf(g); }, grid);
}

Index cellCount(const Grid& grid)
{
  return std::visit([](const auto& g) { return g.cellCount(); }, grid);
}

Index pointCount(const Grid& grid)
{
  return std::visit([](const auto& g) { return g.pointCount(); }, grid);
}
}
