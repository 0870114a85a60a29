#include "Select/Criterion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace strata
{
namespace
{
constexpr double noBound = std::numeric_limits<double>::infinity();

struct Ball
{
  Vector center;
  double radius = 0.0;
};

Ball ballRound(const Hierarchy& hierarchy, CellId id)
{
  std::array<Vector, 4> corners;
  Ball ball{ Vector::Zero(), 0.0 };
  for (std::size_t i = 0; i < 4; ++i)
  {
    corners[i] = hierarchy.position(hierarchy.cell(id).corners[i]);
    ball.center += 0.25 * corners[i];
  }
  for (const Vector& corner : corners)
  {
    ball.radius = std::max(ball.radius, (corner - ball.center).norm());
  }
  return ball;
}
}

Criterion::Criterion(ErrorBounds bounds, Interest interest, int maximumLevel) :
  bounds_(std::move(bounds)), interest_(std::move(interest)), everything_(interest_.everything()),
  maximumLevel_(std::min(maximumLevel, Lattice::maximumLevel))
{
  if (interest_.view)
  {
    interest_.view->check();
  }
}

Criterion::Demand Criterion::demandAt(const Hierarchy& hierarchy, CellId cell) const
{
  if (!interest_.focus.empty() && (interest_.focus & hierarchy.materialsOf(cell)).empty())
  {
    return { noBound, noBound };
  }
  Demand demand{ bounds_.interfaceError, 1.0 };
  if (!interest_.region && !interest_.view)
  {
    return demand;
  }
  const Ball ball = ballRound(hierarchy, cell);
  if (interest_.region && !interest_.region->touches(ball.center, ball.radius))
  {
    demand.interfaceError *= interest_.region->coarsening;
    demand.fieldScale *= interest_.region->coarsening;
  }
  if (interest_.view)
  {
    const View& view = *interest_.view;
    const double pixels = view.pixelsPerLength(ball.center, ball.radius);
    // Nobody sees what is beside the picture, or in a cell smaller than the bound.
    if (!view.sees(ball.center, ball.radius) || 2.0 * ball.radius * pixels <= view.pixelBound)
    {
      return { noBound, noBound };
    }
    demand.interfaceError = std::max(demand.interfaceError, view.pixelBound / pixels);
  }
  return demand;
}

double Criterion::interfaceBound(const Hierarchy& hierarchy, CellId cell) const
{
  return demandAt(hierarchy, cell).interfaceError;
}

float Criterion::ratio(const Hierarchy& hierarchy, CellId cell) const
{
  const Demand demand = demandAt(hierarchy, cell);
  double largest = static_cast<double>(hierarchy.interfaceError(cell)) / demand.interfaceError;
  for (std::size_t f = 0; f < bounds_.fieldErrors.size(); ++f)
  {
    const double bound = bounds_.fieldErrors[f] * demand.fieldScale;
    largest = std::max(largest, static_cast<double>(hierarchy.fieldError(cell, f)) / bound);
  }
  const auto nearest = static_cast<float>(largest);
  return static_cast<double>(nearest) < largest ? std::nextafter(nearest, std::numeric_limits<float>::infinity())
                                                : nearest;
}
}
