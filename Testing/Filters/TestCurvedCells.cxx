#include "Conversion/CurvedDeviation.h"
#include "Conversion/DefaultField.h"
#include "Conversion/InputGrid.h"
#include "Conversion/ReadSimulation.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderTetra.h"
#include "vtkHigherOrderWedge.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <random>

namespace conversion = strata::conversion;
using strata::CellShape;
using strata::Index;
using strata::UnstructuredGrid;
using strata::Vector;

namespace
{
struct CurvedType
{
  const char* name;
  int type;
  int nodes;
  int pieces;
  int boundaryFaces; ///< of the pieces, on the cell's faces
};

// A triangle is cut into n^2 triangles, a quadrilateral into n^2 quadrilaterals (n m on a wedge of degrees n and m).
const CurvedType curvedTypes[] = { { "quadratic tetrahedron", VTK_QUADRATIC_TETRA, 10, 8, 16 },
  { "quadratic hexahedron", VTK_QUADRATIC_HEXAHEDRON, 20, 8, 24 },
  { "triquadratic hexahedron", VTK_TRIQUADRATIC_HEXAHEDRON, 27, 8, 24 },
  { "biquadratic hexahedron", VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 24, 8, 24 },
  { "quadratic wedge", VTK_QUADRATIC_WEDGE, 15, 8, 20 },
  { "quadratic linear wedge", VTK_QUADRATIC_LINEAR_WEDGE, 12, 4, 14 },
  { "biquadratic wedge", VTK_BIQUADRATIC_QUADRATIC_WEDGE, 18, 8, 20 },
  { "quadratic pyramid", VTK_QUADRATIC_PYRAMID, 13, 10, 20 },
  { "triquadratic pyramid", VTK_TRIQUADRATIC_PYRAMID, 19, 10, 20 },
  { "Lagrange tetrahedron", VTK_LAGRANGE_TETRAHEDRON, 20, 27, 36 },
  { "Lagrange hexahedron", VTK_LAGRANGE_HEXAHEDRON, 64, 27, 54 }, { "Lagrange wedge", VTK_LAGRANGE_WEDGE, 40, 27, 45 },
  { "Bezier tetrahedron", VTK_BEZIER_TETRAHEDRON, 20, 27, 36 },
  { "Bezier hexahedron", VTK_BEZIER_HEXAHEDRON, 27, 8, 24 }, { "Bezier wedge", VTK_BEZIER_WEDGE, 18, 8, 20 } };

using Map = std::function<Vector(const Vector&)>;

Vector bent(const Vector& p)
{
  return { p[0] + 0.1 * p[1] * p[1], p[1] + 0.1 * p[2] * p[0], p[2] + 0.1 * p[0] * p[1] };
}

/// One cell whose nodes lie where a map takes those of the unit cell.
vtkSmartPointer<vtkUnstructuredGrid> oneCell(const CurvedType& kind, const Map& map)
{
  vtkNew<vtkGenericCell> generic;
  generic->SetCellType(kind.type);
  vtkCell* cell = generic->GetRepresentativeCell();
  cell->GetPointIds()->SetNumberOfIds(kind.nodes);
  cell->GetPoints()->SetNumberOfPoints(kind.nodes);
  if (auto* hexahedron = vtkHigherOrderHexahedron::SafeDownCast(cell))
  {
    hexahedron->SetUniformOrderFromNumPoints(kind.nodes);
  }
  if (auto* wedge = vtkHigherOrderWedge::SafeDownCast(cell))
  {
    wedge->SetUniformOrderFromNumPoints(kind.nodes);
  }
  cell->Initialize();
  const double* parameters = cell->GetParametricCoords();
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<vtkIdType> ids;
  for (int node = 0; node < kind.nodes; ++node)
  {
    const double* p = parameters + 3 * node;
    // The sections of this pyramid all have parameters from 0 to 1.
    const double width = kind.type == VTK_QUADRATIC_PYRAMID ? 1.0 - p[2] : 1.0;
    const Vector place = map(Vector(width * p[0], width * p[1], p[2]));
    ids.push_back(points->InsertNextPoint(place.data()));
  }
  grid->SetPoints(points);
  grid->InsertNextCell(kind.type, kind.nodes, ids.data());
  return grid;
}

const UnstructuredGrid& gridOf(const conversion::InputGrid& input)
{
  return std::get<UnstructuredGrid>(input.grid);
}

/// How many faces of cells occur once, and the most often that one does.
std::pair<int, int> faceUses(const UnstructuredGrid& grid)
{
  static const std::map<CellShape, std::vector<std::vector<int>>> faces = {
    { CellShape::Tetrahedron, { { 0, 1, 2 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 2, 3 } } },
    { CellShape::Hexahedron,
      { { 0, 1, 2, 3 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 } } },
    { CellShape::Wedge, { { 0, 1, 2 }, { 3, 4, 5 }, { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 2, 0, 3, 5 } } },
    { CellShape::Pyramid, { { 0, 1, 2, 3 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } } }
  };
  std::map<std::vector<Index>, int> uses;
  for (std::size_t cell = 0; cell < grid.shapes.size(); ++cell)
  {
    for (const std::vector<int>& face : faces.at(grid.shapes[cell]))
    {
      std::vector<Index> points;
      for (const int corner : face)
      {
        points.push_back(grid.corners[static_cast<std::size_t>(grid.cornerOffsets[cell] + corner)]);
      }
      std::sort(points.begin(), points.end());
      ++uses[points];
    }
  }
  std::pair<int, int> result;
  for (const auto& [points, count] : uses)
  {
    result.first += count == 1;
    result.second = std::max(result.second, count);
  }
  return result;
}

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

void addPointField(vtkUnstructuredGrid* grid, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("density");
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  grid->GetPointData()->AddArray(array);
}
}

TEST(CurvedCells, EveryTypeBecomesPiecesThatMatch)
{
  for (const CurvedType& kind : curvedTypes)
  {
    const conversion::InputGrid input = conversion::readGrid(oneCell(kind, bent));
    const UnstructuredGrid& grid = gridOf(input);
    EXPECT_EQ(grid.cellCount(), kind.pieces) << kind.name;
    const auto [outer, most] = faceUses(grid);
    EXPECT_EQ(outer, kind.boundaryFaces) << kind.name;
    EXPECT_LE(most, 2) << kind.name;
    EXPECT_TRUE(std::all_of(input.cellSource.begin(), input.cellSource.end(), [](Index s) { return s == 0; }));
  }
}

TEST(CurvedCells, PointsOfThePiecesLieWhereTheMapOfTheCellTakesThem)
{
  for (const CurvedType& kind : curvedTypes)
  {
    const bool interpolates = kind.type < VTK_BEZIER_CURVE; // Bezier control points don't lie on the map
    const bool complete = kind.type != VTK_QUADRATIC_PYRAMID && kind.type != VTK_TRIQUADRATIC_PYRAMID &&
                          kind.type != VTK_QUADRATIC_LINEAR_WEDGE; // these lack some quadratic functions
    if (!interpolates || !complete)
    {
      continue;
    }
    const conversion::InputGrid input = conversion::readGrid(oneCell(kind, bent));
    const double steps = kind.nodes == 10 || kind.pieces == 8 ? 2.0 : 3.0;
    for (const Vector& place : gridOf(input).points)
    {
      double nearest = 1.0;
      for (double r = 0.0; r <= steps; ++r)
      {
        for (double s = 0.0; s <= steps; ++s)
        {
          for (double t = 0.0; t <= steps; ++t)
          {
            nearest = std::min(nearest, (bent(Vector(r, s, t) / steps) - place).norm());
          }
        }
      }
      EXPECT_LT(nearest, 1e-12) << kind.name;
    }
  }
}

TEST(CurvedCells, StraightCellsStayWholeWhereNoFieldBends)
{
  for (const CurvedType& kind : curvedTypes)
  {
    const auto sheared = [](const Vector& p) { return Vector(p[0] + 0.1 * p[2], p[1], p[2]); };
    EXPECT_EQ(gridOf(conversion::readGrid(oneCell(kind, sheared))).cellCount(), 1) << kind.name;
  }
}

TEST(CurvedCells, TheDeviationOfASquareIsFound)
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

TEST(CurvedCells, TheDeviationOfLinearFieldsIsNone)
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

TEST(CurvedCells, NoneOfTenThousandPointsDeviatesMoreThanTheBoundWhichIsTight)
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

TEST(CurvedCells, AWrongNumberOfNodesIsNoReasonToReadBeyondThem)
{
  const CurvedType broken{ "hexahedron of 26 nodes", VTK_LAGRANGE_HEXAHEDRON, 26, 0, 0 };
  vtkNew<vtkUnstructuredGrid> grid;
  const auto whole = oneCell(curvedTypes[2], [](const Vector& p) { return p; });
  grid->SetPoints(whole->GetPoints());
  std::vector<vtkIdType> ids(static_cast<std::size_t>(broken.nodes));
  std::iota(ids.begin(), ids.end(), 0);
  grid->InsertNextCell(broken.type, broken.nodes, ids.data());
  const conversion::InputGrid input = conversion::readGrid(grid);
  EXPECT_EQ(cellCount(input.grid), 1);
  ASSERT_EQ(input.warnings.size(), 1u);
  EXPECT_NE(input.warnings.front().find("straight"), std::string::npos);
}

TEST(CurvedCells, EachMaterialKeepsItsValueAtPointsThatAreNotShared)
{
  // Two cells side by side, each with nodes of its own: density 1 in the first, 5 in the second.
  const auto grid = oneCell(curvedTypes[2], [](const Vector& p) { return p; });
  const auto second = oneCell(curvedTypes[2], [](const Vector& p) { return Vector(p + Vector(1.0, 0.0, 0.0)); });
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < second->GetNumberOfPoints(); ++i)
  {
    ids.push_back(grid->GetPoints()->InsertNextPoint(second->GetPoint(i)));
  }
  grid->InsertNextCell(VTK_TRIQUADRATIC_HEXAHEDRON, 27, ids.data());
  std::vector<double> density(54, 1.0);
  std::fill(density.begin() + 27, density.end(), 5.0);
  addPointField(grid, density);
  vtkNew<vtkIntArray> material;
  material->SetName("material");
  material->InsertNextValue(1);
  material->InsertNextValue(2);
  grid->GetCellData()->AddArray(material);

  conversion::CaseData data;
  data.grid = grid;
  const conversion::ReadSimulationResult read = conversion::readSimulation(data, {});
  ASSERT_EQ(read.simulation.fields.size(), 1u);
  const auto& points = std::get<UnstructuredGrid>(read.simulation.grid).points;
  EXPECT_EQ(points.size(), 45u); // 9 are shared
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto at = static_cast<Index>(i);
    EXPECT_TRUE(points[i][0] > 1.0 + 1e-9 || read.simulation.fields[0].values[0](at) == 1.0);
    EXPECT_TRUE(points[i][0] < 1.0 - 1e-9 || read.simulation.fields[0].values[1](at) == 5.0);
  }
}

TEST(DefaultField, NamesOfThePhysicsComeBeforeMasses)
{
  const auto order = [](const char* name, bool ownArrays, bool mixed) {
    return conversion::defaultOrder({ name, ownArrays, mixed });
  };
  EXPECT_LT(order("density", true, true), order("pressure", false, true));
  EXPECT_LT(order("Pressure (dynes/cm^2^)", false, true), order("Temperature (eV)", false, true));
  EXPECT_LT(order("T", false, true), order("rho", false, true)) << "a mixture's density belongs to no material";
  EXPECT_LT(order("rho", false, false), order("p", false, false));
  EXPECT_LT(order("X Velocity", false, true), order("porosity", false, true));
  EXPECT_EQ(order("Mass for Armor Plate", true, true), conversion::lastDefaultOrder);
  EXPECT_EQ(order("mass_density", true, true), 0);
}
