#include "Build/ClippedTriangle.h"

#include <algorithm>

namespace strata
{
ClippedTriangle::ClippedTriangle(const Barycentric& cell, const std::array<Vector, 3>& triangle)
{
  // Most triangles lie inside, or beyond one face.
  std::array<int, 4> within = { 0, 0, 0, 0 };
  for (std::size_t k = 0; k < 4 && size_ > 0; ++k)
  {
    for (const Vector& corner : triangle)
    {
      within[k] += cell.weights[k](corner) >= -faceTolerance ? 1 : 0;
    }
    size_ = within[k] == 0 ? 0 : size_;
    whole_ = whole_ && within[k] == 3;
  }
  std::copy(triangle.begin(), triangle.end(), corners_.begin());
  for (std::size_t k = 0; k < 4 && size_ > 0; ++k)
  {
    if (within[k] < 3)
    {
      clip(cell.weights[k]);
    }
  }
}

void ClippedTriangle::clip(const LinearFunction& weight)
{
  std::array<Vector, 16> kept;
  std::size_t size = 0;
  for (std::size_t i = 0; i < size_; ++i)
  {
    const Vector& a = corners_[i];
    const Vector& b = corners_[(i + 1) % size_];
    const double wa = weight(a) + faceTolerance;
    const double wb = weight(b) + faceTolerance;
    if (wa >= 0.0)
    {
      kept[size++] = a;
    }
    if ((wa >= 0.0) != (wb >= 0.0))
    {
      kept[size++] = a + (b - a) * (wa / (wa - wb));
    }
  }
  corners_ = kept;
  size_ = size;
}
}
