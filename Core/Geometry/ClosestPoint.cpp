#include "Geometry/ClosestPoint.h"

#include <limits>

namespace strata
{
namespace
{
ClosestPoint closestOnEdge(
  const Vector& p, const Vector& a, const Vector& b, const std::array<TriangleFeature, 3>& startEndEdge)
{
  const Vector ab = b - a;
  const double length2 = ab.squaredNorm();
  const double t = length2 > 0.0 ? (p - a).dot(ab) / length2 : 0.0;
  if (t <= 0.0)
  {
    return { a, startEndEdge[0] };
  }
  if (t >= 1.0)
  {
    return { b, startEndEdge[1] };
  }
  return { a + t * ab, startEndEdge[2] };
}

/// The best of the edges that are asked for: the first joins corners 0 and 1.
ClosestPoint closestOnEdges(const Vector& p, const std::array<Vector, 3>& t, const std::array<bool, 3>& edges)
{
  using F = TriangleFeature;
  constexpr std::array<std::array<F, 3>, 3> features = { { { F::Corner0, F::Corner1, F::Edge01 },
    { F::Corner1, F::Corner2, F::Edge12 }, { F::Corner2, F::Corner0, F::Edge20 } } };
  ClosestPoint best;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (edges[i])
    {
      const ClosestPoint candidate = closestOnEdge(p, t[i], t[(i + 1) % 3], features[i]);
      const double d2 = (candidate.point - p).squaredNorm();
      if (!(d2 >= smallest))
      {
        smallest = d2;
        best = candidate;
      }
    }
  }
  return best;
}
}

ClosestPoint closestPointOnTriangle(const Vector& p, const std::array<Vector, 3>& triangle)
{
  const auto& [a, b, c] = triangle;
  const Vector ab = b - a;
  const Vector ac = c - a;
  const Vector ap = p - a;
  const double d1 = ab.dot(ap);
  const double d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return { a, TriangleFeature::Corner0 };
  }
  const Vector bp = p - b;
  const double d3 = ab.dot(bp);
  const double d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3)
  {
    return { b, TriangleFeature::Corner1 };
  }
  const Vector cp = p - c;
  const double d5 = ab.dot(cp);
  const double d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6)
  {
    return { c, TriangleFeature::Corner2 };
  }
  const double va = d3 * d6 - d5 * d4;
  const double vb = d5 * d2 - d1 * d6;
  const double vc = d1 * d4 - d3 * d2;
  const double sum = va + vb + vc;
  if (!(sum > 0.0))
  {
    return closestOnEdges(p, triangle, { true, true, true });
  }
  if (va <= 0.0 || vb <= 0.0 || vc <= 0.0)
  {
    return closestOnEdges(p, triangle, { vc <= 0.0, va <= 0.0, vb <= 0.0 });
  }
  return { a + ab * (vb / sum) + ac * (vc / sum), TriangleFeature::Face };
}
}
