#include "Select/Interest.h"

#include "Model/Errors.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>

namespace strata
{
namespace
{
constexpr double pi = 3.14159265358979323846;

double halfAngle(const View& view)
{
  return 0.5 * view.viewAngle * pi / 180.0;
}

/// Whether a ball reaches into the wedge |across| <= tangent * ahead.
bool reachesWedge(double ahead, double across, double tangent, double radius)
{
  const double beyond = (std::abs(across) - tangent * ahead) / std::sqrt(1.0 + tangent * tangent);
  return beyond <= radius;
}
}

bool RegionOfInterest::touches(const Vector& ballCenter, double ballRadius) const
{
  if (shape == Shape::Box)
  {
    return box.squaredDistance(ballCenter) <= ballRadius * ballRadius;
  }
  return (ballCenter - center).norm() <= radius + ballRadius;
}

void View::check() const
{
  if (!((focalPoint - position).norm() > 0.0))
  {
    throw InvalidInput("the camera's position and focal point coincide");
  }
  if (!(viewAngle > 0.0 && viewAngle < 180.0))
  {
    throw InvalidInput(
      "the camera's view angle is " + std::to_string(viewAngle) + " degrees; it must lie between 0 and 180");
  }
  if (imageHeight <= 0 || !(pixelBound > 0.0) || !(aspect > 0.0))
  {
    throw InvalidInput("the image height (" + std::to_string(imageHeight) + "), the pixel error bound (" +
                       std::to_string(pixelBound) + ") and the aspect (" + std::to_string(aspect) +
                       ") must be greater than zero");
  }
}

bool View::sees(const Vector& ballCenter, double ballRadius) const
{
  const Vector forward = (focalPoint - position).normalized();
  Vector right = forward.cross(viewUp);
  // A view along the up direction has no right of its own: any will do.
  right = right.norm() > 0.0 ? Vector(right.normalized()) : forward.unitOrthogonal();
  const Vector up = right.cross(forward);
  const Vector toBall = ballCenter - position;
  const double ahead = toBall.dot(forward);
  const double vertical = std::tan(halfAngle(*this));
  return ahead >= -ballRadius && reachesWedge(ahead, toBall.dot(up), vertical, ballRadius) &&
         reachesWedge(ahead, toBall.dot(right), vertical * aspect, ballRadius);
}

double View::pixelsPerLength(const Vector& ballCenter, double ballRadius) const
{
  const double distance = (ballCenter - position).norm() - ballRadius;
  const double pixelsAtUnitDistance = imageHeight / (2.0 * std::tan(halfAngle(*this)));
  return distance > 0.0 ? pixelsAtUnitDistance / distance : std::numeric_limits<double>::infinity();
}
}
