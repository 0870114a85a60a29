#include "Native/PointCells.h"

#include "Model/Errors.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace strata
{
namespace
{
constexpr std::uint32_t cellsPerLeaf = 4;
/// How far outside of a cell a point may lie to be counted in, relative to the cell.
constexpr double relativeTolerance = 1e-9;
constexpr int maximumIterations = 30;

/// Positions among a shape's corners of the corners of a box, the first axis fastest.
const std::array<int, 8>& boxCorners(CellShape shape)
{
  static constexpr std::array<int, 8> tetrahedron = { 0, 1, 2, 3, 3, 3, 3, 3 };
  static constexpr std::array<int, 8> hexahedron = { 0, 1, 3, 2, 4, 5, 7, 6 };
  static constexpr std::array<int, 8> wedge = { 0, 1, 2, 2, 3, 4, 5, 5 };
  static constexpr std::array<int, 8> pyramid = { 0, 1, 3, 2, 4, 4, 4, 4 };
  static constexpr std::array<int, 8> none = { 0, 0, 0, 0, 0, 0, 0, 0 };
  switch (shape)
  {
    case CellShape::Tetrahedron:
      return tetrahedron;
    case CellShape::Hexahedron:
      return hexahedron;
    case CellShape::Wedge:
      return wedge;
    case CellShape::Pyramid:
      return pyramid;
    case CellShape::Polyhedron:
      break;
  }
  return none;
}

PointCells::Weights multilinearWeights(const Vector& u)
{
  PointCells::Weights weights;
  for (std::size_t i = 0; i < 8; ++i)
  {
    weights[i] =
      ((i & 1) != 0 ? u[0] : 1.0 - u[0]) * ((i & 2) != 0 ? u[1] : 1.0 - u[1]) * ((i & 4) != 0 ? u[2] : 1.0 - u[2]);
  }
  return weights;
}

Vector combined(const std::array<Vector, 8>& corners, const PointCells::Weights& weights)
{
  Vector result = Vector::Zero();
  for (std::size_t i = 0; i < 8; ++i)
  {
    result += weights[i] * corners[i];
  }
  return result;
}

/// Derivatives of the place by the three parameters.
Eigen::Matrix3d jacobian(const std::array<Vector, 8>& corners, const Vector& u)
{
  Eigen::Matrix3d result;
  for (int axis = 0; axis < 3; ++axis)
  {
    Vector lower = u;
    Vector upper = u;
    lower[axis] = 0.0;
    upper[axis] = 1.0;
    result.col(axis) = combined(corners, multilinearWeights(upper)) - combined(corners, multilinearWeights(lower));
  }
  return result;
}

/// Newton's method for the parameters of a point, which stay near the unit cube on the way.
bool invert(const std::array<Vector, 8>& corners, const Vector& p, double tolerance, PointCells::Weights& weights)
{
  Vector u = Vector::Constant(0.5);
  for (int i = 0; i < maximumIterations; ++i)
  {
    const Vector within = u.cwiseMax(0.0).cwiseMin(1.0);
    weights = multilinearWeights(within);
    if ((combined(corners, weights) - p).norm() <= tolerance)
    {
      return true;
    }
    const Vector rest = p - combined(corners, multilinearWeights(u));
    // Where corners coincide the matrix is singular; any solution will do.
    const Vector step = jacobian(corners, u).colPivHouseholderQr().solve(rest);
    u = (u + step).cwiseMax(-0.5).cwiseMin(1.5);
    if (!u.allFinite() || step.norm() < 1e-15)
    {
      return false;
    }
  }
  return false;
}

bool weightsInTetrahedron(const std::array<Vector, 8>& corners, const Vector& p, PointCells::Weights& weights)
{
  Eigen::Matrix3d edges;
  edges << corners[1] - corners[0], corners[2] - corners[0], corners[3] - corners[0];
  const Vector inside = edges.inverse() * (p - corners[0]);
  weights = { 1.0 - inside.sum(), inside[0], inside[1], inside[2], 0.0, 0.0, 0.0, 0.0 };
  // False for the NaN of a flat cell.
  return std::all_of(weights.begin(), weights.end(), [](double w) { return w >= -relativeTolerance; });
}
}

PointCells::PointCells(const UnstructuredGrid& grid, Progress& progress)
{
  Box all;
  std::vector<Box> boxes;
  for (Index c = 0; c < grid.cellCount(); ++c)
  {
    if (!grid.hidden.empty() && grid.hidden[at(c)] != 0)
    {
      continue;
    }
    Cell cell{ grid.shapes[at(c)], c, {} };
    for (std::size_t i = 0; i < 8; ++i)
    {
      cell.corners[i] =
        static_cast<std::uint32_t>(grid.corners[at(grid.cornerOffsets[at(c)] + boxCorners(cell.shape)[i])]);
    }
    cells_.push_back(cell);
    boxes.push_back(box(grid.points, size() - 1));
    all.add(boxes.back());
  }
  tolerance_ = relativeTolerance * all.diagonal();
  order_.resize(cells_.size());
  std::iota(order_.begin(), order_.end(), 0u);
  if (!cells_.empty())
  {
    build(boxes, 0, static_cast<std::uint32_t>(cells_.size()), progress);
  }
}

void PointCells::build(const std::vector<Box>& boxes, std::uint32_t begin, std::uint32_t end, Progress& progress)
{
  const std::size_t node = nodes_.size();
  nodes_.push_back({ {}, begin, end, 0 });
  Box centers;
  for (std::uint32_t i = begin; i < end; ++i)
  {
    nodes_[node].box.add(boxes[order_[i]]);
    centers.add(boxes[order_[i]].center());
  }
  if (end - begin <= cellsPerLeaf)
  {
    return;
  }
  progress.check();
  Index axis = 0;
  centers.size().maxCoeff(&axis);
  const std::uint32_t middle = begin + (end - begin) / 2;
  const auto key = [&](std::uint32_t cell) { return std::make_pair(boxes[cell].center()[axis], cell); };
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
    [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  build(boxes, begin, middle, progress);
  nodes_[node].second = static_cast<std::uint32_t>(nodes_.size());
  build(boxes, middle, end, progress);
}

Box PointCells::box(const std::vector<Vector>& points, Index cell) const
{
  Box result;
  for (const std::uint32_t corner : cells_[at(cell)].corners)
  {
    result.add(points[corner]);
  }
  return result;
}

NativeCell PointCells::nativeCell(const std::vector<Vector>& points, Index cell) const
{
  const Cell& own = cells_[at(cell)];
  if (own.shape == CellShape::Polyhedron)
  {
    throw InvalidInput("certified bounds are not available for point data on polyhedra: cell " +
                       std::to_string(own.gridCell) + " is one");
  }
  NativeCell result;
  result.kind = own.shape == CellShape::Tetrahedron ? NativeCell::Kind::Tetrahedron : NativeCell::Kind::Hexahedron;
  for (std::size_t i = 0; i < 8; ++i)
  {
    result.samples[i] = own.corners[i];
    result.corners[i] = points[own.corners[i]];
  }
  return result;
}

bool PointCells::holds(const std::vector<Vector>& points, Index cell, const Vector& p, Weights& weights) const
{
  const Cell& own = cells_[at(cell)];
  const Box around = box(points, cell);
  const double reach = relativeTolerance * around.diagonal();
  if (own.shape == CellShape::Polyhedron || around.squaredDistance(p) > reach * reach)
  {
    return false;
  }
  std::array<Vector, 8> corners;
  std::transform(
    own.corners.begin(), own.corners.end(), corners.begin(), [&](std::uint32_t corner) { return points[corner]; });
  return own.shape == CellShape::Tetrahedron ? weightsInTetrahedron(corners, p, weights)
                                             : invert(corners, p, reach, weights);
}

Index PointCells::cellAt(const std::vector<Vector>& points, const Vector& p, Weights& weights) const
{
  // Deep enough for a halving of 2^32 cells.
  std::array<std::uint32_t, 40> stack;
  std::size_t waiting = 0;
  if (!nodes_.empty())
  {
    stack[waiting++] = 0;
  }
  while (waiting > 0)
  {
    const std::uint32_t i = stack[--waiting];
    const Node& node = nodes_[i];
    if (node.box.squaredDistance(p) > tolerance_ * tolerance_)
    {
      continue;
    }
    if (node.second != 0)
    {
      stack[waiting++] = node.second;
      stack[waiting++] = i + 1;
      continue;
    }
    for (std::uint32_t k = node.begin; k < node.end; ++k)
    {
      if (holds(points, order_[k], p, weights))
      {
        return order_[k];
      }
    }
  }
  return -1;
}
}
