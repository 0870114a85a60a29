#include "Sample/Sample.h"

#include "Geometry/TetrahedronLocator.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>

namespace strata
{
namespace
{
using Range = tbb::blocked_range<Index>;
constexpr Index grain = 1024;

/// A point's place in the mesh.
struct Place
{
  Index cell = -1;
  TetrahedronLocator::Weights weights{};
};

/// Of the cells that hold the point, the one with the lowest index.
Place locate(const TetrahedronLocator& locator, const Vector& point)
{
  Place place;
  locator.visitCells(point, [&](std::int64_t cell, const TetrahedronLocator::Weights& weights) {
    if (place.cell < 0 || cell < place.cell)
    {
      place = { cell, weights };
    }
    return false;
  });
  return place;
}

double interpolate(const Representation& representation, const Place& place, const float* values, int components, int c)
{
  double sum = 0.0;
  for (int corner = 0; corner < 4; ++corner)
  {
    const std::int64_t vertex = representation.tetrahedra[4 * place.cell + corner];
    sum += place.weights[corner] * static_cast<double>(values[components * vertex + c]);
  }
  return sum;
}

/// The material with the smallest distance, the lowest one of several; -1 in a cell without materials.
std::int32_t materialAt(const Representation& representation, const Place& place)
{
  std::int32_t nearest = -1;
  double smallest = std::numeric_limits<double>::infinity();
  for (const MaterialId m : materialsOfCell(representation, place.cell))
  {
    const double distance = interpolate(representation, place, representation.distances[m.value], 1, 0);
    if (distance < smallest)
    {
      smallest = distance;
      nearest = m.value;
    }
  }
  return nearest;
}

Samples emptySamples(const Representation& representation, Index count)
{
  Samples result;
  result.material = Buffer<std::int32_t>(count);
  result.outside = Buffer<std::uint8_t>(count);
  result.cell = Buffer<std::int64_t>(count);
  for (const Field& field : representation.fields)
  {
    result.values.emplace_back(field.components * count);
  }
  return result;
}

void writeSample(const Representation& representation, const Place& place, Index i, Samples& result)
{
  result.cell[i] = place.cell;
  result.outside[i] = place.cell < 0 ? 1 : 0;
  result.material[i] = place.cell < 0 ? -1 : materialAt(representation, place);
  for (std::size_t field = 0; field < representation.fields.size(); ++field)
  {
    const int components = representation.fields[field].components;
    const float* values =
      result.material[i] < 0 ? nullptr : representation.values[field][static_cast<std::size_t>(result.material[i])];
    for (int c = 0; c < components; ++c)
    {
      result.values[field][components * i + c] =
        values ? static_cast<float>(interpolate(representation, place, values, components, c)) : std::nanf("");
    }
  }
}
}

Samples sample(const Representation& representation, const double* points, Index count, Progress& progress)
{
  const TetrahedronLocator locator(
    representation.points, representation.tetrahedra, representation.cellCount, [&] { progress.check(); });
  progress.update(0.3);
  Samples result = emptySamples(representation, count);
  tbb::parallel_for(Range(0, count, grain), [&](const Range& range) {
    progress.check();
    for (Index i = range.begin(); i != range.end(); ++i)
    {
      const Vector point(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
      writeSample(representation, locate(locator, point), i, result);
    }
  });
  progress.update(1.0);
  return result;
}
}
