#include "Native/CellCentroids.h"

#include "Model/ShapeFaces.h"

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
  for (const auto& face : facesOf(grid.shapes[cell]))
  {
    std::array<Index, 4> points{};
    const int size = cornerCount(face);
    std::transform(face, face + size, points.begin(), [&](int i) { return corners[i]; });
    moments.addFace(points.data(), static_cast<std::size_t>(size));
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
