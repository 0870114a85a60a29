#pragma once

#include "Support/RepresentationCube.h"

#include <random>
#include <vector>

namespace strata::test
{
/// How the distances of random regions are drawn.
enum class RandomDistances
{
  Reals, ///< in [0, 1)
  Ties   ///< 0 or 1: every kind of tie
};

/// The unit cube of n^3 cubes with materials whose distances are random at each vertex, so that regions meet in all
/// ways, and two fields, linear in each material: "scalar", and "vector" with three components. The last material has
/// no fields.
inline Mesh randomRegions(int n, int materials, RandomDistances draw, unsigned seed)
{
  Materials names;
  for (int m = 0; m < materials; ++m)
  {
    names.push_back({ "m" + std::to_string(m), m + 1 < materials });
  }
  Box box;
  box.add(Vector(0, 0, 0));
  box.add(Vector(1, 1, 1));
  Mesh mesh = kuhnMesh(box, n, names, { { "scalar", 1 }, { "vector", 3 } });
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> real(0.0, 1.0);
  std::uniform_int_distribution<int> integer(0, 1);
  for (int m = 0; m < materials; ++m)
  {
    const MaterialId id(m);
    setDistances(
      mesh, id, [&](const Vector&) { return draw == RandomDistances::Reals ? real(random) : integer(random); });
    if (names[static_cast<std::size_t>(m)].hasFields)
    {
      setValues(mesh, FieldId(0), id, [&](const Vector& p, int) { return 10.0 * m + p[0] - 2.0 * p[1] + 3.0 * p[2]; });
      setValues(mesh, FieldId(1), id, [&](const Vector& p, int c) { return p[c] - m; });
    }
  }
  return mesh;
}

/// All materials of a mesh.
inline MaterialSet allMaterials(const Mesh& mesh)
{
  MaterialSet result;
  for (std::size_t m = 0; m < mesh.materials.size(); ++m)
  {
    result.insert(MaterialId(static_cast<Index>(m)));
  }
  return result;
}

template<typename T>
std::vector<T> copyOf(const Buffer<T>& buffer)
{
  return std::vector<T>(buffer.begin(), buffer.end());
}
}
