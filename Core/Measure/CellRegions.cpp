#include "Measure/CellRegions.h"

#include "Geometry/RegionTetrahedra.h"
#include "Model/Errors.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <string>

namespace strata
{
namespace
{
double tetrahedronVolume(const Representation& representation, const std::int64_t* corners)
{
  const Vector origin = representation.point(corners[0]);
  return std::abs(
           (representation.point(corners[1]) - origin)
             .dot((representation.point(corners[2]) - origin).cross(representation.point(corners[3]) - origin))) /
         6.0;
}
}

void CellRegions::divide(Index cell)
{
  cell_ = cell;
  const std::int64_t* corners = representation_.tetrahedra + 4 * cell;
  cellVolume_ = tetrahedronVolume(representation_, corners);
  const MaterialSet candidates = materialsOfCell(representation_, cell);
  if (candidates.empty())
  {
    throw InvalidInput("cell " + std::to_string(cell) + " of the representation holds no material");
  }
  divided_ = candidates.size() > 1;
  regions_ = candidates;
  if (!divided_)
  {
    return;
  }
  functions_.clear();
  for (const MaterialId m : candidates)
  {
    CornerValues function;
    function.function = m.value;
    std::transform(corners, corners + 4, function.values.begin(),
      [&](std::int64_t corner) { return static_cast<double>(representation_.distances[m.value][corner]); });
    functions_.push_back(function);
  }
  cut_.cut({ corners[0], corners[1], corners[2], corners[3] }, functions_.data(), static_cast<int>(functions_.size()));
  regions_ = MaterialSet();
  for (const int winner : cut_.winners())
  {
    regions_.insert(MaterialId(winner));
  }
}

/// Calls add(fraction of the cell's volume, mean barycentric coordinates) for tetrahedra that fill a region.
template<class Add>
void CellRegions::forEachTetrahedron(MaterialId m, Add&& add) const
{
  std::vector<std::array<int, 4>> pieces;
  fillRegion(cut_, m.value, pieces);
  for (const std::array<int, 4>& piece : pieces)
  {
    Eigen::Matrix4d coordinates;
    for (int row = 0; row < 4; ++row)
    {
      coordinates.row(row) = Eigen::Map<const Eigen::RowVector4d>(cut_.coordinates()[piece[row]].data());
    }
    add(std::abs(coordinates.determinant()), Eigen::Vector4d(coordinates.colwise().mean().transpose()));
  }
}

double CellRegions::volume(MaterialId m) const
{
  if (!divided_)
  {
    return regions_.contains(m) ? cellVolume_ : 0.0;
  }
  double fraction = 0.0;
  forEachTetrahedron(m, [&](double part, const Eigen::Vector4d&) { fraction += part; });
  return fraction * cellVolume_;
}

double CellRegions::integral(MaterialId m, const float* vertexValues) const
{
  const std::int64_t* corners = divided_ ? cut_.sortedVertices().data() : representation_.tetrahedra + 4 * cell_;
  const Eigen::Vector4d values(
    vertexValues[corners[0]], vertexValues[corners[1]], vertexValues[corners[2]], vertexValues[corners[3]]);
  if (!divided_)
  {
    return regions_.contains(m) ? cellVolume_ * values.mean() : 0.0;
  }
  double sum = 0.0;
  forEachTetrahedron(m, [&](double part, const Eigen::Vector4d& mean) { sum += part * mean.dot(values); });
  return sum * cellVolume_;
}

Vector CellRegions::position(int point) const
{
  Vector result = Vector::Zero();
  for (int i = 0; i < 4; ++i)
  {
    result += cut_.coordinates()[point][i] * representation_.point(cut_.sortedVertices()[i]);
  }
  return result;
}

std::vector<Vector> CellRegions::corners(const TetrahedronCut::Face& face) const
{
  std::vector<Vector> result;
  for (int i = face.begin; i < face.end; ++i)
  {
    result.push_back(position(cut_.loops()[i]));
  }
  return result;
}

std::vector<CellRegions::Border> CellRegions::borders() const
{
  std::vector<Border> result;
  if (divided_)
  {
    for (const TetrahedronCut::Face& face : cut_.faces())
    {
      if (face.isInterface())
      {
        result.push_back({ MaterialId(face.function), MaterialId(face.beyond), corners(face) });
      }
    }
  }
  return result;
}

std::vector<CellRegions::FacePart> CellRegions::faceParts() const
{
  std::vector<FacePart> result;
  if (divided_)
  {
    for (const TetrahedronCut::Face& face : cut_.faces())
    {
      if (face.beyond < 0)
      {
        result.push_back({ -1 - face.beyond, MaterialId(face.function), corners(face) });
      }
    }
    return result;
  }
  const std::int64_t* vertices = representation_.tetrahedra + 4 * cell_;
  for (int opposite = 0; opposite < 4; ++opposite)
  {
    FacePart part{ opposite, regions_.first(), {} };
    for (int i = 0; i < 4; ++i)
    {
      if (i != opposite)
      {
        part.corners.push_back(representation_.point(vertices[i]));
      }
    }
    result.push_back(part);
  }
  return result;
}
}
