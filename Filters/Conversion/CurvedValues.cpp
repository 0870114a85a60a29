#include "Conversion/CurvedValues.h"

#include "Conversion/CurvedDeviation.h"
#include "Conversion/ValueConversion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace strata::conversion
{
namespace
{
/// Sums and extremes of the values at each point.
class PointMeans
{
public:
  PointMeans(Index pointCount, int components) :
    components_(static_cast<std::size_t>(components)), counts_(static_cast<std::size_t>(pointCount), 0),
    sums_(counts_.size() * components_, 0.0), lowest_(sums_.size(), std::numeric_limits<double>::infinity()),
    highest_(sums_.size(), -std::numeric_limits<double>::infinity())
  {}

  template<typename ValueOf>
  void add(Index point, const ValueOf& valueOf)
  {
    ++counts_[static_cast<std::size_t>(point)];
    for (std::size_t c = 0; c < components_; ++c)
    {
      const std::size_t place = static_cast<std::size_t>(point) * components_ + c;
      const double value = valueOf(static_cast<int>(c));
      sums_[place] += value;
      lowest_[place] = std::min(lowest_[place], value);
      highest_[place] = std::max(highest_[place], value);
    }
  }

  bool has(std::size_t point) const { return counts_[point] > 0; }
  double mean(std::size_t point, std::size_t component) const
  {
    return sums_[point * components_ + component] / counts_[point];
  }
  double jump(std::size_t point) const
  {
    double squares = 0.0;
    for (std::size_t c = 0; c < components_ && has(point); ++c)
    {
      const std::size_t place = point * components_ + c;
      squares += (highest_[place] - lowest_[place]) * (highest_[place] - lowest_[place]);
    }
    return std::sqrt(squares);
  }

private:
  std::size_t components_;
  std::vector<Index> counts_;
  std::vector<double> sums_;
  std::vector<double> lowest_;
  std::vector<double> highest_;
};
}

CurvedValues curvedValues(const InputGrid& input, const BlockArrays& arrays,
  const std::vector<std::int32_t>& materialIds, std::int32_t material)
{
  const auto& grid = std::get<UnstructuredGrid>(input.grid);
  PointMeans all(grid.pointCount(), arrays.components);
  PointMeans own(grid.pointCount(), arrays.components);
  for (std::size_t cell = 0; cell < grid.shapes.size(); ++cell)
  {
    const bool isOwn = materialIds.empty() || materialIds[cell] == material;
    for (auto k = static_cast<std::size_t>(grid.cornerOffsets[cell]);
         k < static_cast<std::size_t>(grid.cornerOffsets[cell + 1]); ++k)
    {
      (isOwn ? own : all).add(grid.corners[k], [&](int c) { return valueAt(input, arrays, input.cornerSource[k], c); });
    }
  }
  CurvedValues result;
  std::vector<double> values;
  for (std::size_t point = 0; point < grid.points.size(); ++point)
  {
    const PointMeans& means = own.has(point) ? own : all;
    for (int c = 0; c < arrays.components; ++c)
    {
      values.push_back(means.mean(point, static_cast<std::size_t>(c)));
    }
    result.largestJump = std::max(result.largestJump, own.jump(point));
  }
  result.values = ownedValues(std::move(values), arrays.components);
  return result;
}

double curvedDeviation(const InputGrid& input, const BlockArrays& arrays)
{
  CurvedDeviation deviation(arrays.components);
  std::vector<double> values;
  for (const CurvedCell& cell : input.curved)
  {
    values.clear();
    for (const Index node : cell.nodes)
    {
      for (int c = 0; c < arrays.components; ++c)
      {
        values.push_back(valueAt(input, arrays, node, c));
      }
    }
    deviation.add(*cell.pattern, values);
  }
  return deviation.bound();
}
}
