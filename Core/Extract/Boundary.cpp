#include "Extract/Boundary.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace strata
{
Boundary::Boundary(const GridTopology& topology, const Materials& materials, const Box& box) :
  topology_(topology), box_(box)
{
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    if (materials[m].name == "outside")
    {
      outside_ = static_cast<std::uint8_t>(m);
    }
  }
}

bool Boundary::facesOutside(const CellFaces& faces, std::int32_t f) const
{
  if (!outside_ || faces.neighbours[f] >= 0)
  {
    return false;
  }
  std::vector<Vector> corners;
  for (std::int32_t i = faces.start[f]; i < faces.start[f + 1]; ++i)
  {
    corners.push_back(topology_.point(faces.corners[i]));
  }
  return !inSideOfBox(corners);
}

bool Boundary::inSideOfBox(const std::vector<Vector>& corners) const
{
  const double tolerance = 1e-9 * box_.diagonal();
  for (int axis = 0; axis < 3; ++axis)
  {
    for (double plane : { box_.lower[axis], box_.upper[axis] })
    {
      const auto inPlane = [&](const Vector& corner) { return std::abs(corner[axis] - plane) <= tolerance; };
      if (std::all_of(corners.begin(), corners.end(), inPlane))
      {
        return true;
      }
    }
  }
  return false;
}

std::vector<std::uint8_t> Boundary::cellsAtOutside(Progress& progress) const
{
  if (!outside_)
  {
    return {};
  }
  std::vector<std::uint8_t> flags(static_cast<std::size_t>(topology_.cellCount()), 0);
  tbb::parallel_for(tbb::blocked_range<Index>(0, topology_.cellCount(), 1024), [&](const auto& range) {
    progress.check();
    CellFaces faces;
    for (Index cell = range.begin(); cell < range.end(); ++cell)
    {
      if (topology_.hidden(cell))
      {
        continue;
      }
      topology_.faces(cell, faces);
      for (std::int32_t f = 0; f < faces.count(); ++f)
      {
        flags[cell] |= facesOutside(faces, f) ? 1 : 0;
      }
    }
  });
  return flags;
}
}
