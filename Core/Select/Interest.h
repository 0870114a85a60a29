#pragma once

#include "Geometry/Box.h"
#include "Model/Materials.h"

#include <optional>

namespace strata
{
/// A part of space that the user looks at; outside, the bounds are multiplied by `coarsening`.
struct RegionOfInterest
{
  enum class Shape : std::uint8_t
  {
    Box,
    Sphere
  };

  Shape shape = Shape::Box;
  Box box;
  Vector center = Vector::Zero();
  double radius = 0.0;
  double coarsening = 10.0; ///< at least 1

  /// Whether a ball touches the region.
  bool touches(const Vector& ballCenter, double ballRadius) const;
};

/// A perspective camera and how exact its picture shall be.
struct View
{
  Vector position = Vector::Zero();
  Vector focalPoint = Vector::UnitX();
  Vector viewUp = Vector::UnitZ();
  double viewAngle = 30.0; ///< vertical opening, degrees
  double aspect = 1.0;     ///< width / height
  int imageHeight = 1000;  ///< pixels
  double pixelBound = 1.0; ///< largest error on the screen, pixels

  /// Throws InvalidInput where position and focal point coincide, or an angle, size or bound is not positive.
  void check() const;
  /// Whether some of a ball may be in the picture.
  bool sees(const Vector& ballCenter, double ballRadius) const;
  /// How many pixels a length has on the screen at the point of a ball that is nearest to the camera;
  /// infinite where the camera is inside the ball.
  double pixelsPerLength(const Vector& ballCenter, double ballRadius) const;
};

/// What a level is refined for; by default everything.
struct Interest
{
  /// Cells that hold none of these set no demands; empty: all materials.
  MaterialSet focus;
  std::optional<RegionOfInterest> region;
  /// Refines for a picture: bounds in pixels for interfaces, and none for what is not seen.
  std::optional<View> view;

  bool everything() const { return focus.empty() && !region && !view; }
};
}
