#include "Measure/DirectedDistance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace strata
{
namespace
{
using Triangle = std::array<Vector, 3>;

/// Pieces bisected between two updates of the lower bound: enough for the threads, few enough to stay best-first.
constexpr std::size_t piecesPerBatch = 2048;
constexpr std::int64_t piecesPerTask = 32;
/// Rounding of one distance, in units of the largest coordinate times the machine's epsilon.
constexpr double roundingUnits = 16.0;

/// A part of a triangle of the first surface, and what is known of its distance to the second.
struct Piece
{
  Triangle corners;
  std::array<double, 3> distances;     ///< exact, at the corners
  std::array<std::int32_t, 3> nearest; ///< triangles that the corners are closest to
  std::int32_t best = -1;              ///< triangle that gave the upper bound
  double upper = 0.0;                  ///< no point of the piece is farther
  double lower = 0.0;                  ///< some point of the piece is as far
  std::int64_t number = 0;             ///< order of creation: makes the order of the heap unique
};

bool isLessUrgent(const Piece& a, const Piece& b)
{
  return a.upper < b.upper || (a.upper == b.upper && a.number > b.number);
}

double largestCoordinate(const std::vector<Triangle>& triangles)
{
  double largest = 0.0;
  for (const Triangle& triangle : triangles)
  {
    for (const Vector& corner : triangle)
    {
      largest = std::max(largest, corner.cwiseAbs().maxCoeff());
    }
  }
  return largest;
}

class Search
{
public:
  Search(const TriangleTree& to, double tolerance, double rounding, Progress& progress) :
    to_(to), tolerance_(tolerance), rounding_(rounding), progress_(progress)
  {}

  DistanceInterval run(const std::vector<Triangle>& from, std::int64_t mostBisections);

private:
  std::vector<Piece> wholeTriangles(const std::vector<Triangle>& from);
  std::array<Piece, 2> bisected(const Piece& piece) const;
  std::pair<double, std::int32_t> distanceAt(const Vector& p, std::int32_t candidate) const;
  double farthestCorner(const Piece& piece, std::int32_t triangle, double giveUp) const;
  void bound(Piece& piece) const;
  bool tooSmall(const Piece& piece) const;
  void keepOrSettle(std::vector<Piece>& pieces);
  std::vector<Piece> mostUrgent();

  const TriangleTree& to_;
  double tolerance_;
  double rounding_;
  Progress& progress_;

  std::vector<Piece> heap_;
  std::int64_t created_ = 0;
  double lower_ = 0.0;
  double settled_ = 0.0; ///< largest upper bound of the pieces that need no more work
};

/// Exact distance from a point, and the triangle it is closest to; a candidate triangle speeds up the query.
std::pair<double, std::int32_t> Search::distanceAt(const Vector& p, std::int32_t candidate) const
{
  double limit = std::numeric_limits<double>::infinity();
  if (candidate >= 0)
  {
    limit = (closestPointOnTriangle(p, to_.triangles()[candidate]).point - p).squaredNorm();
  }
  const TriangleTree::Hit hit = to_.closest(p, limit);
  return { std::sqrt(hit.squaredDistance), hit.triangle };
}

/// Largest distance of the piece's corners to one triangle; anything above `giveUp` once it is above.
double Search::farthestCorner(const Piece& piece, std::int32_t triangle, double giveUp) const
{
  double farthest = 0.0;
  for (int i = 0; i < 3 && farthest <= giveUp; ++i)
  {
    const bool known = piece.nearest[i] == triangle;
    const Vector& corner = piece.corners[i];
    const double distance =
      known ? piece.distances[i] : (closestPointOnTriangle(corner, to_.triangles()[triangle]).point - corner).norm();
    farthest = std::max(farthest, distance);
  }
  return farthest;
}

/// Bounds the distances over a piece. The distance to one convex set is convex, so over the piece it is largest at
/// a corner; the distance to the whole surface grows no faster than the way from the center.
void Search::bound(Piece& piece) const
{
  const Vector center = (piece.corners[0] + piece.corners[1] + piece.corners[2]) / 3.0;
  const auto [centerDistance, centerNearest] = distanceAt(center, piece.best >= 0 ? piece.best : piece.nearest[0]);
  double radius = 0.0;
  for (const Vector& corner : piece.corners)
  {
    radius = std::max(radius, (corner - center).norm());
  }
  piece.lower = std::max(centerDistance, *std::max_element(piece.distances.begin(), piece.distances.end()));
  const std::array<std::int32_t, 5> candidates = { piece.best, centerNearest, piece.nearest[0], piece.nearest[1],
    piece.nearest[2] };
  piece.upper = centerDistance + radius;
  piece.best = centerNearest;
  for (const std::int32_t candidate : candidates)
  {
    const double upper = candidate >= 0 ? farthestCorner(piece, candidate, piece.upper) : piece.upper;
    if (upper < piece.upper)
    {
      piece.upper = upper;
      piece.best = candidate;
    }
  }
  piece.upper += rounding_;
}

std::vector<Piece> Search::wholeTriangles(const std::vector<Triangle>& from)
{
  std::vector<Piece> pieces(from.size());
  const auto count = static_cast<std::int64_t>(from.size());
  tbb::parallel_for(
    tbb::blocked_range<std::int64_t>(0, count, piecesPerTask), [&](const tbb::blocked_range<std::int64_t>& range) {
      progress_.check();
      for (std::int64_t i = range.begin(); i < range.end(); ++i)
      {
        Piece& piece = pieces[i];
        piece.corners = from[i];
        for (int corner = 0; corner < 3; ++corner)
        {
          const std::int32_t candidate = corner > 0 ? piece.nearest[corner - 1] : -1;
          std::tie(piece.distances[corner], piece.nearest[corner]) = distanceAt(piece.corners[corner], candidate);
        }
        bound(piece);
      }
    });
  return pieces;
}

/// The two halves of a piece, cut through the middle of its longest edge.
std::array<Piece, 2> Search::bisected(const Piece& piece) const
{
  std::array<double, 3> squaredLengths{};
  for (int i = 0; i < 3; ++i)
  {
    squaredLengths[i] = (piece.corners[(i + 1) % 3] - piece.corners[i]).squaredNorm();
  }
  const auto start =
    static_cast<int>(std::max_element(squaredLengths.begin(), squaredLengths.end()) - squaredLengths.begin());
  const int end = (start + 1) % 3;
  const Vector middle = 0.5 * (piece.corners[start] + piece.corners[end]);
  const auto [distance, nearest] = distanceAt(middle, piece.best);
  std::array<Piece, 2> halves = { piece, piece };
  const std::array<int, 2> replaced = { end, start };
  for (int i = 0; i < 2; ++i)
  {
    halves[i].corners[replaced[i]] = middle;
    halves[i].distances[replaced[i]] = distance;
    halves[i].nearest[replaced[i]] = nearest;
    bound(halves[i]);
    halves[i].upper = std::min(halves[i].upper, piece.upper);
  }
  return halves;
}

/// Bisection would only move roundings about.
bool Search::tooSmall(const Piece& piece) const
{
  const double length = std::max({ (piece.corners[1] - piece.corners[0]).norm(),
    (piece.corners[2] - piece.corners[1]).norm(), (piece.corners[0] - piece.corners[2]).norm() });
  return length <= rounding_;
}

void Search::keepOrSettle(std::vector<Piece>& pieces)
{
  for (const Piece& piece : pieces)
  {
    lower_ = std::max(lower_, piece.lower);
  }
  for (Piece& piece : pieces)
  {
    if (piece.upper <= lower_ + tolerance_ || tooSmall(piece))
    {
      settled_ = std::max(settled_, piece.upper);
      continue;
    }
    piece.number = created_++;
    heap_.push_back(piece);
    std::push_heap(heap_.begin(), heap_.end(), isLessUrgent);
  }
}

std::vector<Piece> Search::mostUrgent()
{
  std::vector<Piece> batch;
  while (!heap_.empty() && batch.size() < piecesPerBatch && heap_.front().upper > lower_ + tolerance_)
  {
    std::pop_heap(heap_.begin(), heap_.end(), isLessUrgent);
    batch.push_back(heap_.back());
    heap_.pop_back();
  }
  return batch;
}

DistanceInterval Search::run(const std::vector<Triangle>& from, std::int64_t mostBisections)
{
  std::vector<Piece> pieces = wholeTriangles(from);
  keepOrSettle(pieces);
  for (std::int64_t bisections = 0; bisections < mostBisections;)
  {
    const std::vector<Piece> batch = mostUrgent();
    if (batch.empty())
    {
      break;
    }
    bisections += static_cast<std::int64_t>(batch.size());
    pieces.resize(2 * batch.size());
    const auto count = static_cast<std::int64_t>(batch.size());
    tbb::parallel_for(
      tbb::blocked_range<std::int64_t>(0, count, piecesPerTask), [&](const tbb::blocked_range<std::int64_t>& range) {
        progress_.check();
        for (std::int64_t i = range.begin(); i < range.end(); ++i)
        {
          const std::array<Piece, 2> halves = bisected(batch[i]);
          std::copy(halves.begin(), halves.end(), pieces.begin() + 2 * i);
        }
      });
    keepOrSettle(pieces);
  }
  const double open = heap_.empty() ? 0.0 : heap_.front().upper;
  return { std::max(0.0, lower_ - rounding_), std::max({ lower_ + rounding_, settled_, open }) };
}
}

DistanceInterval directedDistance(const std::vector<std::array<Vector, 3>>& from, const TriangleTree& to,
  double tolerance, Progress& progress, std::int64_t mostBisections)
{
  if (from.empty())
  {
    return {};
  }
  if (to.empty())
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return { infinity, infinity };
  }
  const double extent = std::max(largestCoordinate(from), largestCoordinate(to.triangles()));
  const double rounding = roundingUnits * std::numeric_limits<double>::epsilon() * extent;
  return Search(to, tolerance, rounding, progress).run(from, mostBisections);
}
}
