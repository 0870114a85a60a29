#include "Geometry/ExactDeterminant.h"

#include <cmath>
#include <vector>

namespace strata
{
namespace
{
/// A number as a sum of doubles that don't overlap, by ascending size, without zeros (Shewchuk 1997).
using Expansion = std::vector<double>;

/// Adds a double (grow-expansion with zero elimination).
void grow(Expansion& expansion, double summand)
{
  double sum = summand;
  std::size_t kept = 0;
  for (double term : expansion)
  {
    const double total = sum + term;
    const double virtualPart = total - sum;
    const double rest = (sum - (total - virtualPart)) + (term - virtualPart);
    if (rest != 0.0)
    {
      expansion[kept++] = rest;
    }
    sum = total;
  }
  expansion.resize(kept);
  if (sum != 0.0)
  {
    expansion.push_back(sum);
  }
}

void addProduct(Expansion& result, const Expansion& expansion, double factor)
{
  for (double term : expansion)
  {
    const double product = term * factor;
    const double rest = std::fma(term, factor, -product);
    if (rest != 0.0)
    {
      grow(result, rest);
    }
    grow(result, product);
  }
}
}

double exactDeterminant(const SmallMatrix& matrix)
{
  // Minors of the first rows, one for each set of as many columns (Laplace expansion along the last row).
  const unsigned columnSets = 1u << matrix.size;
  std::array<Expansion, 32> minors;
  minors[0] = { 1.0 };
  for (unsigned set = 1; set < columnSets; ++set)
  {
    const int row = __builtin_popcount(set) - 1;
    int columnsAfter = row;
    for (int column = 0; column < matrix.size; ++column)
    {
      if (!(set >> column & 1u))
      {
        continue;
      }
      const double entry = matrix.rows[row][column];
      if (entry != 0.0)
      {
        addProduct(minors[set], minors[set & ~(1u << column)], columnsAfter % 2 ? -entry : entry);
      }
      --columnsAfter;
    }
  }
  double sum = 0.0;
  for (double term : minors[columnSets - 1])
  {
    sum += term;
  }
  return sum;
}
}
