#include "Measure/Requirements.h"

#include "Model/Errors.h"

#include <string>

namespace strata
{
namespace
{
void require(bool condition, const std::string& message)
{
  if (!condition)
  {
    throw InvalidInput(message);
  }
}

void requireCount(std::size_t found, std::size_t expected, const std::string& what)
{
  require(found == expected,
    "there are " + std::to_string(found) + " " + what + ", but " + std::to_string(expected) + " are needed");
}

std::string namesOf(const Materials& materials)
{
  std::string names;
  for (const Material& material : materials)
  {
    names += (names.empty() ? "" : ", ") + material.name;
  }
  return names;
}

void requireSameMaterials(const Materials& represented, const Materials& original)
{
  bool same = represented.size() == original.size() && !original.empty();
  for (std::size_t m = 0; same && m < represented.size(); ++m)
  {
    same = represented[m].name == original[m].name;
  }
  require(same, "the representation has the materials " + namesOf(represented) + ", the original " + namesOf(original));
}

void requireComplete(const Representation& representation)
{
  require(representation.cellCount > 0 && representation.points && representation.tetrahedra,
    "the representation has no cells");
  requireCount(representation.distances.size(), representation.materials.size(), "distance arrays");
  requireCount(representation.values.size(), representation.fields.size(), "fields' values");
  for (const std::vector<const float*>& values : representation.values)
  {
    requireCount(values.size(), representation.materials.size(), "arrays of a field");
  }
  for (Index i = 0; i < 4 * representation.cellCount; ++i)
  {
    const std::int64_t vertex = representation.tetrahedra[i];
    require(vertex >= 0 && vertex < representation.vertexCount,
      "cell " + std::to_string(i / 4) + " of the representation has the vertex " + std::to_string(vertex) + " of " +
        std::to_string(representation.vertexCount));
  }
}

void requireMatchingFields(const Representation& representation, const NativeData& native)
{
  for (const Field& field : native.fields())
  {
    for (const Field& represented : representation.fields)
    {
      require(represented.name != field.name || represented.components == field.components,
        "field " + field.name + " has " + std::to_string(represented.components) + " components, the original " +
          std::to_string(field.components));
    }
  }
}

void requireValid(const Interfaces& interfaces, std::size_t materialCount)
{
  const auto validMaterial = [&](
                               MaterialId m) { return m.valid() && static_cast<std::size_t>(m.value) < materialCount; };
  for (const Interfaces::Surface& surface : interfaces.surfaces)
  {
    require(validMaterial(surface.positive) && validMaterial(surface.negative) && surface.positive != surface.negative,
      "an interface lies between the materials " + std::to_string(surface.positive.value) + " and " +
        std::to_string(surface.negative.value));
    for (const auto& triangle : surface.triangles)
    {
      for (const std::int32_t point : triangle)
      {
        require(point >= 0 && static_cast<std::size_t>(point) < interfaces.points.size(),
          "an interface triangle has the point " + std::to_string(point) + " of " +
            std::to_string(interfaces.points.size()));
      }
    }
  }
}
}

void requireMeasurable(const Representation& representation, const NativeData& native, const Interfaces& original,
  const OriginalVolumes& volumes)
{
  requireSameMaterials(representation.materials, native.materials());
  requireComplete(representation);
  requireMatchingFields(representation, native);
  requireValid(original, representation.materials.size());
  requireCount(volumes.volumes.size(), representation.materials.size(), "original volumes");
  if (!volumes.masses.empty())
  {
    requireCount(volumes.masses.size(), representation.materials.size(), "original masses");
  }
}
}
