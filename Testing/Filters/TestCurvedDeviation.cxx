#include "Conversion/CurvedDeviation.h"
#include "CurvedTypes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <string>

namespace conversion = strata::conversion;
using strata::CellShape;
using strata::Vector;

namespace
{
/// How far a random field with two components on one curved cell is from that on its linear pieces.
class DeviationAt
{
public:
  DeviationAt(const CurvedType& kind, std::mt19937& random) : grid_(oneCell(kind, bent))
  {
    grid_->GetCell(0, cell_);
    conversion::CurvedPatterns patterns(grid_);
    pattern_ = patterns.of(0, kind.type, kind.nodes);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < components * kind.nodes; ++i)
    {
      values_.push_back(unit(random));
    }
    deviation_.add(*pattern_, values_);
  }

  bool isBounded() const { return !pattern_->deviation.empty(); }
  double bound() const { return deviation_.bound(); }
  std::size_t pieceCount() const { return pattern_->pieces.size(); }

  /// At a point of a piece, whose corners are those of a cube, some of them together.
  double operator()(std::size_t number, const Vector& u) const
  {
    static const std::map<CellShape, std::array<std::size_t, 8>> corners = { { CellShape::Tetrahedron,
                                                                               { 0, 1, 2, 2, 3, 3, 3, 3 } },
      { CellShape::Wedge, { 0, 1, 2, 2, 3, 4, 5, 5 } }, { CellShape::Hexahedron, { 0, 1, 3, 2, 4, 5, 7, 6 } } };
    const conversion::CurvedPattern::Piece& piece = pattern_->pieces[number];
    Vector parameters = Vector::Zero();
    std::array<double, components> difference{};
    for (std::size_t i = 0; i < 8; ++i)
    {
      const double weight =
        ((i & 1) != 0 ? u[0] : 1.0 - u[0]) * ((i & 2) != 0 ? u[1] : 1.0 - u[1]) * ((i & 4) != 0 ? u[2] : 1.0 - u[2]);
      const auto point = static_cast<std::size_t>(piece.corners[corners.at(piece.shape)[i]]);
      for (const auto& [corner, part] : pattern_->straight[point])
      {
        parameters += weight * part * Vector(cell_->GetParametricCoords() + 3 * corner);
      }
      add(pattern_->points[point], -weight, difference);
    }
    std::vector<double> weights(static_cast<std::size_t>(cell_->GetNumberOfPoints()));
    cell_->InterpolateFunctions(parameters.data(), weights.data());
    conversion::NodeWeights own;
    for (std::size_t node = 0; node < weights.size(); ++node)
    {
      own.emplace_back(static_cast<int>(node), weights[node]);
    }
    add(own, 1.0, difference);
    return std::hypot(difference[0], difference[1]);
  }

private:
  static constexpr int components = 2;

  void add(const conversion::NodeWeights& weights, double factor, std::array<double, components>& difference) const
  {
    for (const auto& [node, weight] : weights)
    {
      for (std::size_t c = 0; c < components; ++c)
      {
        difference[c] += factor * weight * values_[static_cast<std::size_t>(node) * components + c];
      }
    }
  }

  vtkSmartPointer<vtkUnstructuredGrid> grid_;
  vtkNew<vtkGenericCell> cell_;
  std::shared_ptr<const conversion::CurvedPattern> pattern_;
  std::vector<double> values_;
  conversion::CurvedDeviation deviation_{ components };
};
}

TEST(CurvedDeviation, TheDeviationOfASquareIsFound)
{
  // Between 0 and 1/2, and 1/2 and 1, r^2 differs from its chords by 1/16 at most.
  const auto grid = oneCell(curvedTypes[2], [](const Vector& p) { return p; });
  std::vector<double> squares;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    squares.push_back(grid->GetPoint(i)[0] * grid->GetPoint(i)[0]);
  }
  conversion::CurvedPatterns patterns(grid);
  const auto pattern = patterns.of(0, VTK_TRIQUADRATIC_HEXAHEDRON, 27);
  conversion::CurvedDeviation deviation(1);
  deviation.add(*pattern, squares);
  EXPECT_NEAR(deviation.bound(), 1.0 / 16.0, 1e-12);
}

TEST(CurvedDeviation, TheDeviationOfLinearFieldsIsNone)
{
  for (const CurvedType& kind : curvedTypes)
  {
    const auto grid = oneCell(kind, [](const Vector& p) { return p; });
    conversion::CurvedPatterns patterns(grid);
    const auto pattern = patterns.of(0, kind.type, kind.nodes);
    ASSERT_TRUE(pattern) << kind.name;
    std::vector<double> places;
    for (int node = 0; node < kind.nodes; ++node)
    {
      places.insert(places.end(), grid->GetPoint(node), grid->GetPoint(node) + 3);
    }
    conversion::CurvedDeviation deviation(3);
    deviation.add(*pattern, places);
    EXPECT_LT(deviation.bound(), 1e-12) << kind.name;
  }
}

TEST(CurvedDeviation, NoneOfTenThousandPointsDeviatesMoreThanTheBoundWhichIsTight)
{
  std::mt19937 random(1);
  const auto randomVector = [&](double lower, double upper) {
    std::uniform_real_distribution<double> number(lower, upper);
    const double x = number(random);
    const double y = number(random);
    return Vector(x, y, number(random));
  };
  double smallestRatio = 2.0;
  for (const CurvedType& kind : curvedTypes)
  {
    const DeviationAt deviationAt(kind, random);
    if (!deviationAt.isBounded())
    {
      EXPECT_NE(std::string(kind.name).find("pyramid"), std::string::npos);
      continue;
    }
    double largest = 0.0;
    for (std::size_t piece = 0; piece < deviationAt.pieceCount(); ++piece)
    {
      double reached = 0.0;
      Vector best = Vector::Zero();
      const auto look = [&](const Vector& u) {
        const double length = deviationAt(piece, u);
        best = length > reached ? u : best;
        reached = std::max(reached, length);
      };
      for (std::size_t i = 0; i <= 10000 / deviationAt.pieceCount(); ++i)
      {
        look(randomVector(0.0, 1.0));
      }
      // On from the best one, in ever smaller steps.
      for (double step = 0.1; step > 1e-3; step *= 0.98)
      {
        look((best + step * randomVector(-1.0, 1.0)).cwiseMax(0.0).cwiseMin(1.0));
      }
      largest = std::max(largest, reached);
    }
    EXPECT_GE(deviationAt.bound(), largest) << kind.name;
    EXPECT_LE(deviationAt.bound(), 1.12 * largest) << kind.name;
    RecordProperty(
      std::string("BoundOverSeen.") + std::to_string(kind.type), std::to_string(deviationAt.bound() / largest));
    smallestRatio = std::min(smallestRatio, deviationAt.bound() / largest);
  }
  // One bound one per cent lower would be exceeded.
  EXPECT_LT(0.99 * smallestRatio, 1.0);
}
