#include "Extract/CellCutter.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace strata
{
std::uint8_t CellCutter::only(std::int32_t cell) const
{
  const std::uint8_t winner = winners_[complex_.cellVertex(cell)];
  for (std::int32_t i = complex_.cellFaceStart[cell]; i < complex_.cellFaceStart[cell + 1]; ++i)
  {
    const std::int32_t face = complex_.cellFaces[i].face;
    if (winners_[complex_.faceVertex(face)] != winner)
    {
      return several;
    }
    for (std::int32_t k = complex_.faceStart[face]; k < complex_.faceStart[face + 1]; ++k)
    {
      if (winners_[complex_.faceCorners[k]] != winner)
      {
        return several;
      }
    }
  }
  return winner;
}

std::size_t CellCutter::Regions::of(std::uint8_t material)
{
  const auto found = std::find(materials.begin(), materials.end(), material);
  if (found != materials.end())
  {
    return static_cast<std::size_t>(found - materials.begin());
  }
  materials.push_back(material);
  volumes.push_back(0.0);
  derivatives.resize(derivatives.size() + MaterialSet::capacity, 0.0);
  return materials.size() - 1;
}

void CellCutter::Regions::clear()
{
  materials.clear();
  volumes.clear();
  derivatives.clear();
  total = 0.0;
}

bool CellCutter::gather(const std::array<std::int32_t, 4>& vertices)
{
  functions_.clear();
  std::uint64_t present = 0;
  const std::uint8_t first = winners_[vertices[0]];
  bool same = true;
  for (std::int32_t vertex : vertices)
  {
    same = same && winners_[vertex] == first;
    for (Index i = values_.start[vertex]; i < values_.start[vertex + 1]; ++i)
    {
      present |= std::uint64_t{ 1 } << values_.materials[i];
    }
  }
  if (same)
  {
    functions_.push_back({ first, {} });
    return false;
  }
  for (std::uint64_t rest = present; rest != 0; rest &= rest - 1)
  {
    const auto material = static_cast<std::uint8_t>(__builtin_ctzll(rest));
    CornerValues function;
    function.function = material;
    for (int corner = 0; corner < 4; ++corner)
    {
      function.values[corner] = -values_.at(vertices[corner], material);
    }
    functions_.push_back(function);
  }
  // What is beaten by one other at all corners wins nowhere.
  std::uint64_t beaten = 0;
  for (std::size_t i = 0; i < functions_.size(); ++i)
  {
    for (std::size_t j = 0; j < functions_.size(); ++j)
    {
      bool everywhere = true;
      for (int corner = 0; corner < 4; ++corner)
      {
        everywhere = everywhere && functions_[j].values[corner] < functions_[i].values[corner];
      }
      beaten |= everywhere ? std::uint64_t{ 1 } << i : 0;
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < functions_.size(); ++i)
  {
    if (((beaten >> i) & 1u) == 0)
    {
      functions_[kept++] = functions_[i];
    }
  }
  functions_.resize(kept);
  return functions_.size() > 1;
}

void CellCutter::volumes(std::int32_t cell, Regions& regions)
{
  regions.clear();
  complex_.forEachTetrahedron(cell, [&](std::int32_t c, std::int32_t f, std::int32_t a, std::int32_t b) {
    const Vector& apex = complex_.positions[c];
    const Vector u = complex_.positions[f] - apex;
    const double volume = u.dot((complex_.positions[a] - apex).cross(complex_.positions[b] - apex)) / 6.0;
    regions.total += volume;
    if (!gather({ c, f, a, b }))
    {
      regions.volumes[regions.of(static_cast<std::uint8_t>(functions_[0].function))] += volume;
      return;
    }
    const std::size_t count = functions_.size();
    tetrahedronVolumes_.resize(count);
    tetrahedronDerivatives_.resize(count * count);
    regionVolumesAndDerivatives(
      functions_.data(), static_cast<int>(count), cut_, tetrahedronVolumes_.data(), tetrahedronDerivatives_.data());
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::size_t region = regions.of(static_cast<std::uint8_t>(functions_[i].function));
      regions.volumes[region] += volume * tetrahedronVolumes_[i];
      for (std::size_t j = 0; j < count; ++j)
      {
        // The functions are minus the values.
        regions.derivatives[region * MaterialSet::capacity + static_cast<std::size_t>(functions_[j].function)] -=
          volume * tetrahedronDerivatives_[count * i + j];
      }
    }
  });
}

void CellCutter::addPolygon(const TetrahedronCut::Face& face, std::uint8_t front, SurfacePatch& patch)
{
  const auto back = static_cast<std::uint8_t>(face.function);
  const auto number = [&](int i) {
    std::int32_t& known = numbers_[cut_.loops()[i]];
    if (known < 0)
    {
      known = patch.addPoint(
        cut_.points()[cut_.loops()[i]].interpolate([this](std::int64_t vertex) { return complex_.positions[vertex]; }));
    }
    return known;
  };
  for (int i = face.begin + 1; i + 1 < face.end; ++i)
  {
    patch.addTriangle(front, back, { number(face.begin), number(i), number(i + 1) });
  }
}

void CellCutter::addTetrahedron(
  const std::array<std::int32_t, 4>& vertices, bool atOutside, std::uint8_t outside, SurfacePatch& patch)
{
  const bool mixed = gather(vertices);
  const auto winner = static_cast<std::uint8_t>(functions_[0].function);
  if (!mixed)
  {
    if (atOutside && winner != outside)
    {
      const auto number = [&](int i) { return patch.addPoint(complex_.positions[vertices[i]]); };
      patch.addTriangle(outside, winner, { number(1), number(2), number(3) });
    }
    return;
  }
  cut_.cut(
    { vertices[0], vertices[1], vertices[2], vertices[3] }, functions_.data(), static_cast<int>(functions_.size()));
  numbers_.assign(cut_.points().size(), -1);
  for (const TetrahedronCut::Face& face : cut_.faces())
  {
    if (face.isInterface())
    {
      addPolygon(face, static_cast<std::uint8_t>(face.beyond), patch);
    }
    else if (atOutside && face.beyond == -1 && face.function != outside) // opposite to the cell's centre
    {
      addPolygon(face, outside, patch);
    }
  }
}

void CellCutter::addInterfaces(
  std::int32_t cell, const std::vector<std::uint8_t>& facesOutside, std::uint8_t outside, SurfacePatch& patch)
{
  for (std::int32_t i = complex_.cellFaceStart[cell]; i < complex_.cellFaceStart[cell + 1]; ++i)
  {
    const CellComplex::OrientedFace oriented = complex_.cellFaces[i];
    const bool atOutside = !facesOutside.empty() && facesOutside[oriented.face] != 0;
    complex_.forEachTriangle(oriented, [&](std::int32_t center, std::int32_t a, std::int32_t b) {
      addTetrahedron({ complex_.cellVertex(cell), center, a, b }, atOutside, outside, patch);
    });
  }
}
}
