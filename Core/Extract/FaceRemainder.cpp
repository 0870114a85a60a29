#include "Extract/FaceRemainder.h"

#include "Extract/SplitEdges.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace strata
{
namespace
{
using Edge = std::pair<Index, Index>;

/// An advancing front: each edge in turn gets the triangle with the widest angle among the points that it sees.
class Front
{
public:
  Front(const GridTopology& topology, std::vector<Edge> edges, const Vector& normal) :
    topology_(topology), normal_(normal.normalized()), edges_(std::move(edges))
  {
    double square = 0.0;
    for (const Edge& edge : edges_)
    {
      points_.push_back(edge.first);
      square = std::max(square, (topology.point(edge.second) - topology.point(edge.first)).squaredNorm());
    }
    std::sort(points_.begin(), points_.end());
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
    tolerance_ = hangingTolerance * square;
  }

  std::optional<std::vector<std::array<Index, 3>>> run()
  {
    std::vector<std::array<Index, 3>> result;
    const std::size_t most = 4 * points_.size();
    while (!edges_.empty())
    {
      const Edge edge = edges_.back();
      const Index apex = findApex(edge);
      if (apex < 0 || result.size() == most)
      {
        return std::nullopt;
      }
      result.push_back({ edge.first, edge.second, apex });
      edges_.pop_back();
      replace({ edge.first, apex });
      replace({ apex, edge.second });
    }
    return result;
  }

private:
  /// Twice the area of a triangle, positive where it runs counter-clockwise.
  double area(Index a, Index b, Index c) const
  {
    const Vector origin = topology_.point(a);
    return normal_.dot((topology_.point(b) - origin).cross(topology_.point(c) - origin));
  }

  Index findApex(const Edge& edge) const
  {
    Index best = -1;
    double bestCosine = 2.0;
    for (Index point : points_)
    {
      if (area(edge.first, edge.second, point) <= tolerance_ || !isFree(edge, point))
      {
        continue;
      }
      const Vector a = topology_.point(edge.first) - topology_.point(point);
      const Vector b = topology_.point(edge.second) - topology_.point(point);
      const double cosine = a.dot(b) / (a.norm() * b.norm());
      if (cosine < bestCosine - hangingTolerance)
      {
        best = point;
        bestCosine = cosine;
      }
    }
    return best;
  }

  /// Whether a triangle holds no other point, and no edge of the front crosses it.
  bool isFree(const Edge& edge, Index apex) const
  {
    const auto [a, b] = edge;
    for (Index p : points_)
    {
      if (p != a && p != b && p != apex && area(a, b, p) >= -tolerance_ && area(b, apex, p) >= -tolerance_ &&
          area(apex, a, p) >= -tolerance_)
      {
        return false;
      }
    }
    return std::none_of(edges_.begin(), edges_.end(), [&](const Edge& other) {
      return crosses(other, { edge.first, apex }) || crosses(other, { apex, edge.second });
    });
  }

  bool crosses(const Edge& e, const Edge& f) const
  {
    return area(e.first, e.second, f.first) * area(e.first, e.second, f.second) < 0.0 &&
           area(f.first, f.second, e.first) * area(f.first, f.second, e.second) < 0.0 && !touches(e, f);
  }

  static bool touches(const Edge& e, const Edge& f)
  {
    return e.first == f.first || e.first == f.second || e.second == f.first || e.second == f.second;
  }

  /// Takes an edge of the front away, or adds it in reverse: the other side of a new edge is still to be filled.
  void replace(const Edge& side)
  {
    const Edge onFront{ side.second, side.first };
    const auto found = std::find(edges_.begin(), edges_.end(), onFront);
    if (found != edges_.end())
    {
      edges_.erase(found);
    }
    else
    {
      edges_.push_back(side);
    }
  }

  const GridTopology& topology_;
  Vector normal_;
  std::vector<Edge> edges_;
  std::vector<Index> points_;
  double tolerance_ = 0.0;
};
}

std::optional<std::vector<std::array<Index, 3>>> triangulateRegion(
  const GridTopology& topology, std::vector<std::pair<Index, Index>> boundary, const Vector& normal)
{
  return Front(topology, std::move(boundary), normal).run();
}
}
