#include "Model/Representation.h"

#include <cmath>

namespace strata
{
Representation view(const Mesh& mesh)
{
  Representation result;
  result.materials = mesh.materials;
  result.fields = mesh.fields;
  result.vertexCount = mesh.vertexCount();
  result.cellCount = mesh.cellCount();
  result.points = mesh.points.data();
  result.tetrahedra = mesh.tetrahedra.data();
  for (const Buffer<float>& distance : mesh.distances)
  {
    result.distances.push_back(distance.data());
  }
  for (const std::vector<Buffer<float>>& field : mesh.values)
  {
    result.values.emplace_back();
    for (const Buffer<float>& values : field)
    {
      result.values.back().push_back(values.data());
    }
  }
  return result;
}

MaterialSet materialsOfCell(const Representation& representation, Index cell)
{
  MaterialSet result;
  const std::int64_t* corners = representation.tetrahedra + 4 * cell;
  for (std::size_t m = 0; m < representation.distances.size(); ++m)
  {
    const float* distance = representation.distances[m];
    if (distance && !std::isnan(distance[corners[0]]) && !std::isnan(distance[corners[1]]) &&
        !std::isnan(distance[corners[2]]) && !std::isnan(distance[corners[3]]))
    {
      result.insert(MaterialId(static_cast<Index>(m)));
    }
  }
  return result;
}
}
