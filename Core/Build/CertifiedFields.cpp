#include "Build/CertifiedFields.h"

#include "Build/BoxCut.h"
#include "Build/CellFunctions.h"
#include "Build/ParametricCut.h"

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
/// Rounding of a difference, relative to the largest number that takes part in it.
constexpr double rounding = 32.0 * std::numeric_limits<double>::epsilon();

/// The differences native - represented at the corners of a native cell, for one component.
using Differences = std::array<double, 8>;

/// What a cell represents of one component of a material's field.
struct Represented
{
  LinearFunction function;
  double size = 0.0; ///< of the numbers that are added up in evaluating it
};

/// One field of one material over native cells. `Cut` is what is known of where a native cell meets the cell.
class CellFields
{
public:
  CellFields(const Hierarchy& hierarchy, CellId cell, const Barycentric& barycentric, const NativeData& native,
    CellErrors& errors) :
    hierarchy_(hierarchy),
    held_(hierarchy.materialsOf(cell)), barycentric_(barycentric), native_(native),
    positions_(cornerPositions(hierarchy, cell)), errors_(errors)
  {
    components_ = hierarchy.valuesPerMaterial - 1;
    for (const MaterialId m : held_)
    {
      const MaterialCorners corners = materialCorners(hierarchy, hierarchy.cell(cell), m);
      for (int c = 0; c < components_; ++c)
      {
        represented_.push_back(represent(corners, 1 + c));
      }
    }
  }

  void add(NativeCellIndex index, const Box& box)
  {
    const NativeCell cell = native_.nativeCell(index);
    const MaterialSet materials = cell.materials & held_;
    if (materials.empty())
    {
      return;
    }
    switch (cell.kind)
    {
      case NativeCell::Kind::Box: {
        BoxCut cut(positions_, barycentric_, box);
        if (!cut.empty())
        {
          addMaterials(cell, materials, cut);
        }
        return;
      }
      case NativeCell::Kind::Tetrahedron: {
        TetrahedronCut cut(positions_, barycentric_, cell.corners);
        addMaterials(cell, materials, cut);
        return;
      }
      case NativeCell::Kind::Hexahedron: {
        HexahedronCut cut(barycentric_, cell.corners);
        addMaterials(cell, materials, cut);
        return;
      }
    }
  }

private:
  Represented represent(const MaterialCorners& corners, int position) const
  {
    Represented result{ representedFunction(barycentric_, corners, position), 0.0 };
    for (std::size_t k = 0; k < 4; ++k)
    {
      const LinearFunction& weight = barycentric_.weights[k];
      const double size = std::abs(weight.constant) + weight.gradient.cwiseAbs().dot(positions_[k].cwiseAbs());
      result.size += size * std::abs(static_cast<double>(corners[k][position]));
    }
    return result;
  }

  template<typename Cut>
  void addMaterials(const NativeCell& cell, MaterialSet materials, Cut& cut)
  {
    for (const MaterialId m : materials)
    {
      int first = held_.rank(m) * components_;
      for (std::size_t f = 0; f < hierarchy_.fields.size(); ++f)
      {
        addField(cell, m, f, represented_.data() + first, cut);
        first += hierarchy_.fields[f].components;
      }
    }
  }

  template<typename Cut>
  void addField(const NativeCell& cell, MaterialId m, std::size_t f, const Represented* represented, Cut& cut)
  {
    const auto components = static_cast<std::size_t>(hierarchy_.fields[f].components);
    const auto corners = static_cast<std::size_t>(cell.cornerCount());
    values_.resize(components * 8);
    native_.values(FieldId(static_cast<Index>(f)), m, cell.samples.data(), cell.cornerCount(), values_.data());
    if (std::isnan(values_[0]))
    {
      // A field that the material lacks, or that is known at the other kind of samples.
      return;
    }
    differences_.resize(components);
    double slack = 0.0;
    for (std::size_t c = 0; c < components; ++c)
    {
      double size = represented[c].size;
      for (std::size_t i = 0; i < corners; ++i)
      {
        const double value = values_[i * components + c];
        const double linear = represented[c].function(cell.corners[i]);
        differences_[c][i] = value - linear;
        size = std::max({ size, std::abs(value), std::abs(linear) });
      }
      slack += rounding * size;
    }
    const double known = static_cast<double>(errors_.fieldErrors[f]) - slack;
    const double largest = largestDifference(cut, known);
    if (largest > known)
    {
      errors_.fieldErrors[f] = roundedUp(largest + slack);
    }
  }

  /// An upper bound of the length of the difference where the cells meet; any number up to `known` where it is less.
  double largestDifference(BoxCut& cut, double known)
  {
    functions_.clear();
    for (const Differences& difference : differences_)
    {
      functions_.emplace_back(difference);
    }
    // The length is convex along each axis, so on a box its maximum is at a corner.
    double bound2 = 0.0;
    for (std::size_t i = 0; i < 8; ++i)
    {
      const Vector corner = cut.innerCorner(i);
      double squared = 0.0;
      for (const MultilinearFunction& function : functions_)
      {
        squared += std::pow(function(corner), 2);
      }
      bound2 = std::max(bound2, squared);
    }
    if (std::sqrt(bound2) <= known)
    {
      return known;
    }
    double largest2 = 0.0;
    for (const BoxCut::Edge& edge : cut.edges())
    {
      double squared = 0.0;
      for (const MultilinearFunction& function : functions_)
      {
        squared += std::pow(function.largestAbsoluteValue(edge.a, edge.b), 2);
      }
      largest2 = std::max(largest2, squared);
    }
    return std::sqrt(std::min(largest2, bound2));
  }

  template<typename Cut>
  double largestDifference(Cut& cut, double known)
  {
    return cut.largestLength(differences_, known);
  }

  const Hierarchy& hierarchy_;
  MaterialSet held_;
  const Barycentric& barycentric_;
  const NativeData& native_;
  std::array<Vector, 4> positions_;
  CellErrors& errors_;
  int components_ = 0;
  std::vector<Represented> represented_; ///< [material held][component of all fields]
  std::vector<double> values_;
  std::vector<Differences> differences_; ///< one per component
  std::vector<MultilinearFunction> functions_;
};
}

void addNativeCellErrors(const Hierarchy& hierarchy, CellId cell, const Barycentric& barycentric,
  const CellElements& elements, const NativeData& native, CellErrors& errors)
{
  if (elements.nativeCellCount() == 0)
  {
    return;
  }
  constexpr Index blockSize = 256;
  std::array<Box, blockSize> boxes;
  CellFields fields(hierarchy, cell, barycentric, native, errors);
  for (Index begin = 0; begin < elements.nativeCellCount(); begin += blockSize)
  {
    const Index count = std::min<Index>(blockSize, elements.nativeCellCount() - begin);
    native.nativeCellBoxes(elements.nativeCells() + begin, count, boxes.data());
    for (Index i = 0; i < count; ++i)
    {
      fields.add(elements.nativeCells()[begin + i], boxes[static_cast<std::size_t>(i)]);
    }
  }
}
}
