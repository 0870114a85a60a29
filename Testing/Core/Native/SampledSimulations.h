#pragma once

#include "Model/Simulation.h"
#include "Native/ReadNativeData.h"

#include <functional>
#include <random>
#include <string>
#include <vector>

namespace strata::test
{
/// A value of a material at a point in space.
using Function = std::function<double(MaterialId, const Vector&)>;

inline ValueArray ownedArray(std::vector<double> values, int components = 1)
{
  auto owner = std::make_shared<std::vector<double>>(std::move(values));
  const auto tuples = static_cast<Index>(owner->size()) / components;
  return { owner->data(), tuples, components, owner };
}

/// n intervals from 0 to `length`; stretched so that each is `ratio` times as long as the one before.
inline std::vector<double> axis(int n, double length = 1.0, double ratio = 1.0)
{
  std::vector<double> result(1, 0.0);
  double step = 1.0;
  for (int i = 0; i < n; ++i)
  {
    result.push_back(result.back() + step);
    step *= ratio;
  }
  const double scale = length / result.back();
  for (double& x : result)
  {
    x *= scale;
  }
  return result;
}

inline RectilinearGrid boxGrid(int nx, int ny, int nz, double ratio = 1.0)
{
  RectilinearGrid grid;
  grid.coordinates = { axis(nx, 1.0, ratio), axis(ny, 1.0, 1.0 / ratio), axis(nz, 1.0, ratio) };
  return grid;
}

/// Cell centres or points of a rectilinear grid.
inline std::vector<Vector> samplePoints(const RectilinearGrid& grid, Association association)
{
  const int less = association == Association::Cells ? 1 : 0;
  const auto at = [&](std::size_t direction, std::size_t i) {
    const std::vector<double>& x = grid.coordinates[direction];
    return less == 1 ? 0.5 * (x[i] + x[i + 1]) : x[i];
  };
  const auto count = [&](std::size_t direction) {
    return grid.coordinates[direction].size() - static_cast<std::size_t>(less);
  };
  std::vector<Vector> result;
  for (std::size_t k = 0; k < count(2); ++k)
  {
    for (std::size_t j = 0; j < count(1); ++j)
    {
      for (std::size_t i = 0; i < count(0); ++i)
      {
        result.emplace_back(at(0, i), at(1, j), at(2, k));
      }
    }
  }
  return result;
}

/// Values of a function of one component at points.
inline ValueArray sampled(const Function& function, MaterialId m, const std::vector<Vector>& points)
{
  std::vector<double> values;
  for (const Vector& point : points)
  {
    values.push_back(function(m, point));
  }
  return ownedArray(std::move(values));
}

/// A scalar field with an array for each material.
inline SimulationField scalarField(const std::string& name, const Function& function, std::size_t materials,
  Association association, const std::vector<Vector>& points)
{
  SimulationField field;
  field.name = name;
  field.association = association;
  for (std::size_t m = 0; m < materials; ++m)
  {
    field.values.push_back(sampled(function, MaterialId(static_cast<Index>(m)), points));
  }
  return field;
}

/// Two materials with fields whose volume fractions at samples are given by a function of material 0's.
inline Simulation twoMaterials(const RectilinearGrid& grid, const std::function<double(const Vector&)>& fraction,
  const Function& field, Association association = Association::Cells)
{
  const std::vector<Vector> points = samplePoints(grid, association);
  Simulation simulation;
  simulation.grid = grid;
  simulation.materials = { { "block", true }, { "rod", true } };
  simulation.fractionAssociation = association;
  for (Index m = 0; m < 2; ++m)
  {
    simulation.fractions.push_back(
      sampled([&](MaterialId id, const Vector& p) { return id.value == 0 ? fraction(p) : 1.0 - fraction(p); },
        MaterialId(m), points));
  }
  simulation.fields.push_back(scalarField("density", field, 2, association, points));
  return simulation;
}

inline std::unique_ptr<NativeData> read(const Simulation& simulation, double minimumVolumeFraction = 0.1)
{
  Progress progress;
  return readNativeData(simulation, { minimumVolumeFraction }, progress);
}

/// The message of the InvalidInput that reading throws; empty if it throws none.
inline std::string messageOf(const Simulation& simulation)
{
  try
  {
    read(simulation);
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
  return {};
}

/// The one value of a data set with one scalar field.
inline double valueAt(const NativeData& data, MaterialId m, const Vector& point, bool inside = true,
  const Vector& closest = Vector::Zero(), GhostMethod method = GhostMethod::DataThenLinear)
{
  double result = 0.0;
  data.evaluate(m, point, inside, closest, method, &result);
  return result;
}

inline MaterialSet materialsOf(const NativeData& data, SampleIndex sample)
{
  MaterialSet result;
  data.materialsAt(&sample, 1, &result);
  return result;
}

inline Vector positionOf(const NativeData& data, SampleIndex sample)
{
  Vector result;
  data.positions(&sample, 1, &result);
  return result;
}

inline double sampleValue(const NativeData& data, FieldId field, MaterialId m, SampleIndex sample)
{
  double result = 0.0;
  data.values(field, m, &sample, 1, &result);
  return result;
}

inline Vector randomPoint(std::mt19937& random, double lower = 0.0, double upper = 1.0)
{
  std::uniform_real_distribution<double> number(lower, upper);
  const double x = number(random);
  const double y = number(random);
  return { x, y, number(random) };
}

/// A linear function with other coefficients for each material.
inline Function randomLinear(std::mt19937& random)
{
  const std::array<Vector, 2> slopes = { randomPoint(random, -1.0, 1.0), randomPoint(random, -1.0, 1.0) };
  return [slopes](
           MaterialId m, const Vector& p) { return 3.0 * m.value + slopes[static_cast<std::size_t>(m.value)].dot(p); };
}

inline const MaterialId block(0);
inline const MaterialId rod(1);
}
