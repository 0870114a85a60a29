#include "Geometry/CutTetrahedron.h"

namespace strata
{
void TetrahedronCut::cut(const std::array<std::int64_t, 4>& vertices, const CornerValues* functions, int count)
{
  winners_.clear();
  faces_.clear();
  loops_.clear();
  points_.reset(vertices);
  points_.setFunctions(functions, count);
  for (int function : points_.candidates())
  {
    addRegion(function);
  }
}

void TetrahedronCut::addRegion(int function)
{
  region_.reset();
  for (int other : points_.candidates())
  {
    if (other != function && !region_.empty())
    {
      points_.signs(region_.vertices(), function, other, signs_);
      region_.clip(other, signs_);
    }
  }
  if (region_.empty())
  {
    return;
  }
  pointOfVertex_.clear();
  for (const SymbolicVertex& vertex : region_.vertices())
  {
    pointOfVertex_.push_back(points_.pointOf(vertex, function));
  }
  const std::size_t before = faces_.size();
  for (const SymbolicPolyhedron::Face& face : region_.faces())
  {
    addFace(function, face);
  }
  if (faces_.size() > before)
  {
    winners_.push_back(function);
  }
}

void TetrahedronCut::addFace(int function, const SymbolicPolyhedron::Face& face)
{
  loop_.clear();
  for (int i = face.begin; i < face.end; ++i)
  {
    loop_.push_back(pointOfVertex_[region_.loops()[i]]);
  }
  const int begin = static_cast<int>(loops_.size());
  if (points_.appendLoop(loop_, loops_))
  {
    const int beyond = face.label < 0 ? -1 - points_.givenCorner(-1 - face.label) : face.label;
    faces_.push_back({ function, beyond, begin, static_cast<int>(loops_.size()) });
  }
}
}
