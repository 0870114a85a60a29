#include "Build/CertifiedFields.h"

#include "Build/BoxCut.h"
#include "Build/CellFunctions.h"
#include "Build/ParametricCut.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace strata
{
namespace
{
/// Rounding of a difference, relative to the largest number that takes part in it.
constexpr double rounding = 32.0 * std::numeric_limits<double>::epsilon();
/// Bisections of a hexahedron before it is known which ones matter, and then.
constexpr int firstBisections = 24;
constexpr int allBisections = 2000;

/// What a cell represents of one component of a material's field.
struct Represented
{
  LinearFunction function;
  double size = 0.0; ///< of the numbers that are added up in evaluating it
};

/// A field of a material over a native cell, with an upper bound of its error there.
struct Candidate
{
  double bound;
  NativeCellIndex cell;
  Box box;
  MaterialId material;
  std::size_t field;
  int first; ///< position of the field's first component among the represented functions
};

/// A cell's fields, compared with those of native cells.
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
    reached_.assign(hierarchy.fields.size(), 0.0);
    for (const MaterialId m : held_)
    {
      const MaterialCorners corners = materialCorners(hierarchy, hierarchy.cell(cell), m);
      for (int c = 0; c < components_; ++c)
      {
        represented_.push_back(represent(corners, 1 + c));
      }
    }
  }

  /// Takes note of a native cell's fields that may raise an error.
  void look(NativeCellIndex index, const Box& box)
  {
    if (holds(box))
    {
      // The difference is largest at the corners, which are samples in the cell.
      return;
    }
    const NativeCell cell = native_.nativeCell(index);
    const MaterialSet materials = cell.materials & held_;
    for (const MaterialId m : materials)
    {
      int first = held_.rank(m) * components_;
      for (std::size_t f = 0; f < hierarchy_.fields.size(); ++f)
      {
        Candidate candidate{ 0.0, index, box, m, f, first };
        first += hierarchy_.fields[f].components;
        if (findDifferences(cell, candidate))
        {
          candidate.bound = slack_ + firstBound(cell, candidate);
          if (candidate.bound > static_cast<double>(errors_.fieldErrors[f]))
          {
            candidates_.push_back(candidate);
          }
        }
      }
    }
  }

  /// Raises the errors. The largest quick bounds come first: most others turn out not to matter.
  void raise()
  {
    std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
      return a.bound != b.bound ? a.bound > b.bound
                                : std::make_pair(a.cell, a.material) < std::make_pair(b.cell, b.material);
    });
    for (const Candidate& candidate : candidates_)
    {
      float& error = errors_.fieldErrors[candidate.field];
      if (candidate.bound > static_cast<double>(error))
      {
        const NativeCell cell = native_.nativeCell(candidate.cell);
        findDifferences(cell, candidate);
        const double known = std::max({ static_cast<double>(error) - slack_, reached_[candidate.field], resolution() });
        const double largest = largestDifference(cell, candidate.box, known);
        error = std::max(error, roundedUp(std::min(candidate.bound, largest + slack_)));
      }
    }
  }

private:
  /// Whether a box lies in the cell as a whole.
  bool holds(const Box& box) const
  {
    const Vector center = box.center();
    const Vector half = 0.5 * box.size();
    return std::all_of(barycentric_.weights.begin(), barycentric_.weights.end(),
      [&](const LinearFunction& weight) { return weight(center) >= weight.gradient.cwiseAbs().dot(half); });
  }

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

  /// Finds native - represented at the corners of a native cell, and how much rounding may take from them; false where
  /// the material lacks the field or the field is known at the other kind of samples.
  bool findDifferences(const NativeCell& cell, const Candidate& candidate)
  {
    const auto components = static_cast<std::size_t>(hierarchy_.fields[candidate.field].components);
    const auto corners = static_cast<std::size_t>(cell.cornerCount());
    values_.resize(components * 8);
    native_.values(FieldId(static_cast<Index>(candidate.field)), candidate.material, cell.samples.data(),
      cell.cornerCount(), values_.data());
    if (std::isnan(values_[0]))
    {
      return false;
    }
    differences_.resize(components);
    slack_ = 0.0;
    for (std::size_t c = 0; c < components; ++c)
    {
      const Represented& represented = represented_[static_cast<std::size_t>(candidate.first) + c];
      double size = represented.size;
      for (std::size_t i = 0; i < corners; ++i)
      {
        const double value = values_[i * components + c];
        const double linear = represented.function(cell.corners[i]);
        differences_[c][i] = value - linear;
        size = std::max({ size, std::abs(value), std::abs(linear) });
      }
      slack_ += rounding * size;
    }
    return true;
  }

  /// A step of the floats that the values are stored in: smaller differences are not worth a search.
  double resolution() const
  {
    double largest = 0.0;
    for (const double value : values_)
    {
      largest = std::max(largest, std::abs(value));
    }
    return static_cast<double>(std::numeric_limits<float>::epsilon()) * largest;
  }

  /// A bound that is quickly found. For hexahedra, it also shows how large the field's error is at least.
  double firstBound(const NativeCell& cell, const Candidate& candidate)
  {
    switch (cell.kind)
    {
      case NativeCell::Kind::Box:
        return quickBound(BoxCut(positions_, barycentric_, candidate.box));
      case NativeCell::Kind::Tetrahedron:
        return largestAtCorners(cell);
      case NativeCell::Kind::Hexahedron: {
        double& reached = reached_[candidate.field];
        const HexahedronCut cut(barycentric_, cell.corners);
        const HexahedronCut::Bounds bounds =
          cut.largestLength(differences_, std::max(reached, resolution()), firstBisections);
        reached = std::max(reached, bounds.reached);
        return bounds.upper;
      }
    }
    return 0.0;
  }

  double largestAtCorners(const NativeCell& cell) const
  {
    double largest2 = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(cell.cornerCount()); ++i)
    {
      double squared = 0.0;
      for (const CornerNumbers& difference : differences_)
      {
        squared += difference[i] * difference[i];
      }
      largest2 = std::max(largest2, squared);
    }
    return std::sqrt(largest2);
  }

  /// The largest length at the corners of a box round the intersection: it is convex along each axis.
  double quickBound(const BoxCut& cut)
  {
    if (cut.empty())
    {
      return 0.0;
    }
    makeFunctions();
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
    return std::sqrt(bound2);
  }

  void makeFunctions()
  {
    functions_.clear();
    for (const CornerNumbers& difference : differences_)
    {
      functions_.emplace_back(difference);
    }
  }

  /// An upper bound of the length of the difference where the cells meet; `known` or less where that is no larger.
  double largestDifference(const NativeCell& cell, const Box& box, double known)
  {
    switch (cell.kind)
    {
      case NativeCell::Kind::Box:
        makeFunctions();
        return largestOnEdges(BoxCut(positions_, barycentric_, box));
      case NativeCell::Kind::Tetrahedron:
        return TetrahedronCut(positions_, barycentric_, cell.corners).largestLength(differences_);
      case NativeCell::Kind::Hexahedron:
        return HexahedronCut(barycentric_, cell.corners).largestLength(differences_, known, allBisections).upper;
    }
    return 0.0;
  }

  double largestOnEdges(BoxCut cut)
  {
    double largest2 = 0.0;
    for (const BoxCut::Edge& edge : cut)
    {
      double quick2 = 0.0;
      double squared = 0.0;
      cubics_.clear();
      for (const MultilinearFunction& function : functions_)
      {
        cubics_.push_back(function.along(edge.a, edge.b));
        quick2 += std::pow(cubics_.back().quickBound(), 2);
      }
      if (quick2 > largest2)
      {
        for (const Cubic& cubic : cubics_)
        {
          squared += std::pow(cubic.largestAbsoluteValue(), 2);
        }
        largest2 = std::max(largest2, squared);
      }
    }
    return std::sqrt(largest2);
  }

  const Hierarchy& hierarchy_;
  MaterialSet held_;
  const Barycentric& barycentric_;
  const NativeData& native_;
  std::array<Vector, 4> positions_;
  CellErrors& errors_;
  int components_ = 0;
  std::vector<Represented> represented_; ///< [material held][component of all fields]
  std::vector<Candidate> candidates_;
  std::vector<double> reached_; ///< per field, at some point of a hexahedron
  std::vector<double> values_;
  std::vector<CornerNumbers> differences_; ///< native - represented at a native cell's corners, per component
  double slack_ = 0.0;                     ///< rounding of the differences
  std::vector<MultilinearFunction> functions_;
  std::vector<Cubic> cubics_;
};
}

void addNativeCellErrors(const Hierarchy& hierarchy, CellId cell, const Barycentric& barycentric,
  const CellElements& elements, const NativeData& native, CellErrors& errors)
{
  if (elements.nativeCellCount() == 0)
  {
    return;
  }
  constexpr Index blockSize = 16;
  std::array<Box, blockSize> boxes;
  CellFields fields(hierarchy, cell, barycentric, native, errors);
  for (Index begin = 0; begin < elements.nativeCellCount(); begin += blockSize)
  {
    const Index count = std::min<Index>(blockSize, elements.nativeCellCount() - begin);
    native.nativeCellBoxes(elements.nativeCells() + begin, count, boxes.data());
    for (Index i = 0; i < count; ++i)
    {
      fields.look(elements.nativeCells()[begin + i], boxes[static_cast<std::size_t>(i)]);
    }
  }
  fields.raise();
}
}
