#include "Extract/CellCutter.h"

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

bool CellCutter::compete(const std::array<int, 4>& rows)
{
  functions_.clear();
  slots_.clear();
  const int count = table_.count();
  for (int i = 0; i < count; ++i)
  {
    // What is beaten by one other at all corners wins nowhere.
    bool beaten = false;
    for (int j = 0; j < count && !beaten; ++j)
    {
      beaten = true;
      for (int corner = 0; corner < 4 && beaten; ++corner)
      {
        const double* values = table_.row(rows[corner]);
        beaten = values[i] < values[j];
      }
    }
    if (!beaten)
    {
      functions_.push_back({ table_.materials()[i], {} });
      slots_.push_back(i);
      for (int corner = 0; corner < 4; ++corner)
      {
        functions_.back().values[corner] = -table_.row(rows[corner])[i];
      }
    }
  }
  return functions_.size() > 1;
}

void CellCutter::volumes(std::int32_t cell, Regions& regions, Rise rise)
{
  table_.gather(cell);
  const auto count = static_cast<std::size_t>(table_.count());
  regions.materials = table_.materials();
  regions.volumes.assign(count, 0.0);
  regions.derivatives.assign(count * count, 0.0);
  regions.total = 0.0;
  table_.forEachTetrahedron([&](double volume, int, int, int) { regions.total += volume; });
  if (count == 1)
  {
    regions.volumes[0] = regions.total;
  }
  else if (count == 2 && rise == Rise::Everywhere)
  {
    halve(regions);
  }
  else
  {
    share(regions, rise);
  }
}

void CellCutter::halve(Regions& regions) const
{
  const auto lead = [this](int row) { return table_.row(row)[1] - table_.row(row)[0]; };
  double first = 0.0;
  double growth = 0.0;
  table_.forEachTetrahedron([&](double volume, int f, int a, int b) {
    const NegativePart part = negativePart({ lead(0), lead(f), lead(a), lead(b) });
    first += volume * part.volume;
    growth += volume * part.derivative;
  });
  regions.volumes = { first, regions.total - first };
  regions.derivatives = { growth, -growth, -growth, growth };
}

void CellCutter::share(Regions& regions, Rise rise)
{
  const auto materialCount = regions.materials.size();
  table_.forEachTetrahedron([&](double volume, int f, int a, int b) {
    if (!compete({ 0, f, a, b }))
    {
      regions.volumes[slots_[0]] += volume;
      return;
    }
    const std::size_t count = functions_.size();
    tetrahedronVolumes_.resize(count);
    tetrahedronDerivatives_.resize(count * count);
    const auto measure = rise == Rise::Everywhere ? regionVolumesAndDerivatives : regionVolumesAndCornerDerivatives;
    measure(
      functions_.data(), static_cast<int>(count), cut_, tetrahedronVolumes_.data(), tetrahedronDerivatives_.data());
    for (std::size_t i = 0; i < count; ++i)
    {
      regions.volumes[slots_[i]] += volume * tetrahedronVolumes_[i];
      for (std::size_t j = 0; j < count; ++j)
      {
        // The functions are minus the values.
        regions.derivatives[materialCount * slots_[i] + slots_[j]] -= volume * tetrahedronDerivatives_[count * i + j];
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

void CellCutter::addTetrahedron(const std::array<std::int32_t, 4>& vertices, const std::array<int, 4>& rows,
  std::optional<std::uint8_t> outside, SurfacePatch& patch)
{
  const bool mixed = compete(rows);
  const auto winner = static_cast<std::uint8_t>(functions_[0].function);
  if (!mixed)
  {
    if (outside && winner != *outside)
    {
      const auto number = [&](int i) { return patch.addPoint(complex_.positions[vertices[i]]); };
      patch.addTriangle(*outside, winner, { number(1), number(2), number(3) });
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
    else if (outside && face.beyond == -1 && face.function != *outside) // opposite to the cell's centre
    {
      addPolygon(face, *outside, patch);
    }
  }
}

void CellCutter::addInterfaces(
  std::int32_t cell, const std::vector<std::uint8_t>& facesOutside, std::uint8_t outside, SurfacePatch& patch)
{
  table_.gather(cell);
  table_.forEachTetrahedron([&](double, int f, int a, int b) {
    const std::int32_t faceVertex = table_.vertex(f);
    const bool atOutside = !facesOutside.empty() && facesOutside[faceVertex - complex_.nodeCount()] != 0;
    addTetrahedron({ table_.vertex(0), faceVertex, table_.vertex(a), table_.vertex(b) }, { 0, f, a, b },
      atOutside ? std::optional(outside) : std::nullopt, patch);
  });
}
}
