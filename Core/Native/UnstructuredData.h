#pragma once

#include "Native/PointCells.h"
#include "Native/SampleTree.h"
#include "Native/SampledData.h"

namespace strata
{
/// How a linear function is fitted: to how many of the nearest samples (twice as many, up to what Neighbors
/// can hold, where they don't spread in all directions), and how a sample weighs by its squared distance
/// relative to that of the farthest.
struct FitRule
{
  int size;
  double (*weight)(double relativeSquaredDistance);
};

/// Native data on an unstructured grid. Cell samples lie at the cells' centres of volume; between them fields are
/// linear fits to a material's samples near a point. Point data are the cells' own functions within them.
class UnstructuredData final : public SampledData
{
public:
  UnstructuredData(const Simulation& simulation, const NativeOptions& options, Progress& progress);

  void positions(const SampleIndex* samples, Index count, Vector* result) const override;
  NativeCellIndex nativeCellCount() const override;
  void nativeCellBoxes(const NativeCellIndex* cells, Index count, Box* result) const override;
  NativeCell nativeCell(NativeCellIndex cell) const override;
  void evaluate(MaterialId m, const Vector& point, bool inside, const Vector& closest, GhostMethod method,
    double* result) const override;

private:
  /// One group's sample positions, a tree over the samples of each material and, for point data, the cells.
  struct Cloud
  {
    std::vector<Vector> points;
    std::vector<SampleTree> trees;
    PointCells cells;
  };

  bool sampleNear(std::size_t group, MaterialId m, const Vector& point) const;
  /// The linear fit to m's samples nearest to a point, at the point. It takes each sample's own value at the
  /// sample's position.
  void interpolate(std::size_t group, MaterialId m, const Vector& point, double* result) const;
  /// The function of the cell of point data that holds a point; corners that don't count for m take their values from
  /// the fit at the point. False where no cell does, or none of its corners counts for m.
  bool interpolateInCell(std::size_t group, MaterialId m, const Vector& point, double* result) const;
  /// The function of the cell that holds `closest`, continued linearly to a point in no cell; false as above.
  bool continueFromCell(
    std::size_t group, MaterialId m, const Vector& point, const Vector& closest, double* result) const;
  /// The mean of m's samples nearest to a point, weighted by the inverse squared distance.
  void average(std::size_t group, MaterialId m, const Vector& point, double* result) const;
  /// Linear extrapolation from m's samples near `closest`.
  void extrapolate(std::size_t group, MaterialId m, const Vector& point, const Vector& closest, double* result) const;
  /// Where a fit's samples lie, where it is evaluated, and what its value is multiplied by.
  struct FitPlace
  {
    Vector origin;
    Vector target;
    double factor = 1.0;
  };
  /// Adds the linear fit to m's samples nearest to the place's origin.
  void addFitRound(std::size_t group, MaterialId m, const FitPlace& place, const FitRule& rule, double* result) const;
  const PointCells* pointCells() const;

  std::vector<Cloud> clouds_;
};
}
