#include "Extract/CellTable.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace strata
{
void CellTable::gather(std::int32_t cell)
{
  listTetrahedra(cell);
  listMaterials();
  const std::size_t count = materials_.size();
  rows_.resize(vertices_.size() * count);
  for (std::size_t row = 0; row < vertices_.size(); ++row)
  {
    for (std::size_t m = 0; m < count; ++m)
    {
      rows_[row * count + m] = values_.at(vertices_[row], materials_[m]);
    }
  }
  leaveOutBeaten();
}

void CellTable::listTetrahedra(std::int32_t cell)
{
  vertices_.assign(1, complex_.cellVertex(cell));
  tetrahedra_.clear();
  const Vector& apex = complex_.positions[complex_.cellVertex(cell)];
  for (std::int32_t i = complex_.cellFaceStart[cell]; i < complex_.cellFaceStart[cell + 1]; ++i)
  {
    const CellComplex::OrientedFace oriented = complex_.cellFaces[i];
    const auto face = static_cast<int>(vertices_.size());
    vertices_.push_back(complex_.faceVertex(oriented.face));
    vertices_.insert(vertices_.end(), complex_.faceCorners.begin() + complex_.faceStart[oriented.face],
      complex_.faceCorners.begin() + complex_.faceStart[oriented.face + 1]);
    const int count = static_cast<int>(vertices_.size()) - face - 1;
    const Vector u = complex_.positions[vertices_[static_cast<std::size_t>(face)]] - apex;
    for (int k = 0; k < count; ++k)
    {
      int a = face + 1 + k;
      int b = face + 1 + (k + 1) % count;
      if (oriented.reversed)
      {
        std::swap(a, b);
      }
      const Vector v = complex_.positions[vertices_[static_cast<std::size_t>(a)]] - apex;
      const Vector w = complex_.positions[vertices_[static_cast<std::size_t>(b)]] - apex;
      tetrahedra_.push_back({ u.dot(v.cross(w)) / 6.0, face, a, b });
    }
  }
}

void CellTable::listMaterials()
{
  std::uint64_t present = 0;
  for (std::int32_t vertex : vertices_)
  {
    for (Index i = values_.start[vertex]; i < values_.start[vertex + 1]; ++i)
    {
      present |= std::uint64_t{ 1 } << values_.materials[i];
    }
  }
  materials_.clear();
  for (std::uint64_t rest = present; rest != 0; rest &= rest - 1)
  {
    materials_.push_back(static_cast<std::uint8_t>(__builtin_ctzll(rest)));
  }
}

void CellTable::leaveOutBeaten()
{
  const std::size_t count = materials_.size();
  const std::size_t rowCount = vertices_.size();
  std::uint64_t kept = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    bool beaten = false;
    for (std::size_t j = 0; j < count && !beaten; ++j)
    {
      beaten = true;
      for (std::size_t row = 0; row < rowCount && beaten; ++row)
      {
        beaten = rows_[row * count + i] < rows_[row * count + j];
      }
    }
    kept |= beaten ? 0 : std::uint64_t{ 1 } << i;
  }
  std::size_t next = 0;
  for (std::size_t row = 0; row < rowCount; ++row)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      if (((kept >> i) & 1u) != 0)
      {
        rows_[next++] = rows_[row * count + i];
      }
    }
  }
  rows_.resize(next);
  std::size_t position = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (((kept >> i) & 1u) != 0)
    {
      materials_[position++] = materials_[i];
    }
  }
  materials_.resize(position);
}
}
