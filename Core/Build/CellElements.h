#pragma once

#include "Build/ClippedTriangle.h"
#include "Build/Tetrahedron.h"
#include "Model/Interfaces.h"
#include "Model/NativeData.h"
#include "Model/Progress.h"

#include <memory>

namespace strata
{
/// The native elements that meet a cell: samples, interface vertices, interface triangles and, where whole native
/// cells count, those that may meet it. Elements on a face belong to the cells on both sides.
struct CellElements
{
  std::unique_ptr<std::uint32_t[]> ids;
  std::uint32_t sampleEnd = 0;
  std::uint32_t vertexEnd = 0;
  std::uint32_t triangleEnd = 0;
  std::uint32_t nativeCellEnd = 0;

  const std::uint32_t* samples() const { return ids.get(); }
  const std::uint32_t* vertices() const { return ids.get() + sampleEnd; }
  const std::uint32_t* triangles() const { return ids.get() + vertexEnd; }
  const std::uint32_t* nativeCells() const { return ids.get() + triangleEnd; }
  std::uint32_t sampleCount() const { return sampleEnd; }
  std::uint32_t vertexCount() const { return vertexEnd - sampleEnd; }
  std::uint32_t triangleCount() const { return triangleEnd - vertexEnd; }
  std::uint32_t nativeCellCount() const { return nativeCellEnd - triangleEnd; }
};

/// All interface triangles in one list, and the pairs of materials that meet at each interface vertex.
struct InterfaceElements
{
  struct Pair
  {
    MaterialId positive;
    MaterialId negative;
  };

  std::vector<Vector> points;
  std::vector<std::array<std::int32_t, 3>> triangles;
  std::vector<std::int32_t> pairOfTriangle;
  std::vector<Pair> pairs;
  /// Pairs at vertex v: vertexPairs[vertexPairOffsets[v]] .. vertexPairs[vertexPairOffsets[v + 1]].
  std::vector<std::int32_t> vertexPairOffsets;
  std::vector<std::int32_t> vertexPairs;

  explicit InterfaceElements(const Interfaces& interfaces);
  MaterialSet materialsOfTriangle(std::uint32_t triangle) const;
  MaterialSet materialsOfVertex(std::uint32_t vertex) const;
};

/// All samples that count for a material, all interface vertices and triangles and, if asked for, all native cells that
/// count for a material as a whole.
CellElements allElements(
  const NativeData& native, const InterfaceElements& interfaces, bool withNativeCells, Progress& progress);

/// The part of `all` that meets a cell; `all` must hold every element that may.
CellElements elementsWithin(
  const Barycentric& cell, const CellElements& all, const NativeData& native, const InterfaceElements& interfaces);

/// Elements of several cells together, each once.
CellElements united(const std::vector<const CellElements*>& parts);

/// Whether a triangle meets a tetrahedron.
bool meets(const Barycentric& cell, const std::array<Vector, 3>& triangle);
/// False only if a box and a tetrahedron don't meet.
bool mayMeet(const Barycentric& cell, const Box& box);
}
