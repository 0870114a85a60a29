#include "Geometry/FunctionTies.h"

#include "Geometry/FilteredDeterminant.h"

#include <cassert>
#include <cmath>

namespace strata
{
namespace
{
std::uint64_t bit(int function)
{
  return std::uint64_t{ 1 } << function;
}

double withoutTiny(double value)
{
  assert(std::abs(value) < 1e60);
  return std::abs(value) < 1e-60 ? 0.0 : value;
}
}

/// The conditions on a point, one row each: the plane if any, then the tying functions by ascending id.
/// Row `slot` at the end is free for what is asked about. Last column: 1 for a function, 0 otherwise.
struct FunctionTies::System
{
  SmallMatrix matrix;
  std::array<int, 4> corners;
  int cornerCount = 0;
  std::array<int, 5> functionOfRow; ///< -1 for the plane
  int slot = 0;

  void setOnes(int row)
  {
    for (int column = 0; column < cornerCount; ++column)
    {
      matrix.rows[row][column] = 1.0;
    }
    matrix.rows[row][cornerCount] = 0.0;
  }
  void setFunction(int row, const std::array<double, 4>& values, double last)
  {
    for (int column = 0; column < cornerCount; ++column)
    {
      matrix.rows[row][column] = values[corners[column]];
    }
    matrix.rows[row][cornerCount] = last;
  }
};

void FunctionTies::reset(const std::array<std::int64_t, 4>& vertices)
{
  vertices_ = vertices;
  hasPlane_ = false;
}

void FunctionTies::add(int function, const std::array<double, 4>& values)
{
  assert(function >= 0 && function < 64);
  for (int corner = 0; corner < 4; ++corner)
  {
    values_[function][corner] = withoutTiny(values[corner]);
  }
}

void FunctionTies::setPlane(const std::array<double, 4>& values)
{
  hasPlane_ = true;
  for (int corner = 0; corner < 4; ++corner)
  {
    plane_[corner] = withoutTiny(values[corner]);
  }
}

bool FunctionTies::dominates(int other, int function, unsigned corners) const
{
  for (int corner = 0; corner < 4; ++corner)
  {
    const double difference = values_[function][corner] - values_[other][corner];
    if ((corners >> corner & 1u) && (difference < 0.0 || (difference == 0.0 && function < other)))
    {
      return false;
    }
  }
  return true;
}

FunctionTies::System FunctionTies::system(unsigned corners, std::uint64_t tied, bool inPlane) const
{
  System result;
  for (int corner = 0; corner < 4; ++corner)
  {
    if (corners >> corner & 1u)
    {
      result.corners[result.cornerCount++] = corner;
    }
  }
  int row = 0;
  if (inPlane)
  {
    result.functionOfRow[row] = -1;
    result.setFunction(row++, plane_, 0.0);
  }
  for (std::uint64_t rest = tied; rest != 0; rest &= rest - 1)
  {
    const int function = __builtin_ctzll(rest);
    assert(row < result.cornerCount);
    result.functionOfRow[row] = function;
    result.setFunction(row++, values_[function], 1.0);
  }
  assert(row == result.cornerCount);
  result.slot = row;
  result.matrix.size = row + 1;
  return result;
}

int FunctionTies::perturbedSign(const System& tie, int candidate) const
{
  // A constant added to one function adds that constant times the determinant with its row replaced by ones.
  System replaced = tie;
  int row = 0;
  if (tie.functionOfRow[0] < 0)
  {
    replaced.setOnes(row++);
    if (const int sign = signOfDeterminant(replaced.matrix))
    {
      return sign;
    }
  }
  bool candidateDone = false;
  while (row < tie.slot || !candidateDone)
  {
    const bool candidateNext = !candidateDone && (row == tie.slot || candidate < tie.functionOfRow[row]);
    const int next = candidateNext ? tie.slot : row++;
    candidateDone = candidateDone || candidateNext;
    replaced = tie;
    replaced.setOnes(next);
    if (const int sign = signOfDeterminant(replaced.matrix))
    {
      return -sign;
    }
  }
  assert(false);
  return 0;
}

int FunctionTies::signIn(bool inPlane, unsigned corners, std::uint64_t tied, int candidate) const
{
  System tie = system(corners, tied, inPlane);
  tie.setOnes(tie.slot);
  const int orientation = signOfDeterminant(tie.matrix);
  if (orientation == 0)
  {
    return 0;
  }
  tie.setFunction(tie.slot, values_[candidate], 1.0);
  const int sign = signOfDeterminant(tie.matrix);
  return orientation * (sign != 0 ? sign : perturbedSign(tie, candidate));
}

int FunctionTies::sign(unsigned corners, std::uint64_t tied, int candidate) const
{
  if (!hasPlane_ && (corners & (corners - 1)) == 0)
  {
    const int corner = __builtin_ctz(corners);
    const int function = __builtin_ctzll(tied);
    const double difference = values_[candidate][corner] - values_[function][corner];
    return difference > 0.0 ? 1 : difference < 0.0 ? -1 : candidate > function ? 1 : -1;
  }
  const int result = signIn(hasPlane_, corners, tied, candidate);
  assert(result != 0);
  return result;
}

bool FunctionTies::ties(unsigned corners, std::uint64_t tied, int candidate) const
{
  System tie = system(corners, tied, hasPlane_);
  tie.setFunction(tie.slot, values_[candidate], 1.0);
  return signOfDeterminant(tie.matrix) == 0;
}

void FunctionTies::edgeWeights(bool inPlane, unsigned corners, std::uint64_t tied, std::array<double, 4>& result) const
{
  const int a = __builtin_ctz(corners);
  const int b = 31 - __builtin_clz(corners);
  if (a == b)
  {
    result[a] = 1.0;
    return;
  }
  const int lower = __builtin_ctzll(tied);
  const int higher = 63 - __builtin_clzll(tied);
  const double atA = inPlane ? plane_[a] : values_[lower][a] - values_[higher][a];
  const double atB = inPlane ? plane_[b] : values_[lower][b] - values_[higher][b];
  result[a] = std::abs(atB / (atB - atA));
  result[b] = std::abs(atA / (atB - atA));
}

void FunctionTies::weights(bool inPlane, unsigned corners, std::uint64_t tied, std::array<double, 4>& result) const
{
  result = {};
  double sum = 0.0;
  if (__builtin_popcount(corners) <= 2)
  {
    edgeWeights(inPlane, corners, tied, result);
    return;
  }
  const System tie = system(corners, tied, inPlane);
  for (int omitted = 0; omitted < tie.cornerCount; ++omitted)
  {
    SmallMatrix minor;
    minor.size = tie.cornerCount;
    for (int row = 0; row < minor.size; ++row)
    {
      for (int column = 0, to = 0; column <= tie.cornerCount; ++column)
      {
        if (column != omitted)
        {
          minor.rows[row][to++] = tie.matrix.rows[row][column];
        }
      }
    }
    const double value = accurateDeterminant(minor);
    result[tie.corners[omitted]] = omitted % 2 ? -value : value;
    sum += result[tie.corners[omitted]];
  }
  assert(sum != 0.0);
  for (double& weight : result)
  {
    weight = weight == 0.0 ? 0.0 : weight / sum;
    assert(weight >= 0.0);
  }
}

std::uint64_t FunctionTies::canonicalTie(bool inPlane, unsigned corners, std::uint64_t tied, int size) const
{
  // The symbolic ties that coincide here: subsets that no other function undercuts. The lowest names the point.
  std::uint64_t best = 0;
  for (std::uint64_t subset = tied; subset != 0; subset = (subset - 1) & tied)
  {
    if (__builtin_popcountll(subset) != size)
    {
      continue;
    }
    bool wins = true;
    for (std::uint64_t rest = tied & ~subset; wins && rest != 0; rest &= rest - 1)
    {
      wins = signIn(inPlane, corners, subset, __builtin_ctzll(rest)) > 0;
    }
    best = wins ? subset : best;
  }
  assert(best != 0);
  return best;
}

CutPoint FunctionTies::point(
  unsigned corners, std::uint64_t tied, std::uint64_t candidates, std::array<double, 4>& coordinates) const
{
  weights(hasPlane_, corners, tied, coordinates);
  unsigned carriers = 0;
  bool inPlane = false;
  for (int corner = 0; corner < 4; ++corner)
  {
    carriers |= coordinates[corner] > 0.0 ? 1u << corner : 0u;
    inPlane = inPlane || (hasPlane_ && coordinates[corner] > 0.0 && plane_[corner] != 0.0);
  }
  std::uint64_t allTied = tied;
  for (std::uint64_t rest = candidates & ~tied; rest != 0; rest &= rest - 1)
  {
    allTied |= ties(corners, tied, __builtin_ctzll(rest)) ? bit(__builtin_ctzll(rest)) : 0;
  }
  const int size = __builtin_popcount(carriers) - (inPlane ? 1 : 0);
  if (size > 1 && (carriers != corners || allTied != tied))
  {
    tied = canonicalTie(inPlane, carriers, allTied, size);
    weights(inPlane, carriers, tied, coordinates);
  }
  else if (size <= 1 && carriers != corners)
  {
    // A vertex, or the point where the plane meets an edge: no function takes part.
    const std::uint64_t any = tied & (~tied + 1);
    weights(inPlane, carriers, any, coordinates);
  }
  CutPoint result;
  result.key.functions = size > 1 ? tied : 0;
  int count = 0;
  for (int corner = 0; corner < 4; ++corner)
  {
    if (carriers >> corner & 1u)
    {
      result.key.vertices[count] = vertices_[corner];
      result.weights[count++] = coordinates[corner];
    }
  }
  return result;
}
}
