#include "Geometry/FilteredDeterminant.h"

#include <cassert>
#include <cmath>
#include <cstdint>

namespace strata
{
namespace
{
/// Twice the rounding error of a filtered determinant, relative to its permanent: differences of entries, products
/// and sums of up to 4 x 4 numbers err by less than 14 units of 2^-53.
constexpr double filterError = 1.0 / (std::uint64_t{ 1 } << 49);
/// A determinant this far above the filter's error keeps about ten digits.
constexpr double wellConditioned = 1e-4;

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
}

int signOfDeterminant(const SmallMatrix& matrix)
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
}
