#include "Build/CertifiedInterfaces.h"

#include "Build/CellFunctions.h"
#include "Build/ClippedTriangle.h"
#include "Geometry/Box.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace strata
{
namespace
{
/// Distances are stored as floats: differences below this, in units of the box's diagonal, are none.
constexpr double resolution = 4.0 * static_cast<double>(std::numeric_limits<float>::epsilon());
/// Covers the rounding of distances to planes, relative to the distance and to the box's diagonal.
constexpr double relativeRounding = 1e-9;
constexpr double absoluteRounding = 1e-13;

using Weights = std::array<double, 4>;

double at(const Weights& values, const Weights& point)
{
  return values[0] * point[0] + values[1] * point[1] + values[2] * point[2] + values[3] * point[3];
}

/// A convex polygon in barycentric coordinates.
using Polygon = std::vector<Weights>;

/// The points of the cell at which a linear function, given by its values at the corners, is zero up to a tolerance.
Polygon zeroPolygon(const Weights& values, double tolerance)
{
  Polygon polygon;
  std::array<std::vector<std::size_t>, 2> sides;
  for (std::size_t i = 0; i < 4; ++i)
  {
    if (std::abs(values[i]) <= tolerance)
    {
      polygon.emplace_back(Weights{})[i] = 1.0;
      continue;
    }
    sides[values[i] > 0.0 ? 1 : 0].push_back(i);
  }
  for (std::size_t i = 0; i < sides[0].size(); ++i)
  {
    // Every other row backwards: two and two corners make a quadrilateral, whose points must go round.
    for (std::size_t j = 0; j < sides[1].size(); ++j)
    {
      const std::size_t a = sides[0][i];
      const std::size_t b = sides[1][i % 2 == 0 ? j : sides[1].size() - 1 - j];
      Weights point{};
      point[a] = values[b] / (values[b] - values[a]);
      point[b] = 1.0 - point[a];
      polygon.push_back(point);
    }
  }
  return polygon;
}

/// Keeps the part of a polygon where a linear function is at least -tolerance.
void clip(Polygon& polygon, const Weights& values, double tolerance)
{
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Weights& a = polygon[i];
    const Weights& b = polygon[(i + 1) % polygon.size()];
    const double va = at(values, a) + tolerance;
    const double vb = at(values, b) + tolerance;
    if (va >= 0.0)
    {
      kept.push_back(a);
    }
    if ((va >= 0.0) != (vb >= 0.0))
    {
      Weights crossing;
      for (std::size_t k = 0; k < 4; ++k)
      {
        crossing[k] = a[k] + (b[k] - a[k]) * (va / (va - vb));
      }
      kept.push_back(crossing);
    }
  }
  polygon.swap(kept);
}

/// The pieces of one interface in a cell.
struct Pieces
{
  bool known = false;
  LinearFunction plane;       ///< zero on the plane that stands for the interface, positive on the positive side
  double distance = 0.0;      ///< largest distance of their points to the plane
  bool anyFacingBack = false; ///< against the plane's direction
  Box extent;
};

/// A cell's interfaces, represented and original.
class CellInterfaces
{
public:
  CellInterfaces(
    const Hierarchy& hierarchy, CellId cell, const Barycentric& barycentric, const InterfaceElements& interfaces) :
    hierarchy_(hierarchy),
    cell_(hierarchy.cell(cell)), held_(hierarchy.materialsOf(cell)), barycentric_(barycentric), interfaces_(interfaces),
    diagonal_(hierarchy.lattice.box.diagonal())
  {}

  double errorOverTriangles(const CellElements& elements) const
  {
    std::vector<Pieces> byPair(interfaces_.pairs.size());
    for (std::uint32_t i = 0; i < elements.triangleCount(); ++i)
    {
      const std::uint32_t triangle = elements.triangles()[i];
      const auto pair = static_cast<std::size_t>(interfaces_.pairOfTriangle[triangle]);
      if (!byPair[pair].known)
      {
        byPair[pair].known = true;
        byPair[pair].plane = difference(interfaces_.pairs[pair].negative, interfaces_.pairs[pair].positive);
      }
      add(triangle, byPair[pair]);
    }
    double largest = 0.0;
    for (std::size_t pair = 0; pair < byPair.size(); ++pair)
    {
      largest = std::max(largest, byPair[pair].known ? errorOf(interfaces_.pairs[pair], byPair[pair]) : 0.0);
    }
    return largest;
  }

  /// Materials that reach into a cell that has no interface.
  double errorWithoutTriangles() const
  {
    const MaterialId only = nearestMaterial();
    const Weights own = distances(only);
    double largest = 0.0;
    for (const MaterialId other : held_)
    {
      const Weights values = distances(other);
      for (std::size_t k = 0; k < 4; ++k)
      {
        const double depth = own[k] - values[k];
        if (depth > resolution * diagonal_)
        {
          largest = std::max(largest, depth / difference(own, values).gradient.norm());
        }
      }
    }
    return largest;
  }

private:
  Weights distances(MaterialId m) const
  {
    const MaterialCorners corners = materialCorners(hierarchy_, cell_, m);
    return { *corners[0], *corners[1], *corners[2], *corners[3] };
  }
  LinearFunction difference(const Weights& a, const Weights& b) const
  {
    return barycentric_.interpolant<double>({ a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3] });
  }
  LinearFunction difference(MaterialId a, MaterialId b) const { return difference(distances(a), distances(b)); }

  void add(std::uint32_t triangle, Pieces& pieces) const
  {
    const auto& [a, b, c] = interfaces_.triangles[triangle];
    const std::array<Vector, 3> corners = { interfaces_.points[static_cast<std::size_t>(a)],
      interfaces_.points[static_cast<std::size_t>(b)], interfaces_.points[static_cast<std::size_t>(c)] };
    const ClippedTriangle clipped(barycentric_, corners);
    for (const Vector& p : clipped)
    {
      pieces.distance = std::max(pieces.distance, distanceToPlane(pieces.plane, p));
      pieces.extent.add(p);
    }
    const Vector normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    pieces.anyFacingBack = pieces.anyFacingBack || (!clipped.empty() && normal.dot(pieces.plane.gradient) < 0.0);
  }

  double errorOf(const InterfaceElements::Pair& pair, const Pieces& pieces) const
  {
    const double tolerance = resolution * diagonal_;
    const Weights positive = distances(pair.positive);
    const Weights negative = distances(pair.negative);
    Weights signedDistance;
    std::transform(negative.begin(), negative.end(), positive.begin(), signedDistance.begin(), std::minus<double>());
    Polygon represented = zeroPolygon(signedDistance, tolerance);
    const bool planeCrosses = !represented.empty();
    for (const MaterialId other : held_)
    {
      if (other != pair.positive && other != pair.negative)
      {
        Weights above = distances(other);
        std::transform(above.begin(), above.end(), positive.begin(), above.begin(), std::minus<double>());
        clip(represented, above, tolerance);
      }
    }
    const bool leftOut = represented.empty() && (planeCrosses || pieces.anyFacingBack);
    return leftOut ? std::max(pieces.distance, pieces.extent.diagonal()) : pieces.distance;
  }

  MaterialId nearestMaterial() const
  {
    MaterialId nearest = held_.first();
    double smallest = std::numeric_limits<double>::infinity();
    for (const MaterialId m : held_)
    {
      const Weights values = distances(m);
      const double sum = values[0] + values[1] + values[2] + values[3];
      nearest = sum < smallest ? m : nearest;
      smallest = std::min(smallest, sum);
    }
    return nearest;
  }

  const Hierarchy& hierarchy_;
  const HierarchyCell& cell_;
  MaterialSet held_;
  const Barycentric& barycentric_;
  const InterfaceElements& interfaces_;
  double diagonal_;
};

double longestEdge(const std::array<Vector, 4>& corners)
{
  double longest = 0.0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      longest = std::max(longest, (corners[i] - corners[j]).norm());
    }
  }
  return longest;
}
}

double certifiedInterfaceError(const Hierarchy& hierarchy, CellId cell, const Barycentric& barycentric,
  const CellElements& elements, const InterfaceElements& interfaces)
{
  if (hierarchy.materialsOf(cell).size() < 2)
  {
    return 0.0;
  }
  const CellInterfaces own(hierarchy, cell, barycentric, interfaces);
  const double error = elements.triangleCount() > 0 ? own.errorOverTriangles(elements) : own.errorWithoutTriangles();
  return std::min(error, longestEdge(cornerPositions(hierarchy, cell))) * (1.0 + relativeRounding) +
         absoluteRounding * hierarchy.lattice.box.diagonal();
}
}
