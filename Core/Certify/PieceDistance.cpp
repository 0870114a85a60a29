#include "Certify/PieceDistance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace strata
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();
/// How close an upper bound has to come to the truth, in units of the limit: below it, and at it.
constexpr double coarseTolerance = 0.1;
constexpr double fineTolerance = 1e-3;
/// In units of the limit: upper bounds below this are taken as they are.
constexpr double smallBound = 0.25;
/// From any point of a triangle to the nearest corner it is at most this part of the longest edge: 1 / sqrt(3).
constexpr double wayToCorner = 0.57735026918962585;
/// In units of the largest coordinate times the machine's epsilon.
constexpr double roundingUnits = 16.0;

/// A point of a piece, with its exact distance to the surface.
struct Corner
{
  Vector point;
  double distance = 0.0;
  std::int32_t nearest = -1; ///< triangle that it is closest to
};

/// Bounds the distances of one polygon after the other, keeping the largest.
class Search
{
public:
  Search(double limit, double rounding) : limit_(limit), rounding_(rounding) {}

  double result() const { return std::max(lower_, settled_) + rounding_; }
  bool aboveLimit() const { return lower_ > limit_; }

  void add(const std::vector<Vector>& polygon, const TriangleTree& surface)
  {
    nearest_ = surface_ == &surface ? nearest_ : -1;
    surface_ = &surface;
    // Most polygons are near the triangle that the last one was near to.
    if (nearest_ >= 0 && settles(distanceTo(nearest_, polygon)))
    {
      return;
    }
    std::vector<Corner> corners;
    for (const Vector& p : polygon)
    {
      corners.push_back(cornerAt(p, nearest_));
      nearest_ = corners.back().nearest;
    }
    if (aboveLimit() || settles(nearestBound(corners.data(), corners.size())))
    {
      return;
    }
    for (std::size_t i = 1; i + 1 < corners.size() && !aboveLimit(); ++i)
    {
      bisect({ corners[0], corners[i], corners[i + 1] });
    }
  }

private:
  using Triangle = std::array<Corner, 3>;

  Corner cornerAt(const Vector& p, std::int32_t candidate)
  {
    const double known =
      candidate < 0 ? infinity : (closestPointOnTriangle(p, surface_->triangles()[candidate]).point - p).squaredNorm();
    const TriangleTree::Hit hit = surface_->closest(p, known);
    const double distance = std::sqrt(hit.squaredDistance);
    lower_ = std::max(lower_, distance);
    return { p, distance, hit.triangle };
  }

  /// The distance to one triangle is convex: over a polygon it is largest at a corner.
  double distanceTo(std::int32_t triangle, const std::vector<Vector>& polygon) const
  {
    double farthest = 0.0;
    for (const Vector& p : polygon)
    {
      farthest = std::max(farthest, (closestPointOnTriangle(p, surface_->triangles()[triangle]).point - p).norm());
    }
    return farthest;
  }

  /// The smallest of the bounds by the triangles that the corners are nearest to.
  double nearestBound(const Corner* corners, std::size_t count) const
  {
    double best = infinity;
    for (std::size_t i = 0; i < count; ++i)
    {
      double farthest = corners[i].distance;
      for (std::size_t k = 0; k < count && farthest < best; ++k)
      {
        if (corners[k].nearest != corners[i].nearest)
        {
          const Vector& p = corners[k].point;
          const auto& triangle = surface_->triangles()[corners[i].nearest];
          farthest = std::max(farthest, (closestPointOnTriangle(p, triangle).point - p).norm());
        }
        else
        {
          farthest = std::max(farthest, corners[k].distance);
        }
      }
      best = std::min(best, farthest);
    }
    return best;
  }

  /// Takes an upper bound for good if it is small or close enough to a distance that was seen; else bounds taken one
  /// after the other would drift away from the truth.
  bool settles(double upper)
  {
    const double tolerance = upper <= limit_ ? coarseTolerance : fineTolerance;
    const bool enough = upper <= std::max({ settled_, smallBound * limit_, lower_ + tolerance * limit_ });
    settled_ = enough ? std::max(settled_, upper) : settled_;
    return enough;
  }

  void bisect(const Triangle& whole)
  {
    std::vector<Triangle> open = { whole };
    while (!open.empty() && !aboveLimit())
    {
      const Triangle piece = open.back();
      open.pop_back();
      const std::size_t start = longestEdge(piece);
      const std::size_t end = (start + 1) % 3;
      const double length = (piece[end].point - piece[start].point).norm();
      // The distance to the whole surface grows no faster than the way from a corner.
      const double nearby =
        std::max({ piece[0].distance, piece[1].distance, piece[2].distance }) + wayToCorner * length;
      if (settles(std::min(nearestBound(piece.data(), 3), nearby)) || length <= rounding_)
      {
        continue;
      }
      const Corner middle = cornerAt(0.5 * (piece[start].point + piece[end].point), piece[start].nearest);
      open.push_back(piece);
      open.back()[end] = middle;
      open.push_back(piece);
      open.back()[start] = middle;
    }
  }

  static std::size_t longestEdge(const Triangle& piece)
  {
    std::size_t longest = 0;
    double largest2 = -1.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double length2 = (piece[(i + 1) % 3].point - piece[i].point).squaredNorm();
      longest = length2 > largest2 ? i : longest;
      largest2 = std::max(largest2, length2);
    }
    return longest;
  }

  const TriangleTree* surface_ = nullptr;
  std::int32_t nearest_ = -1; ///< triangle of the surface that some corner was closest to
  double limit_;
  double rounding_;
  double lower_ = 0.0;   ///< some point is as far
  double settled_ = 0.0; ///< no point of the pieces dealt with is farther than this and `lower_`
};

/// The largest distance of some polygons to the surfaces that `surfacesOf` names for their materials, null for none.
template<typename SurfacesOf>
double largestDistanceToAll(
  const std::vector<InterfacePiece>& pieces, const SurfacesOf& surfacesOf, double limit, double rounding)
{
  if (pieces.empty())
  {
    return 0.0;
  }
  Search search(limit, rounding);
  for (const InterfacePiece& piece : pieces)
  {
    for (const TriangleTree* surface : surfacesOf(piece.materials))
    {
      if (!surface)
      {
        return infinity;
      }
      search.add(piece.corners, *surface);
      if (search.aboveLimit())
      {
        return search.result();
      }
    }
  }
  return search.result();
}
}

double distanceRounding(double largestCoordinate)
{
  return roundingUnits * std::numeric_limits<double>::epsilon() * largestCoordinate;
}

double largestDistance(
  const std::vector<InterfacePiece>& pieces, const InterfaceTrees& surfaces, double limit, double rounding)
{
  const auto surfacesOf = [&](UnorderedPair materials) { return std::array{ surfaces.between(materials) }; };
  return largestDistanceToAll(pieces, surfacesOf, limit, rounding);
}

double largestDistanceToRegions(
  const std::vector<InterfacePiece>& pieces, const RegionTrees& regions, double limit, double rounding)
{
  const auto surfacesOf = [&](UnorderedPair materials) {
    return std::array{ regions.around(materials.lower), regions.around(materials.upper) };
  };
  return largestDistanceToAll(pieces, surfacesOf, limit, rounding);
}
}
