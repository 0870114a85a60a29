#pragma once

#include "Native/SampleBlocks.h"
#include "Native/SampledData.h"

namespace strata
{
/// Native data on a rectilinear grid: the samples form a lattice, the cell centres or the grid's points.
class RectilinearData final : public SampledData
{
public:
  RectilinearData(const Simulation& simulation, const NativeOptions& options, Progress& progress);

  void positions(const SampleIndex* samples, Index count, Vector* result) const override;
  NativeCellIndex nativeCellCount() const override;
  void nativeCellBoxes(const NativeCellIndex* cells, Index count, Box* result) const override;
  NativeCell nativeCell(NativeCellIndex cell) const override;
  void evaluate(MaterialId m, const Vector& point, bool inside, const Vector& closest, GhostMethod method,
    double* result) const override;

private:
  /// One group's lattice.
  struct Layout
  {
    SampleLattice lattice;
    SampleBlocks blocks;
    NativeCellIndex firstCell = 0; ///< index of the first cell between the group's samples
    NativeCellIndex cellCount = 0;
  };
  using Position = SampleLattice::Position;

  /// Where and how a linear function is fitted.
  struct FitPlace
  {
    Position center;                                    ///< of the block of samples
    Vector origin;                                      ///< the point from which distances count
    Vector target;                                      ///< the point at which the fit is evaluated
    double (*weight)(double squaredDistance) = nullptr; ///< of a sample, by its distance in native cells
  };

  /// The group of a native cell and the position of its lowest corner.
  std::pair<std::size_t, Position> placeOf(NativeCellIndex cell) const;
  bool sampleNear(std::size_t group, MaterialId m, const Vector& point) const;
  /// Multilinear interpolation. Corners that don't count for m take their values from a linear fit to samples near
  /// the point that do, so that the values continue those of complete cells.
  void interpolate(std::size_t group, MaterialId m, const Vector& point, double* result) const;
  /// The mean of m's samples round the point with the weights of multilinear interpolation, else the nearest
  /// sample of m.
  void average(std::size_t group, MaterialId m, const Vector& point, double* result) const;
  /// Linear extrapolation from m's samples near `closest`.
  void extrapolate(std::size_t group, MaterialId m, const Vector& point, const Vector& closest, double* result) const;
  /// Adds `factor` times the linear fit to m's samples in a block. False, without a change, where there are none or
  /// where they spread in fewer directions than asked for.
  bool addFitRound(
    std::size_t group, MaterialId m, const FitPlace& place, int smallestRank, double factor, double* result) const;
  void collect(std::size_t group, MaterialId m, const FitPlace& place, const Vector& spacing, Index radius,
    FitSamples& samples) const;

  std::vector<Layout> layouts_;
};
}
