#include "Fit/Influence.h"

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
/// Golden-section steps: each shortens the interval of search to 0.618 of its length.
constexpr int searchSteps = 14;
constexpr double golden = 0.6180339887498949;

double square(double x)
{
  return x * x;
}
}

double Influence::error(const Group& group, double change) const
{
  double largest2 = 0.0;
  for (std::size_t i = group.begin; i < group.end; ++i)
  {
    const double squared = square(residuals_[i] - weights_[i] * change) + others_[i];
    largest2 = squared > largest2 ? squared : largest2;
  }
  const double scale = group.isPlane ? (group.gradient + change * group.slope).norm() : 1.0;
  return largest2 > 0.0 ? std::sqrt(largest2) * group.inverseBound / scale : 0.0;
}

double Influence::largest(double change) const
{
  double result = 0.0;
  for (const Group& group : groups_)
  {
    result = std::max(result, error(group, change));
  }
  return result;
}

double Influence::objective(double change) const
{
  double result = 0.0;
  for (const Group& group : groups_)
  {
    result += square(square(square(error(group, change))));
  }
  return result;
}

double Influence::bestChange(double reach) const
{
  double low = -reach;
  double high = reach;
  double a = high - golden * (high - low);
  double b = low + golden * (high - low);
  double atA = objective(a);
  double atB = objective(b);
  for (int step = 0; step < searchSteps; ++step)
  {
    if (atA <= atB)
    {
      high = b;
      b = a;
      atB = atA;
      a = high - golden * (high - low);
      atA = objective(a);
    }
    else
    {
      low = a;
      a = b;
      atA = atB;
      b = low + golden * (high - low);
      atB = objective(b);
    }
  }
  return atA <= atB ? a : b;
}
}
