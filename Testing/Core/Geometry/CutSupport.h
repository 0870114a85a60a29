#pragma once

#include "Geometry/CutTetrahedron.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace strata::testing
{
/// Values of K functions at global vertices: [vertex][function].
using VertexValues = std::vector<std::vector<double>>;

inline std::vector<CornerValues> valuesAt(const VertexValues& values, const std::array<std::int64_t, 4>& vertices)
{
  std::vector<CornerValues> result(values.front().size());
  for (std::size_t f = 0; f < result.size(); ++f)
  {
    result[f].function = static_cast<int>(f);
    for (int corner = 0; corner < 4; ++corner)
    {
      result[f].values[corner] = values[vertices[corner]][f];
    }
  }
  return result;
}

/// What values to draw: reals; small integers that tie all the time; tenths, whose rounding errors are all that keeps
/// many of them from tying.
enum class Draw
{
  Reals,
  Ties,
  NearTies
};

inline VertexValues randomValues(int vertices, int functions, Draw draw, std::mt19937& random)
{
  std::uniform_real_distribution<double> real(-1.0, 1.0);
  std::uniform_int_distribution<int> integer(-1, 1);
  std::uniform_int_distribution<int> tenths(-4, 4);
  VertexValues result(vertices, std::vector<double>(functions));
  for (std::vector<double>& row : result)
  {
    for (double& value : row)
    {
      value = draw == Draw::Reals ? real(random) : draw == Draw::Ties ? integer(random) : 0.1 * tenths(random);
    }
  }
  return result;
}

/// A kind of values for the i-th case of a test.
inline Draw drawOf(int i)
{
  constexpr std::array<Draw, 5> draws{ Draw::Reals, Draw::Ties, Draw::NearTies, Draw::Ties, Draw::NearTies };
  return draws[static_cast<std::size_t>(i) % draws.size()];
}

using KeyLoop = std::vector<CutKey>;

/// The loop of a face by names, starting with its lowest.
inline KeyLoop loopOf(const TetrahedronCut& cut, const TetrahedronCut::Face& face)
{
  KeyLoop result;
  for (int i = face.begin; i < face.end; ++i)
  {
    result.push_back(cut.points()[cut.loops()[i]].key);
  }
  std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
  return result;
}

/// Counts directed edges, an edge and its reverse cancelling: empty for a closed, oriented surface.
class EdgeBalance
{
public:
  void add(const KeyLoop& loop) { add(loop, true); }
  /// Adds a path; `closing` tells whether its end is joined to its start.
  void add(const KeyLoop& path, bool closing)
  {
    for (std::size_t i = 0; i + (closing ? 0 : 1) < path.size(); ++i)
    {
      add(path[i], path[(i + 1) % path.size()]);
    }
  }
  bool closed() const { return count_.empty(); }

private:
  void add(const CutKey& a, const CutKey& b)
  {
    const bool ascending = a < b;
    const auto edge = ascending ? std::make_pair(a, b) : std::make_pair(b, a);
    const int count = count_[edge] += ascending ? 1 : -1;
    if (count == 0)
    {
      count_.erase(edge);
    }
  }
  std::map<std::pair<CutKey, CutKey>, int> count_;
};
}
