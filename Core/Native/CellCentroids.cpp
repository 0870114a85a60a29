#include "Native/CellCentroids.h"

#include <Eigen/Geometry>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace strata
{
namespace
{
constexpr Index chunkSize = 16384;

/// Faces of a shape as positions among its corners; the fourth is -1 for triangles.
using Face = std::array<int, 4>;

const std::vector<Face>& facesOf(CellShape shape)
{
  static const std::vector<Face> tetrahedron = { { 0, 1, 2, -1 }, { 0, 1, 3, -1 }, { 1, 2, 3, -1 }, { 0, 2, 3, -1 } };
  static const std::vector<Face> hexahedron = { { 0, 1, 2, 3 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 },
    { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };
  static const std::vector<Face> wedge = { { 0, 1, 2, -1 }, { 3, 4, 5, -1 }, { 0, 1, 4, 3 }, { 1, 2, 5, 4 },
    { 2, 0, 3, 5 } };
  static const std::vector<Face> pyramid = { { 0, 1, 2, 3 }, { 0, 1, 4, -1 }, { 1, 2, 4, -1 }, { 2, 3, 4, -1 },
    { 3, 0, 4, -1 } };
  static const std::vector<Face> none;
  switch (shape)
  {
    case CellShape::Tetrahedron:
      return tetrahedron;
    case CellShape::Hexahedron:
      return hexahedron;
    case CellShape::Wedge:
      return wedge;
    case CellShape::Pyramid:
      return pyramid;
    case CellShape::Polyhedron:
      break;
  }
  return none;
}

Vector meanPoint(const UnstructuredGrid& grid, const Index* corners, std::size_t count)
{
  Vector sum = Vector::Zero();
  for (std::size_t i = 0; i < count; ++i)
  {
    sum += grid.points[static_cast<std::size_t>(corners[i])];
  }
  return sum / static_cast<double>(count);
}

/// Sums volumes and first moments of tetrahedra from one point to faces.
class Moments
{
public:
  Moments(const UnstructuredGrid& grid, const Vector& apex) : grid_(grid), apex_(apex) {}

  void addFace(const Index* corners, std::size_t count)
  {
    const Vector center = meanPoint(grid_, corners, count);
    for (std::size_t i = 0; i < count; ++i)
    {
      const Vector& a = grid_.points[static_cast<std::size_t>(corners[i])];
      const Vector& b = grid_.points[static_cast<std::size_t>(corners[(i + 1) % count])];
      const double volume = std::abs((center - apex_).dot((a - apex_).cross(b - apex_)));
      volume_ += volume;
      moment_ += volume * 0.25 * ((center - apex_) + (a - apex_) + (b - apex_));
    }
  }
  Vector centroid() const { return volume_ > 0.0 ? Vector(apex_ + moment_ / volume_) : apex_; }

private:
  const UnstructuredGrid& grid_;
  Vector apex_;
  double volume_ = 0.0;
  Vector moment_ = Vector::Zero();
};

Vector centroidOf(const UnstructuredGrid& grid, std::size_t cell)
{
  const Index* corners = grid.corners.data() + grid.cornerOffsets[cell];
  const auto count = static_cast<std::size_t>(grid.cornerOffsets[cell + 1] - grid.cornerOffsets[cell]);
  Moments moments(grid, meanPoint(grid, corners, count));
  if (grid.shapes[cell] == CellShape::Polyhedron)
  {
    for (auto f = static_cast<std::size_t>(grid.faceOffsets[cell]);
         f < static_cast<std::size_t>(grid.faceOffsets[cell + 1]); ++f)
    {
      moments.addFace(grid.faceCorners.data() + grid.faceStart[f],
        static_cast<std::size_t>(grid.faceStart[f + 1] - grid.faceStart[f]));
    }
    return moments.centroid();
  }
  for (const Face& face : facesOf(grid.shapes[cell]))
  {
    std::array<Index, 4> points{};
    const std::size_t size = face[3] < 0 ? 3 : 4;
    std::transform(face.begin(), face.begin() + size, points.begin(), [&](int i) { return corners[i]; });
    moments.addFace(points.data(), size);
  }
  return moments.centroid();
}
}

std::vector<Vector> cellCentroids(const UnstructuredGrid& grid, Progress& progress)
{
  const Index count = grid.cellCount();
  std::vector<Vector> result(static_cast<std::size_t>(count));
  tbb::parallel_for(Index{ 0 }, (count + chunkSize - 1) / chunkSize, [&](Index chunk) {
    progress.check();
    const Index end = std::min(count, (chunk + 1) * chunkSize);
    for (Index cell = chunk * chunkSize; cell < end; ++cell)
    {
      result[static_cast<std::size_t>(cell)] = centroidOf(grid, static_cast<std::size_t>(cell));
    }
  });
  return result;
}
}
