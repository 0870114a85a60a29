#pragma once

#include "Geometry/Box.h"
#include "Model/Materials.h"
#include "Model/NativeCell.h"

#include <string>
#include <vector>

namespace strata
{
/// A field by name, with its number of components.
struct Field
{
  std::string name;
  int components = 1;
};

/// How a material's field continues past its interface (design 3.4).
enum class GhostMethod : std::uint8_t
{
  DataThenLinear, ///< interpolate the material's own data where there are any, else extrapolate linearly
  Linear,         ///< extrapolate linearly from the closest point of the material's region
  Constant        ///< the value at the closest point of the material's region: the paper's rule
};

/// The simulation's fields as the refinement sees them: what the paper asks of a data set (its section 4).
///
/// Native samples are the points at which the simulation knows its fields: grid points, or cell centres for
/// cell data. A sample counts for each material with fields whose volume fraction there is at least
/// `minimumVolumeFraction`, and for the one with the largest fraction (design 2).
/// All functions are const and may be called from several threads.
class NativeData
{
public:
  virtual ~NativeData() = default;

  const Box& box() const { return box_; }
  const Materials& materials() const { return materials_; }
  const std::vector<Field>& fields() const { return fields_; }
  /// Components of all fields together: the length of what `evaluate` writes.
  int componentCount() const;

  virtual SampleIndex sampleCount() const = 0;
  /// Positions of `count` samples.
  virtual void positions(const SampleIndex* samples, Index count, Vector* result) const = 0;
  /// The materials that each of `count` samples counts for; only materials with fields.
  virtual void materialsAt(const SampleIndex* samples, Index count, MaterialSet* result) const = 0;
  /// The components of a field of m at `count` samples that count for m: result[i * components + c].
  /// NaN where the field is not known at that sample (cell samples of a point field and vice versa).
  virtual void values(FieldId field, MaterialId m, const SampleIndex* samples, Index count, double* result) const = 0;

  /// Number of native cells; 0 where fields are known at samples only.
  virtual NativeCellIndex nativeCellCount() const { return 0; }
  /// Boxes round `count` native cells.
  virtual void nativeCellBoxes(const NativeCellIndex* /*cells*/, Index /*count*/, Box* /*result*/) const {}
  virtual NativeCell nativeCell(NativeCellIndex /*cell*/) const { return {}; }

  /// All fields of m at a point, a function of the arguments alone: `componentCount()` numbers, the fields in
  /// order. `inside` tells whether the point lies in m's region; otherwise `closest` is the region's closest
  /// point to it. NaN for a field that m lacks everywhere. A material's linear fields are reproduced exactly,
  /// and so is the field of a native cell that holds the point and whose corners all count for m.
  virtual void evaluate(MaterialId m, const Vector& point, bool inside, const Vector& closest, GhostMethod method,
    double* result) const = 0;

  /// Largest minus smallest value of a field over all samples and materials (of its length for vectors).
  double range(FieldId field) const { return ranges_[static_cast<std::size_t>(field.value)]; }
  /// Largest absolute value of a field over all samples and materials (length of vectors).
  double magnitude(FieldId field) const { return magnitudes_[static_cast<std::size_t>(field.value)]; }

protected:
  Box box_;
  Materials materials_;
  std::vector<Field> fields_;
  std::vector<double> ranges_;
  std::vector<double> magnitudes_;
};

inline int NativeData::componentCount() const
{
  int count = 0;
  for (const Field& field : fields_)
  {
    count += field.components;
  }
  return count;
}
}
