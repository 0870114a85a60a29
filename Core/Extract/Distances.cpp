#include "Extract/Distances.h"

#include "Extract/ForEach.h"
#include "Extract/VolumeBelow.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace strata
{
namespace
{
constexpr int sweepCount = 4;
/// Value of a fraction f without a direction, as a part of the cell's size times f - 1/2.
constexpr double undirectedSlope = 0.1;

/// A border that leaves less than this part of a cell on one side has a direction though the fractions around hardly
/// change: those are set against the part itself.
constexpr double smallFraction = 0.05;

/// Added to the smaller part of a cell on either side of a border to weigh its plane among those of its neighbours:
/// the plane through a small corner is the least certain.
constexpr double leastWeight = 0.1;

/// 0 below `from`, 1 above `to`, linear between.
double ramp(double x, double from, double to)
{
  return std::clamp((x - from) / (to - from), 0.0, 1.0);
}

/// The border of a material in a cell: its distance is offset - normal . (x - centre).
struct Border
{
  bool exists = false;
  double sharpness = 0.0; ///< 0: the fractions around have no direction; 1: as round a plane
  double offset = 0.0;
  Vector normal = Vector::Zero(); ///< points out of the material
};

class DistanceFit
{
public:
  DistanceFit(const MixedRegion& region, MaterialValues& values, Progress& progress) :
    complex_(region.complex), topology_(region.topology), fractions_(region.fractions), values_(values),
    progress_(progress), around_(region.around), means_(values.values), borders_(values.values.size()),
    sizes_(complex_.cells.size())
  {}

  void run()
  {
    forEach(complex_.cellCount(), progress_, [this](std::int32_t c) {
      sizes_[c] = std::cbrt(VolumeBelow(complex_, c).total());
      startBorders(c);
    });
    placeValues();
    for (int sweep = 1; sweep < sweepCount; ++sweep)
    {
      forEach(complex_.cellCount(), progress_, [this](std::int32_t c) { turnBorders(c); });
      placeValues();
    }
  }

private:
  bool partial(Index entry) const { return means_[entry] > 1e-9 && means_[entry] < 1.0 - 1e-9; }

  /// Normals from the gradient of the fractions, by least squares over the cells that share a point. The weights, a
  /// product over the axes, keep the gradient of a border along the grid free of the other axes at boundaries too.
  void startBorders(std::int32_t c)
  {
    const std::int32_t center = complex_.cellVertex(c);
    const Index begin = values_.start[center];
    const Index end = values_.start[center + 1];
    if (end - begin < 2)
    {
      return;
    }
    std::vector<Index> cells;
    std::vector<Index> around;
    for (std::int32_t i = around_.nodeStart[c]; i < around_.nodeStart[c + 1]; ++i)
    {
      topology_.cellsAround(complex_.nodes[around_.nodes[i]], around);
      cells.insert(cells.end(), around.begin(), around.end());
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    const Eigen::Matrix3d shape = shapeOf(c);
    const Eigen::Matrix3d metric = shape.inverse();
    Eigen::Matrix4d normalEquations = Eigen::Matrix4d::Zero();
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(4, end - begin);
    std::vector<Share> shares;
    for (Index cell : cells)
    {
      const Vector step = topology_.center(cell) - complex_.positions[center];
      const Eigen::Vector4d row(1.0, step[0], step[1], step[2]);
      const double weight = std::exp2(-0.25 * step.dot(metric * step));
      normalEquations += weight * row * row.transpose();
      fractions_.ofCell(cell, shares);
      for (Index e = begin; e < end; ++e)
      {
        right.col(e - begin) += weight * valueOf(shares, values_.materials[e]) * row;
      }
    }
    normalEquations.bottomRightCorner<3, 3>() += 1e-9 * shape;
    const Eigen::MatrixXd fit = normalEquations.ldlt().solve(right);
    for (Index e = begin; e < end; ++e)
    {
      if (partial(e))
      {
        const Vector gradient = fit.col(e - begin).tail<3>();
        const double width = 2.0 * std::sqrt(gradient.dot(shape * gradient)); // |gradient| times the cell's width
        borders_[e].exists = true;
        const double scale = std::min(1.0, std::min(means_[e], 1.0 - means_[e]) / smallFraction);
        borders_[e].sharpness = ramp(2.0 * width, 0.3 * scale, 0.6 * scale);
        setNormal(c, e, gradient);
      }
    }
  }

  /// The mean of d d^T over the cell's points, d from the centre: a quarter of the squared edges for a box.
  Eigen::Matrix3d shapeOf(std::int32_t c) const
  {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::int32_t i = around_.nodeStart[c]; i < around_.nodeStart[c + 1]; ++i)
    {
      const Vector d = complex_.positions[around_.nodes[i]] - complex_.positions[complex_.cellVertex(c)];
      sum += d * d.transpose();
    }
    return sum / static_cast<double>(around_.nodeStart[c + 1] - around_.nodeStart[c]);
  }

  /// Normals from the gradient of the distances at the cell's points.
  void turnBorders(std::int32_t c)
  {
    const std::int32_t center = complex_.cellVertex(c);
    for (Index e = values_.start[center]; e < values_.start[center + 1]; ++e)
    {
      if (!borders_[e].exists || borders_[e].sharpness <= 0.0)
      {
        continue;
      }
      const Vector middle = middleOfNodes(c);
      Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
      Vector gradient = Vector::Zero();
      for (std::int32_t i = around_.nodeStart[c]; i < around_.nodeStart[c + 1]; ++i)
      {
        const std::int32_t node = around_.nodes[i];
        const Vector step = complex_.positions[node] - middle;
        spread += step * step.transpose();
        gradient += values_.at(node, values_.materials[e]) * step;
      }
      setNormal(c, e, spread.ldlt().solve(gradient));
    }
  }

  /// Not the cell's centre where points hang on its faces.
  Vector middleOfNodes(std::int32_t c) const
  {
    Vector sum = Vector::Zero();
    for (std::int32_t i = around_.nodeStart[c]; i < around_.nodeStart[c + 1]; ++i)
    {
      sum += complex_.positions[around_.nodes[i]];
    }
    return sum / static_cast<double>(around_.nodeStart[c + 1] - around_.nodeStart[c]);
  }

  void setNormal(std::int32_t c, Index entry, const Vector& gradient)
  {
    Border& border = borders_[entry];
    if (gradient.norm() > 0.0)
    {
      border.normal = -gradient.normalized();
      border.offset = VolumeBelow(complex_, c, border.normal).offset(means_[entry]);
    }
  }

  double distance(std::int32_t c, Index entry, const Vector& x) const
  {
    const Border& border = borders_[entry];
    const Vector d = x - complex_.positions[complex_.cellVertex(c)];
    const double directed = border.offset - border.normal.dot(d);
    if (border.sharpness >= 1.0)
    {
      return directed;
    }
    // Growing outwards, so that a material in a cell without neighbours of its kind becomes a drop at its centre.
    const double undirected =
      undirectedSlope * (means_[entry] - 0.5) * sizes_[c] * (1.0 + 0.25 * d.dot(shapeOf(c).inverse() * d));
    return border.sharpness * directed + (1.0 - border.sharpness) * undirected;
  }

  void placeValues()
  {
    values_.absent.resize(static_cast<std::size_t>(complex_.vertexCount()));
    forEach(complex_.vertexCount(), progress_, [this](std::int32_t v) {
      double size = 0.0;
      for (std::int32_t i = around_.start[v]; i < around_.start[v + 1]; ++i)
      {
        size = std::max(size, sizes_[around_.cells[i]]);
      }
      values_.absent[v] = -size;
      for (Index entry = values_.start[v]; entry < values_.start[v + 1]; ++entry)
      {
        values_.values[entry] = valueAt(v, entry, size);
      }
    });
  }

  double valueAt(std::int32_t v, Index entry, double size) const
  {
    double sum = 0.0;
    double count = 0.0;
    for (std::int32_t i = around_.start[v]; i < around_.start[v + 1]; ++i)
    {
      const std::int32_t c = around_.cells[i];
      const Index e = values_.find(complex_.cellVertex(c), values_.materials[entry]);
      if (e >= 0 && borders_[e].exists)
      {
        const double weight = std::min(means_[e], 1.0 - means_[e]) + leastWeight;
        sum += weight * distance(c, e, complex_.positions[v]);
        count += weight;
      }
    }
    return count > 0.0 ? sum / count : (2.0 * means_[entry] - 1.0) * size;
  }

  const CellComplex& complex_;
  const GridTopology& topology_;
  const Fractions& fractions_;
  MaterialValues& values_;
  Progress& progress_;
  const CellsAround& around_;
  std::vector<double> means_;   ///< the fractions, by entry of the values
  std::vector<Border> borders_; ///< by entry; only those of cell centres are used
  std::vector<double> sizes_;   ///< cube root of each cell's volume
};
}

void turnIntoDistances(const MixedRegion& region, MaterialValues& values, Progress& progress)
{
  DistanceFit(region, values, progress).run();
}
}
