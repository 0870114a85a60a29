#include "Conversion/CurvedDeviation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace strata::conversion
{
namespace
{
/// How far above the largest value a bound may be, relative to it.
constexpr double looseness = 0.1;
/// In units of the largest value: rounding of the coefficients, and lengths that are not looked into.
constexpr double rounding = 1e-13;
constexpr double negligible = 1e-12;
/// Bisections of one piece. The bounds of halves are closer by the square of their size: some tens are enough.
constexpr int mostBisections = 500;

/// Halves a Bezier polynomial: `first` is the position of its first coefficient, `stride` the way to the next.
void halve(std::vector<double>& numbers, std::size_t first, std::size_t stride, int degree, bool upper)
{
  const auto at = [&](int i) -> double& { return numbers[first + static_cast<std::size_t>(i) * stride]; };
  for (int round = 1; round <= degree; ++round)
  {
    // Means of neighbours; those that belong to the half stay behind at its far end.
    for (int i = upper ? 0 : degree; upper ? i <= degree - round : i >= round; i += upper ? 1 : -1)
    {
      at(i) = 0.5 * (at(i) + at(upper ? i + 1 : i - 1));
    }
  }
}
}

void CurvedDeviation::add(const CurvedPattern& pattern, const std::vector<double>& nodeValues)
{
  const double size = longest(nodeValues, nodeValues.size() / components_);
  slack_ = std::max(slack_, rounding * size);
  const auto n = static_cast<std::size_t>(pattern.deviationDegree + 1);
  const std::size_t count = n * n * n;
  std::vector<double> coefficients(count * components_);
  for (std::size_t begin = 0; begin < pattern.deviation.size(); begin += count)
  {
    std::fill(coefficients.begin(), coefficients.end(), 0.0);
    for (std::size_t i = 0; i < count; ++i)
    {
      for (const auto& [node, weight] : pattern.deviation[begin + i])
      {
        for (std::size_t c = 0; c < components_; ++c)
        {
          coefficients[i * components_ + c] += weight * nodeValues[static_cast<std::size_t>(node) * components_ + c];
        }
      }
    }
    addPiece(pattern.deviationDegree, coefficients, negligible * size);
  }
}

void CurvedDeviation::addPiece(int degree, const std::vector<double>& coefficients, double tooSmall)
{
  std::vector<Part> open;
  consider({ coefficients, 0.0, 0 }, degree, tooSmall, open);
  const auto isLess = [](const Part& a, const Part& b) { return a.bound < b.bound; };
  for (int done = 0; !open.empty(); ++done)
  {
    std::pop_heap(open.begin(), open.end(), isLess);
    const Part part = std::move(open.back());
    open.pop_back();
    if (done == mostBisections || part.bound <= (1.0 + looseness) * reached_)
    {
      // No other is larger.
      bound_ = std::max(bound_, part.bound);
      return;
    }
    for (const bool upper : { false, true })
    {
      const std::size_t before = open.size();
      consider(half(part, degree, upper), degree, tooSmall, open);
      if (open.size() > before)
      {
        std::push_heap(open.begin(), open.end(), isLess);
      }
    }
  }
}

void CurvedDeviation::consider(Part&& part, int degree, double tooSmall, std::vector<Part>& open)
{
  part.bound = longest(part.coefficients, part.coefficients.size() / components_);
  reached_ = std::max(reached_, longestAtCorners(degree, part.coefficients));
  const double enough = std::max({ bound_, tooSmall, (1.0 + looseness) * reached_ });
  if (part.bound > enough)
  {
    open.push_back(std::move(part));
  }
  else
  {
    bound_ = std::max(bound_, part.bound);
  }
}

double CurvedDeviation::longest(const std::vector<double>& coefficients, std::size_t count) const
{
  double largest2 = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    double squared = 0.0;
    for (std::size_t c = 0; c < components_; ++c)
    {
      squared += coefficients[i * components_ + c] * coefficients[i * components_ + c];
    }
    largest2 = std::max(largest2, squared);
  }
  return std::sqrt(largest2);
}

/// The coefficients at the corners are values.
double CurvedDeviation::longestAtCorners(int degree, const std::vector<double>& coefficients) const
{
  const auto n = static_cast<std::size_t>(degree + 1);
  std::vector<double> corners;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const std::size_t i = ((corner & 1) != 0 ? n - 1 : 0) + ((corner & 2) != 0 ? (n - 1) * n : 0) +
                          ((corner & 4) != 0 ? (n - 1) * n * n : 0);
    corners.insert(corners.end(), coefficients.begin() + static_cast<std::ptrdiff_t>(i * components_),
      coefficients.begin() + static_cast<std::ptrdiff_t>((i + 1) * components_));
  }
  return longest(corners, 8);
}

CurvedDeviation::Part CurvedDeviation::half(const Part& whole, int degree, bool upper) const
{
  Part part{ whole.coefficients, 0.0, (whole.axis + 1) % 3 };
  const auto n = static_cast<std::size_t>(degree + 1);
  const std::array<std::size_t, 3> strides = { 1, n, n * n };
  const std::size_t stride = strides[static_cast<std::size_t>(whole.axis)];
  for (std::size_t first = 0; first < n * n * n; ++first)
  {
    if (first / stride % n == 0)
    {
      for (std::size_t c = 0; c < components_; ++c)
      {
        halve(part.coefficients, first * components_ + c, stride * components_, degree, upper);
      }
    }
  }
  return part;
}
}
