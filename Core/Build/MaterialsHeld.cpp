#include "Build/MaterialsHeld.h"

#include <algorithm>
#include <limits>

namespace strata
{
namespace
{
MaterialSet materialsOfInterfaces(const CellElements& elements, const InterfaceElements& interfaces)
{
  MaterialSet result;
  for (std::uint32_t i = 0; i < elements.triangleCount(); ++i)
  {
    result = result | interfaces.materialsOfTriangle(elements.triangles()[i]);
  }
  for (std::uint32_t i = 0; i < elements.vertexCount(); ++i)
  {
    result = result | interfaces.materialsOfVertex(elements.vertices()[i]);
  }
  return result;
}

MaterialId nearestMaterial(const Hierarchy& hierarchy, CellId cell, MaterialSet allowed)
{
  MaterialId nearest;
  double smallest = std::numeric_limits<double>::infinity();
  for (const MaterialId m : allowed)
  {
    double sum = 0.0;
    for (const VertexId corner : hierarchy.cell(cell).corners)
    {
      sum += static_cast<double>(*hierarchy.valuesOf(corner, m));
    }
    nearest = sum < smallest ? m : nearest;
    smallest = std::min(smallest, sum);
  }
  return nearest;
}

MaterialSet materialsOfSamples(const CellElements& elements, const NativeData& native)
{
  constexpr Index blockSize = 256;
  std::array<MaterialSet, blockSize> sets;
  MaterialSet result;
  for (Index begin = 0; begin < elements.sampleCount(); begin += blockSize)
  {
    const Index count = std::min<Index>(blockSize, elements.sampleCount() - begin);
    native.materialsAt(elements.samples() + begin, count, sets.data());
    for (Index i = 0; i < count; ++i)
    {
      result = result | sets[static_cast<std::size_t>(i)];
    }
  }
  return result;
}
}

MaterialSet materialsHeld(const Hierarchy& hierarchy, CellId cell, const CellElements& elements, MaterialSet allowed,
  const NativeData& native, const InterfaceElements& interfaces)
{
  MaterialSet result = materialsOfInterfaces(elements, interfaces);
  if (result.empty())
  {
    result.insert(nearestMaterial(hierarchy, cell, allowed));
  }
  // All samples of a pure parent are of its one material.
  return allowed == result ? result : result | materialsOfSamples(elements, native);
}
}
