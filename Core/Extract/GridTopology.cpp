#include "Extract/GridTopology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace strata
{
double sixfoldVolume(const std::vector<Vector>& corners, const Vector& apex)
{
  const std::size_t n = corners.size();
  Vector center = Vector::Zero();
  for (const Vector& corner : corners)
  {
    center += corner;
  }
  center = center / static_cast<double>(n) - apex;
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    sum += center.dot((corners[i] - apex).cross(corners[(i + 1) % n] - apex));
  }
  return sum;
}

Vector GridTopology::center(Index cell) const
{
  std::vector<Index> ids;
  centerCorners(cell, ids);
  std::sort(ids.begin(), ids.end());
  Vector sum = Vector::Zero();
  for (Index id : ids)
  {
    sum += point(id);
  }
  return sum / static_cast<double>(ids.size());
}

double GridTopology::volume(Index cell) const
{
  CellFaces cellFaces;
  faceCorners(cell, cellFaces);
  const Vector apex = center(cell);
  double sum = 0.0;
  std::vector<Vector> face;
  for (std::int32_t f = 0; f < cellFaces.count(); ++f)
  {
    face.clear();
    for (std::int32_t i = cellFaces.start[f]; i < cellFaces.start[f + 1]; ++i)
    {
      face.push_back(point(cellFaces.corners[i]));
    }
    sum += std::abs(sixfoldVolume(face, apex));
  }
  return sum / 6.0;
}

std::unique_ptr<GridTopology> makeGridTopology(const Grid& grid, Progress& progress)
{
  return std::visit([&](const auto& g) { return makeGridTopology(g, progress); }, grid);
}
}
