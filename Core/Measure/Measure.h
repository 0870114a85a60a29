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

/// Error of a material's field over its native samples: the length of native minus represented value, the latter being
/// the material's linear function in the cell that holds the sample.
struct FieldErrorReport
{
  FieldId field;
  MaterialId material;
  Index samples = 0; ///< those that count for the material and at which the field is known
  /// Samples that no cell holds with the material's values at all its vertices. Each is an infinite error.
  Index missing = 0;
  double largest = 0.0; ///< infinite if any sample is missing
  double mean = 0.0;    ///< this and the next: over the samples that aren't missing
  double rootMeanSquare = 0.0;
  Vector where = Vector::Zero(); ///< the sample with the largest error
};

/// Error of the interface between a pair of materials that touch in the original or in the representation.
struct InterfaceErrorReport
{
  MaterialId positive;
  MaterialId negative;
  HausdorffDistance distance;
  Index vertices = 0; ///< of the original interface
  /// Vertices in a cell that lacks one of the materials, or outside all cells. Each is an infinite error.
  Index missing = 0;
  /// Largest distance of an interface vertex to the plane of its cell: what point bounds claim. On a face between cells
  /// the closer of their planes counts.
  double largestVertexError = 0.0;
  Vector where = Vector::Zero(); ///< the vertex with the largest error
};

/// Distance between the original and the represented boundary of a material's region: all its interfaces in one. It is
/// finite where two materials touch on one side only, which makes the distance of their interface infinite.
struct RegionErrorReport
{
  MaterialId material;
  HausdorffDistance distance;
};

struct VolumeErrorReport
{
  MaterialId material;
  double represented = 0.0;
  double original = 0.0;
  double representedMass = 0.0; ///< NaN where there is no density
  double originalMass = 0.0;
};

/// What the original holds, from its volume fractions.
struct OriginalVolumes
{
  std::vector<double> volumes; ///< one per material
  std::vector<double> masses;  ///< one per material, NaN where it has no density; empty if there is none at all
};

struct RepresentationErrors
{
  std::vector<FieldErrorReport> fields;         ///< ordered by field, then material
  std::vector<InterfaceErrorReport> interfaces; ///< ordered by the lower, then the higher material
  std::vector<RegionErrorReport> regions;       ///< of the materials with interfaces, ascending
  std::vector<VolumeErrorReport> volumes;       ///< one per material
  /// Volume in which the represented material is not the one on this side of the original interfaces: an estimate from
  /// stratified samples, and its standard error.
  double misclassifiedVolume = 0.0;
  double misclassifiedVolumeError = 0.0;
  /// The part of it where the closest point of the original interfaces is on an edge at which they end within the box:
  /// they leave open there what is right.
  double misclassifiedNearGaps = 0.0;
};

/// Width to which Hausdorff intervals close, in units of the diagonal of the box.
inline constexpr double defaultHausdorffTolerance = 1e-4;

/// Measures a representation against the data it stands for, from the emitted values alone: errors of the fields over
/// all native samples, of the interfaces both ways, of the volumes and masses of the materials.
///
/// Fields are matched by name. Throws InvalidInput if the materials differ, if an array is missing or too short, or if
/// the tolerance is not positive. See Documentation/algorithm/Measure.md.
RepresentationErrors measureRepresentation(const Representation& representation, const NativeData& native,
  const Interfaces& original, const OriginalVolumes& volumes, Progress& progress,
  double hausdorffTolerance = defaultHausdorffTolerance);
}
