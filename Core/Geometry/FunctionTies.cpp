#include "Geometry/FunctionTies.h"

#include "Geometry/ExactDeterminant.h"

#include <cassert>
#include <cmath>

namespace strata
{
namespace
{
/// Twice the rounding error of a filtered determinant, relative to its permanent: differences of entries, products
/// and sums of up to 4 x 4 numbers err by less than 14 units of 2^-53.
constexpr double filterError = 1.0 / (std::uint64_t{ 1 } << 49);
/// A determinant this far above the filter's error keeps about ten digits.
constexpr double wellConditioned = 1e-4;

std::uint64_t bit(int function)
{
  return std::uint64_t{ 1 } << function;
}

/// A determinant in floating point with the sum of the sizes of its terms.
struct Filtered
{
  double value;
  double permanent;
};

using Rows = std::array<std::array<double, 5>, 5>;

Filtered determinant2(const Rows& r, int top, int a, int b)
{
  const double p = r[top][a] * r[top + 1][b];
  const double q = r[top][b] * r[top + 1][a];
  return { p - q, std::abs(p) + std::abs(q) };
}

Filtered determinant3(const Rows& r, int top, int a, int b, int c)
{
  const Filtered x = determinant2(r, top + 1, b, c);
  const Filtered y = determinant2(r, top + 1, a, c);
  const Filtered z = determinant2(r, top + 1, a, b);
  return { r[top][a] * x.value - r[top][b] * y.value + r[top][c] * z.value,
    std::abs(r[top][a]) * x.permanent + std::abs(r[top][b]) * y.permanent + std::abs(r[top][c]) * z.permanent };
}

Filtered determinant4(const Rows& r)
{
  const Filtered w = determinant3(r, 1, 1, 2, 3);
  const Filtered x = determinant3(r, 1, 0, 2, 3);
  const Filtered y = determinant3(r, 1, 0, 1, 3);
  const Filtered z = determinant3(r, 1, 0, 1, 2);
  return { r[0][0] * w.value - r[0][1] * x.value + r[0][2] * y.value - r[0][3] * z.value,
    std::abs(r[0][0]) * w.permanent + std::abs(r[0][1]) * x.permanent + std::abs(r[0][2]) * y.permanent +
      std::abs(r[0][3]) * z.permanent };
}

/// The determinant of a matrix whose last column holds 0 and 1: rows with 1 have one of them subtracted, which
/// then drops out with the column.
Filtered filteredDeterminant(const SmallMatrix& matrix)
{
  const int last = matrix.size - 1;
  int base = last;
  while (matrix.rows[base][last] == 0.0)
  {
    assert(base > 0);
    --base;
  }
  Rows reduced;
  for (int row = 0, to = 0; row <= last; ++row)
  {
    if (row == base)
    {
      continue;
    }
    for (int column = 0; column < last; ++column)
    {
      reduced[to][column] =
        matrix.rows[row][column] - (matrix.rows[row][last] != 0.0 ? matrix.rows[base][column] : 0.0);
    }
    ++to;
  }
  Filtered result{ 1.0, 0.0 };
  switch (last)
  {
    case 1:
      result = { reduced[0][0], 0.0 };
      break;
    case 2:
      result = determinant2(reduced, 0, 0, 1);
      break;
    case 3:
      result = determinant3(reduced, 0, 0, 1, 2);
      break;
    case 4:
      result = determinant4(reduced);
      break;
    default:
      break;
  }
  // Moving the base row to the bottom costs one exchange per row below it.
  return (last - base) % 2 ? Filtered{ -result.value, result.permanent } : result;
}

int signOf(const SmallMatrix& matrix)
{
  const Filtered filtered = filteredDeterminant(matrix);
  double value = filtered.value;
  if (filtered.permanent > 0.0 && std::abs(value) <= filterError * filtered.permanent)
  {
    value = exactDeterminant(matrix);
  }
  return value > 0.0 ? 1 : value < 0.0 ? -1 : 0;
}

double accurateDeterminant(const SmallMatrix& matrix)
{
  const Filtered filtered = filteredDeterminant(matrix);
  return filtered.permanent > 0.0 && std::abs(filtered.value) <= wellConditioned * filtered.permanent
           ? exactDeterminant(matrix)
           : filtered.value;
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
    if (const int sign = signOf(replaced.matrix))
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
    if (const int sign = signOf(replaced.matrix))
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
  const int orientation = signOf(tie.matrix);
  if (orientation == 0)
  {
    return 0;
  }
  tie.setFunction(tie.slot, values_[candidate], 1.0);
  const int sign = signOf(tie.matrix);
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
  return signOf(tie.matrix) == 0;
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
