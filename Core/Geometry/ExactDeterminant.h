#pragma once

#include <array>

namespace strata
{
/// A square matrix of up to five rows.
struct SmallMatrix
{
  int size = 0;
  std::array<std::array<double, 5>, 5> rows;
};

/// The determinant, exactly, then rounded: its sign is exact and its relative error is a few units in the last
/// place. The products of entries must neither overflow nor underflow. Slow: meant for what a filter can't decide.
double exactDeterminant(const SmallMatrix& matrix);
}
