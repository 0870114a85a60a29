#pragma once

#include "Geometry/Box.h"
#include "Model/Mesh.h"
#include "Model/Representation.h"

#include <array>
#include <cmath>
#include <limits>

namespace strata::test
{
/// A representation made by hand: n^3 equal boxes, each cut into the six Kuhn tetrahedra round its diagonal, without
/// distances and values yet. Vertex (i,j,k) is number i + (n+1) (j + (n+1) k).
inline Mesh kuhnMesh(const Box& box, int n, const Materials& materials, const std::vector<Field>& fields)
{
  constexpr std::array<std::array<int, 3>, 6> paths = { { { 0, 1, 2 }, { 0, 2, 1 }, { 1, 0, 2 }, { 1, 2, 0 },
    { 2, 0, 1 }, { 2, 1, 0 } } };
  constexpr std::array<bool, 6> even = { true, false, false, true, true, false };
  Mesh mesh;
  mesh.materials = materials;
  mesh.fields = fields;
  const Index side = n + 1;
  mesh.points = Buffer<double>(3 * side * side * side);
  mesh.tetrahedra = Buffer<std::int64_t>(Index{ 4 } * 6 * n * n * n);
  const auto vertex = [side](int i, int j, int k) { return i + side * (j + side * k); };
  for (int k = 0; k <= n; ++k)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        const Vector p = box.lower + box.size().cwiseProduct(Vector(i, j, k)) / n;
        std::copy(p.data(), p.data() + 3, mesh.points.data() + 3 * vertex(i, j, k));
      }
    }
  }
  std::int64_t* corner = mesh.tetrahedra.data();
  for (int cube = 0; cube < n * n * n; ++cube)
  {
    for (std::size_t path = 0; path < paths.size(); ++path)
    {
      std::array<int, 3> at = { cube % n, cube / n % n, cube / (n * n) };
      std::int64_t* first = corner;
      *corner++ = vertex(at[0], at[1], at[2]);
      for (const int axis : paths[path])
      {
        ++at[static_cast<std::size_t>(axis)];
        *corner++ = vertex(at[0], at[1], at[2]);
      }
      if (!even[path])
      {
        std::swap(first[2], first[3]);
      }
    }
  }
  mesh.distances.resize(materials.size());
  mesh.values.resize(fields.size());
  for (std::vector<Buffer<float>>& values : mesh.values)
  {
    values.resize(materials.size());
  }
  return mesh;
}

inline Vector vertexPosition(const Mesh& mesh, Index vertex)
{
  return { mesh.points[3 * vertex], mesh.points[3 * vertex + 1], mesh.points[3 * vertex + 2] };
}

/// Gives each vertex the distance to a material's region, distance(position), rounded to float.
template<class Distance>
void setDistances(Mesh& mesh, MaterialId m, Distance&& distance)
{
  Buffer<float>& result = mesh.distances[static_cast<std::size_t>(m.value)];
  result = Buffer<float>(mesh.vertexCount());
  for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
  {
    result[vertex] = static_cast<float>(distance(vertexPosition(mesh, vertex)));
  }
}

/// Gives each vertex a material's value of a field, value(position, component), rounded to float.
template<class Value>
void setValues(Mesh& mesh, FieldId field, MaterialId m, Value&& value)
{
  const int components = mesh.fields[static_cast<std::size_t>(field.value)].components;
  Buffer<float>& result = mesh.values[static_cast<std::size_t>(field.value)][static_cast<std::size_t>(m.value)];
  result = Buffer<float>(mesh.vertexCount() * components);
  for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
  {
    for (int c = 0; c < components; ++c)
    {
      result[vertex * components + c] = static_cast<float>(value(vertexPosition(mesh, vertex), c));
    }
  }
}

/// Distances for two materials with a common border: `side` is the signed distance, positive in `positive`.
template<class Side>
void setTwoMaterials(Mesh& mesh, MaterialId positive, MaterialId negative, Side&& side)
{
  setDistances(mesh, positive, [&](const Vector& p) { return std::max(0.0, -side(p)); });
  setDistances(mesh, negative, [&](const Vector& p) { return std::max(0.0, side(p)); });
}
}
