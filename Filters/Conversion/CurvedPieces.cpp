#include "Conversion/CurvedPieces.h"

#include <Eigen/Geometry>

#include <map>
#include <utility>

namespace strata::conversion
{
namespace
{
using Step = std::array<int, 3>;

/// Numbers lattice points in the order in which they are asked for.
class Numbered
{
public:
  int operator()(const Step& step)
  {
    const auto [at, isNew] = numbers_.emplace(step, static_cast<int>(steps_.size()));
    if (isNew)
    {
      steps_.push_back(step);
    }
    return at->second;
  }
  const std::vector<Step>& steps() const { return steps_; }

private:
  std::map<Step, int> numbers_;
  std::vector<Step> steps_;
};

void addHexahedra(const std::array<int, 3>& n, Numbered& points, std::vector<CurvedPattern::Piece>& pieces)
{
  for (int k = 0; k < n[2]; ++k)
  {
    for (int j = 0; j < n[1]; ++j)
    {
      for (int i = 0; i < n[0]; ++i)
      {
        pieces.push_back(
          { CellShape::Hexahedron, { points({ i, j, k }), points({ i + 1, j, k }), points({ i + 1, j + 1, k }),
                                     points({ i, j + 1, k }), points({ i, j, k + 1 }), points({ i + 1, j, k + 1 }),
                                     points({ i + 1, j + 1, k + 1 }), points({ i, j + 1, k + 1 }) } });
      }
    }
  }
}

void addWedges(int n, int layers, Numbered& points, std::vector<CurvedPattern::Piece>& pieces)
{
  const auto add = [&](const Step& a, const Step& b, const Step& c) {
    const auto above = [](const Step& s) { return Step{ s[0], s[1], s[2] + 1 }; };
    pieces.push_back(
      { CellShape::Wedge, { points(a), points(b), points(c), points(above(a)), points(above(b)), points(above(c)) } });
  };
  for (int k = 0; k < layers; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i + j < n; ++i)
      {
        add({ i, j, k }, { i + 1, j, k }, { i, j + 1, k });
        if (i + j + 1 < n)
        {
          add({ i + 1, j, k }, { i + 1, j + 1, k }, { i, j + 1, k });
        }
      }
    }
  }
}

/// Adds a tetrahedron with its corners in positive order; `place` is where a lattice point lies.
template<typename Place>
void addTetrahedron(
  std::array<Step, 4> steps, const Place& place, Numbered& points, std::vector<CurvedPattern::Piece>& pieces)
{
  const Vector origin = place(steps[0]);
  const Vector a = place(steps[1]) - origin;
  const Vector b = place(steps[2]) - origin;
  if (a.cross(b).dot(place(steps[3]) - origin) < 0.0)
  {
    std::swap(steps[2], steps[3]);
  }
  pieces.push_back(
    { CellShape::Tetrahedron, { points(steps[0]), points(steps[1]), points(steps[2]), points(steps[3]) } });
}

void addTetrahedra(int n, Numbered& points, std::vector<CurvedPattern::Piece>& pieces)
{
  const auto place = [](const Step& s) { return Vector(s[0], s[1], s[2]); };
  const auto add = [&](const std::array<Step, 4>& steps) { addTetrahedron(steps, place, points, pieces); };
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j + k < n; ++j)
    {
      for (int i = 0; i + j + k < n; ++i)
      {
        const Step x{ i + 1, j, k };
        const Step y{ i, j + 1, k };
        const Step z{ i, j, k + 1 };
        add({ Step{ i, j, k }, x, y, z });
        const Step xy{ i + 1, j + 1, k };
        const Step xz{ i + 1, j, k + 1 };
        const Step yz{ i, j + 1, k + 1 };
        if (i + j + k + 2 <= n)
        {
          // The octahedron between, round its diagonal from x to yz.
          add({ x, yz, y, xy });
          add({ x, yz, xy, xz });
          add({ x, yz, xz, z });
          add({ x, yz, z, y });
        }
        if (i + j + k + 3 <= n)
        {
          add({ xy, xz, yz, Step{ i + 1, j + 1, k + 1 } });
        }
      }
    }
  }
}

/// A layer k has (n - k + 1)^2 points; seen from above, those of the next one lie in the middles of its squares.
void addPyramids(int n, Numbered& points, std::vector<CurvedPattern::Piece>& pieces)
{
  const auto place = [](const Step& s) { return Vector(s[0] + 0.5 * s[2], s[1] + 0.5 * s[2], s[2]); };
  for (int k = 0; k < n; ++k)
  {
    const int side = n - k;
    for (int j = 0; j < side; ++j)
    {
      for (int i = 0; i < side; ++i)
      {
        const Step top{ i, j, k + 1 };
        pieces.push_back({ CellShape::Pyramid, { points({ i, j, k }), points({ i + 1, j, k }),
                                                 points({ i + 1, j + 1, k }), points({ i, j + 1, k }), points(top) } });
        const Step right{ i + 1, j, k + 1 };
        const Step behind{ i, j + 1, k + 1 };
        if (i + 1 < side)
        {
          addTetrahedron({ Step{ i + 1, j, k }, Step{ i + 1, j + 1, k }, top, right }, place, points, pieces);
        }
        if (j + 1 < side)
        {
          addTetrahedron({ Step{ i, j + 1, k }, Step{ i + 1, j + 1, k }, top, behind }, place, points, pieces);
        }
        if (i + 1 < side && j + 1 < side)
        {
          pieces.push_back({ CellShape::Pyramid, { points(top), points(behind), points({ i + 1, j + 1, k + 1 }),
                                                   points(right), points({ i + 1, j + 1, k }) } });
        }
      }
    }
  }
}
}

ShapeLattice latticeOf(CellShape shape, const std::array<int, 3>& degrees)
{
  ShapeLattice lattice;
  Numbered points;
  switch (shape)
  {
    case CellShape::Tetrahedron:
      addTetrahedra(degrees[0], points, lattice.pieces);
      break;
    case CellShape::Wedge:
      addWedges(degrees[0], degrees[2], points, lattice.pieces);
      break;
    case CellShape::Pyramid:
      addPyramids(degrees[0], points, lattice.pieces);
      break;
    case CellShape::Hexahedron:
    case CellShape::Polyhedron:
      addHexahedra(degrees, points, lattice.pieces);
      break;
  }
  for (const Step& step : points.steps())
  {
    std::array<double, 3> parameters{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      // The squares of a pyramid's layers all have parameters from 0 to 1.
      const int steps = shape == CellShape::Pyramid && axis < 2 ? degrees[0] - step[2] : degrees[axis];
      parameters[axis] = steps > 0 ? static_cast<double>(step[axis]) / steps : 0.5;
    }
    lattice.points.push_back(parameters);
  }
  return lattice;
}
}
