#pragma once

#include "Model/Interfaces.h"
#include "Model/NativeData.h"
#include "Model/Progress.h"
#include "Model/Representation.h"

#include <array>
#include <utility>
#include <vector>

namespace strata
{
/// The largest distance from a point of one surface to the other surface lies within [lower, upper].
struct DistanceInterval
{
  double lower = 0.0;
  double upper = 0.0;
};

/// Both one-sided Hausdorff distances between an original and a represented interface.
struct HausdorffDistance
{
  DistanceInterval originalToRepresented;
  DistanceInterval representedToOriginal;
};

/// Triangles of one surface, corners given directly.
struct TriangleSoup
{
  std::vector<std::array<Vector, 3>> triangles;
};

/// Certified two-sided Hausdorff distance by branch and bound; intervals close to `tolerance` (data's length unit).
/// An empty surface against one that is not gives infinity; two empty ones give 0.
HausdorffDistance hausdorffDistance(
  const TriangleSoup& original, const TriangleSoup& represented, double tolerance, Progress& progress);

/// Error of a material's field over its native samples.
struct FieldErrorReport
{
  FieldId field;
  MaterialId material;
  Index samples = 0;
  double largest = 0.0;
  double mean = 0.0;
  double rootMeanSquare = 0.0;
  Vector where = Vector::Zero(); ///< the sample with the largest error
};

struct InterfaceErrorReport
{
  MaterialId positive;
  MaterialId negative;
  HausdorffDistance distance;
  /// Largest distance of an interface vertex to the plane of its cell: what point bounds claim.
  double largestVertexError = 0.0;
};

struct VolumeErrorReport
{
  MaterialId material;
  double represented = 0.0;
  double original = 0.0;
  double representedMass = 0.0; ///< NaN where there is no density
  double originalMass = 0.0;
};

struct RepresentationErrors
{
  std::vector<FieldErrorReport> fields;
  std::vector<InterfaceErrorReport> interfaces;
  std::vector<VolumeErrorReport> volumes;
  double misclassifiedVolume = 0.0;
};
}
