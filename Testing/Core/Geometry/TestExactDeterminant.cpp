#include "Geometry/ExactDeterminant.h"

#include <gtest/gtest.h>

#include <random>

using namespace strata;

namespace
{
__extension__ using Wide = __int128;

Wide integerDeterminant(const std::array<std::array<std::int64_t, 5>, 5>& rows, int size, int row, unsigned columns)
{
  if (row == size)
  {
    return 1;
  }
  Wide sum = 0;
  int sign = 1;
  for (int column = 0; column < size; ++column)
  {
    if (columns >> column & 1u)
    {
      sum += sign * Wide(rows[row][column]) * integerDeterminant(rows, size, row + 1, columns & ~(1u << column));
      sign = -sign;
    }
  }
  return sum;
}
}

TEST(ExactDeterminant, IsThatOfIntegers)
{
  std::mt19937 random(1);
  std::uniform_int_distribution<std::int64_t> entry(-4000000, 4000000);
  for (int i = 0; i < 2000; ++i)
  {
    SmallMatrix matrix;
    std::array<std::array<std::int64_t, 5>, 5> integers{};
    matrix.size = 1 + i % 5;
    for (int row = 0; row < matrix.size; ++row)
    {
      for (int column = 0; column < matrix.size; ++column)
      {
        // The last row is almost the sum of the others: products of 2^110 cancel down to little.
        integers[row][column] = row + 1 < matrix.size || row == 0 ? entry(random) : (column == 0 ? 1 : 0);
        for (int above = 0; row > 0 && row + 1 == matrix.size && above < row; ++above)
        {
          integers[row][column] += integers[above][column];
        }
        matrix.rows[row][column] = static_cast<double>(integers[row][column]);
      }
    }
    const Wide expected = integerDeterminant(integers, matrix.size, 0, 31u);
    EXPECT_DOUBLE_EQ(exactDeterminant(matrix), static_cast<double>(expected));
  }
}

TEST(ExactDeterminant, SeesWhatFloatingPointCannot)
{
  // (1 + e)(1 - e) - 1 = -e^2, lost in doubles.
  const double e = 1.0 / (1ll << 40);
  SmallMatrix matrix;
  matrix.size = 2;
  matrix.rows[0] = { 1.0 + e, 1.0 };
  matrix.rows[1] = { 1.0, 1.0 - e };
  EXPECT_EQ(exactDeterminant(matrix), -e * e);
}
