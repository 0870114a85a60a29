#include "Model/CopyMesh.h"

#include <algorithm>

namespace strata
{
namespace
{
template<typename T>
std::size_t bytes(const Buffer<T>& buffer)
{
  return static_cast<std::size_t>(buffer.size()) * sizeof(T);
}

template<typename T>
std::size_t bytes(const std::vector<T>& buffers)
{
  std::size_t sum = 0;
  for (const T& buffer : buffers)
  {
    sum += bytes(buffer);
  }
  return sum;
}

template<typename T>
Buffer<T> copy(const Buffer<T>& buffer)
{
  Buffer<T> result(buffer.size());
  std::copy(buffer.begin(), buffer.end(), result.begin());
  return result;
}

template<typename T>
std::vector<T> copy(const std::vector<T>& buffers)
{
  std::vector<T> result;
  for (const T& buffer : buffers)
  {
    result.push_back(copy(buffer));
  }
  return result;
}
}

std::size_t bytesOf(const Mesh& mesh)
{
  return bytes(mesh.points) + bytes(mesh.tetrahedra) + bytes(mesh.distances) + bytes(mesh.ghosts) + bytes(mesh.values) +
         bytes(mesh.vertexMaterial) + bytes(mesh.composite) + bytes(mesh.cellMaterial) + bytes(mesh.cellLevel) +
         bytes(mesh.cellInterfaceError) + bytes(mesh.cellFieldErrors);
}

Mesh copyOf(const Mesh& mesh)
{
  return { mesh.materials, mesh.fields, copy(mesh.points), copy(mesh.tetrahedra), copy(mesh.distances),
    copy(mesh.ghosts), copy(mesh.values), copy(mesh.vertexMaterial), copy(mesh.composite), copy(mesh.cellMaterial),
    copy(mesh.cellLevel), copy(mesh.cellInterfaceError), copy(mesh.cellFieldErrors), mesh.achieved };
}
}
