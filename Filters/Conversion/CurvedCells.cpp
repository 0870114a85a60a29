#include "Conversion/CurvedCells.h"

#include "Conversion/CellTable.h"
#include "Conversion/CurvedPieces.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkGenericCell.h>
#include <vtkHigherOrderHexahedron.h>
#include <vtkHigherOrderTetra.h>
#include <vtkHigherOrderWedge.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace strata::conversion
{
namespace
{
/// Weights below this are rounding errors of VTK's functions.
constexpr double negligibleWeight = 1e-12;
/// Deviations of cells of higher degrees are not bounded: the coefficients grow with the sixth power of the degree.
constexpr int highestBoundedDegree = 5;

using Parameters = std::array<double, 3>;

/// Parameters in a cube of parameters.
Parameters parametersAt(const std::vector<Parameters>& corners, const std::array<double, 8>& weights)
{
  Parameters result{};
  for (std::size_t i = 0; i < 8; ++i)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      result[axis] += weights[i] * corners[i][axis];
    }
  }
  return result;
}

/// Degrees along the parameters.
std::array<int, 3> degreesOf(int type, vtkCell* cell)
{
  if (auto* hexahedron = vtkHigherOrderHexahedron::SafeDownCast(cell))
  {
    return { hexahedron->GetOrder(0), hexahedron->GetOrder(1), hexahedron->GetOrder(2) };
  }
  if (auto* wedge = vtkHigherOrderWedge::SafeDownCast(cell))
  {
    return { wedge->GetOrder(0), wedge->GetOrder(1), wedge->GetOrder(2) };
  }
  if (auto* tetrahedron = vtkHigherOrderTetra::SafeDownCast(cell))
  {
    const int order = static_cast<int>(tetrahedron->GetOrder());
    return { order, order, order };
  }
  return { 2, 2, type == VTK_QUADRATIC_LINEAR_WEDGE ? 1 : 2 };
}

/// VTK's parameters of the pyramid of 19 nodes are coordinates in a straight one with its base at 1/2.
Parameters inStraightPyramid(const Parameters& p)
{
  return { p[0] + p[2] * (0.5 - p[0]), p[1] + p[2] * (0.5 - p[1]), 0.5 + 0.5 * p[2] };
}

NodeWeights weightsAt(vtkCell* cell, Parameters parameters)
{
  if (cell->GetCellType() == VTK_TRIQUADRATIC_PYRAMID)
  {
    parameters = inStraightPyramid(parameters);
  }
  std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()), 0.0);
  cell->InterpolateFunctions(parameters.data(), weights.data());
  NodeWeights result;
  for (std::size_t node = 0; node < weights.size(); ++node)
  {
    if (std::abs(weights[node]) > negligibleWeight)
    {
      result.emplace_back(static_cast<int>(node), weights[node]);
    }
  }
  if (result.size() == 1)
  {
    result.front().second = 1.0;
  }
  return result;
}

/// Weights of the corners at parameters in the straight cell of a shape.
NodeWeights straightWeights(CellShape shape, const Parameters& p)
{
  const double r = p[0];
  const double s = p[1];
  const double t = p[2];
  const std::array<double, 4> square = { (1.0 - r) * (1.0 - s), r * (1.0 - s), r * s, (1.0 - r) * s };
  const std::array<double, 3> triangle = { 1.0 - r - s, r, s };
  NodeWeights result;
  const auto add = [&](double weight) { result.emplace_back(static_cast<int>(result.size()), weight); };
  if (shape == CellShape::Tetrahedron)
  {
    std::for_each(triangle.begin(), triangle.end(), [&](double w) { add(w - (result.empty() ? t : 0.0)); });
    add(t);
    return result;
  }
  const double* base = shape == CellShape::Wedge ? triangle.data() : square.data();
  const int sides = shape == CellShape::Wedge ? 3 : 4;
  std::for_each(base, base + sides, [&](double w) { add(w * (1.0 - t)); });
  if (shape == CellShape::Pyramid)
  {
    add(t);
    return result;
  }
  std::for_each(base, base + sides, [&](double w) { add(w * t); });
  return result;
}

/// Positions among a piece's corners of those of a cube, the first axis fastest: where they coincide, a multilinear
/// map of the cube is linear on tetrahedra and VTK's function on wedges.
std::array<std::size_t, 8> cubeCorners(CellShape shape)
{
  switch (shape)
  {
    case CellShape::Tetrahedron:
      return { 0, 1, 2, 2, 3, 3, 3, 3 };
    case CellShape::Wedge:
      return { 0, 1, 2, 2, 3, 4, 5, 5 };
    default:
      return { 0, 1, 3, 2, 4, 5, 7, 6 };
  }
}

/// Coefficients of Bernstein polynomials from values at equal steps, along one axis.
Eigen::MatrixXd bernsteinFromValues(int degree)
{
  Eigen::MatrixXd values(degree + 1, degree + 1);
  for (int i = 0; i <= degree; ++i)
  {
    const double u = static_cast<double>(i) / degree;
    double binomial = 1.0;
    for (int k = 0; k <= degree; ++k)
    {
      values(i, k) = binomial * std::pow(u, k) * std::pow(1.0 - u, degree - k);
      binomial *= static_cast<double>(degree - k) / (k + 1);
    }
  }
  return values.inverse();
}

/// A row per point of a cube of (degree + 1)^3 values becomes one per coefficient.
void toBernstein(int degree, Eigen::MatrixXd& rows)
{
  const Eigen::MatrixXd convert = bernsteinFromValues(degree);
  const Eigen::Index n = degree + 1;
  for (const Eigen::Index stride : { Eigen::Index{ 1 }, n, n * n })
  {
    for (Eigen::Index first = 0; first < rows.rows(); ++first)
    {
      if (first / stride % n == 0)
      {
        Eigen::MatrixXd line(n, rows.cols());
        for (Eigen::Index i = 0; i < n; ++i)
        {
          line.row(i) = rows.row(first + i * stride);
        }
        line = (convert * line).eval();
        for (Eigen::Index i = 0; i < n; ++i)
        {
          rows.row(first + i * stride) = line.row(i);
        }
      }
    }
  }
}

/// The difference between the cell's function and a piece's at (degree + 1)^3 points of the piece: a row of node
/// weights for each.
Eigen::MatrixXd differences(vtkCell* cell, const CurvedPattern& pattern, const CurvedPattern::Piece& piece,
  const ShapeLattice& lattice, int degree)
{
  const std::array<std::size_t, 8> order = cubeCorners(piece.shape);
  std::vector<Parameters> corners;
  std::transform(order.begin(), order.end(), std::back_inserter(corners),
    [&](std::size_t c) { return lattice.points[static_cast<std::size_t>(piece.corners[c])]; });
  const int n = degree + 1;
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(n * n * n, cell->GetNumberOfPoints());
  for (int row = 0; row < n * n * n; ++row)
  {
    const Parameters u = { static_cast<double>(row % n) / degree, static_cast<double>(row / n % n) / degree,
      static_cast<double>(row / (n * n)) / degree };
    std::array<double, 8> weights{};
    for (std::size_t i = 0; i < 8; ++i)
    {
      weights[i] = ((i & 1) ? u[0] : 1.0 - u[0]) * ((i & 2) ? u[1] : 1.0 - u[1]) * ((i & 4) ? u[2] : 1.0 - u[2]);
    }
    for (const auto& [node, weight] : weightsAt(cell, parametersAt(corners, weights)))
    {
      rows(row, node) += weight;
    }
    for (std::size_t i = 0; i < 8; ++i)
    {
      for (const auto& [node, weight] : pattern.points[static_cast<std::size_t>(piece.corners[order[i]])])
      {
        rows(row, node) -= weights[i] * weight;
      }
    }
  }
  return rows;
}

void addDeviation(vtkCell* cell, const ShapeLattice& lattice, int degree, CurvedPattern& pattern)
{
  pattern.deviationDegree = degree;
  for (const CurvedPattern::Piece& piece : pattern.pieces)
  {
    Eigen::MatrixXd rows = differences(cell, pattern, piece, lattice, degree);
    toBernstein(degree, rows);
    for (Eigen::Index row = 0; row < rows.rows(); ++row)
    {
      NodeWeights coefficient;
      for (Eigen::Index node = 0; node < rows.cols(); ++node)
      {
        if (std::abs(rows(row, node)) > negligibleWeight)
        {
          coefficient.emplace_back(static_cast<int>(node), rows(row, node));
        }
      }
      pattern.deviation.push_back(std::move(coefficient));
    }
  }
}

std::shared_ptr<const CurvedPattern> makePattern(
  vtkCell* cell, CellShape shape, const std::array<int, 3>& degrees, bool bounded)
{
  auto pattern = std::make_shared<CurvedPattern>();
  const ShapeLattice lattice = latticeOf(shape, degrees);
  pattern->nodeCount = static_cast<int>(cell->GetNumberOfPoints());
  pattern->pieces = lattice.pieces;
  for (const Parameters& parameters : lattice.points)
  {
    pattern->points.push_back(weightsAt(cell, parameters));
    pattern->straight.push_back(straightWeights(shape, parameters));
  }
  const int degree = *std::max_element(degrees.begin(), degrees.end());
  if (bounded && shape != CellShape::Pyramid && degree <= highestBoundedDegree)
  {
    addDeviation(cell, lattice, degree, *pattern);
  }
  return pattern;
}
}

namespace
{
/// Highest degree that is looked for.
constexpr Index highestDegree = 20;

Index nodeCount(CellShape shape, const std::array<Index, 3>& n)
{
  switch (shape)
  {
    case CellShape::Tetrahedron:
      return (n[0] + 1) * (n[0] + 2) * (n[0] + 3) / 6;
    case CellShape::Wedge:
      return (n[0] + 1) * (n[0] + 2) / 2 * (n[2] + 1);
    default:
      return (n[0] + 1) * (n[1] + 1) * (n[2] + 1);
  }
}

/// Nodes of the cells of a single degree; 0 for others.
Index fixedNodeCount(int type)
{
  switch (type)
  {
    case VTK_QUADRATIC_TETRA:
      return 10;
    case VTK_QUADRATIC_HEXAHEDRON:
      return 20;
    case VTK_TRIQUADRATIC_HEXAHEDRON:
      return 27;
    case VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON:
      return 24;
    case VTK_QUADRATIC_WEDGE:
      return 15;
    case VTK_QUADRATIC_LINEAR_WEDGE:
      return 12;
    case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
      return 18;
    case VTK_QUADRATIC_PYRAMID:
      return 13;
    case VTK_TRIQUADRATIC_PYRAMID:
      return 19;
    default:
      return 0;
  }
}

/// True if a cell of the type can have that many nodes; VTK takes it for granted. `degrees`: the cells' own, or null.
bool canHave(int type, Index pointCount, vtkDataArray* degrees, Index cell)
{
  if (fixedNodeCount(type) > 0)
  {
    return pointCount == fixedNodeCount(type);
  }
  const CellShape shape = cellKind(type).shape;
  if (degrees)
  {
    const auto degree = [&](int axis) { return static_cast<Index>(degrees->GetComponent(cell, axis)); };
    return degrees->GetNumberOfComponents() == 3 && cell < degrees->GetNumberOfTuples() && degree(0) > 0 &&
           degree(2) > 0 && nodeCount(shape, { degree(0), degree(1), degree(2) }) == pointCount;
  }
  for (Index n = 1; n <= highestDegree; ++n)
  {
    if (nodeCount(shape, { n, n, n }) == pointCount)
    {
      return true;
    }
  }
  return false;
}
}

CurvedPatterns::CurvedPatterns(vtkUnstructuredGrid* data) :
  data_(data), rational_(data->GetPointData()->GetRationalWeights() != nullptr),
  degrees_(data->GetCellData()->GetHigherOrderDegrees() != nullptr)
{}

std::shared_ptr<const CurvedPattern> CurvedPatterns::of(Index cell, int type, Index pointCount)
{
  const auto [at, isNew] = patterns_.try_emplace({ type, pointCount, rational_ || degrees_ ? cell : 0 });
  if (isNew)
  {
    at->second = make(cell, type, pointCount);
  }
  return at->second;
}

std::shared_ptr<const CurvedPattern> CurvedPatterns::make(Index cell, int type, Index pointCount) const
{
  if (type == VTK_LAGRANGE_PYRAMID || type == VTK_BEZIER_PYRAMID ||
      !canHave(type, pointCount, data_->GetCellData()->GetHigherOrderDegrees(), cell))
  {
    return nullptr;
  }
  vtkNew<vtkGenericCell> generic;
  data_->GetCell(cell, generic);
  vtkCell* own = generic->GetRepresentativeCell();
  const std::array<int, 3> degrees = degreesOf(type, own);
  if (*std::min_element(degrees.begin(), degrees.end()) < 1)
  {
    return nullptr;
  }
  return makePattern(own, cellKind(type).shape, degrees, !rational_);
}
}
