#include "Extract/UsableCells.h"

#include "Extract/ForEach.h"
#include "Extract/NativeFaces.h"

#include <algorithm>
#include <utility>

namespace strata
{
namespace
{
enum class CellState : std::uint8_t
{
  Regular,
  Collapsed,
  Unusable
};

bool repeatsCorner(const Index* first, const Index* last)
{
  for (const Index* corner = first; corner != last; ++corner)
  {
    if (std::find(first, corner, *corner) != corner)
    {
      return true;
    }
  }
  return false;
}

/// Removes repetitions and spikes (a, b, a) from a loop of corners; what is left may have fewer than three.
void collapse(std::vector<Index>& loop)
{
  for (std::size_t i = 0; i < loop.size() && loop.size() > 1;)
  {
    const std::size_t next = (i + 1) % loop.size();
    const std::size_t afterNext = (i + 2) % loop.size();
    if (loop[i] == loop[next] || loop[i] == loop[afterNext])
    {
      loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(next));
      i = 0;
    }
    else
    {
      ++i;
    }
  }
}

/// The faces without repeated corners; those with the same corners cancel in pairs.
CellFaces collapsedFaces(const CellFaces& faces)
{
  std::vector<std::pair<std::vector<Index>, std::vector<Index>>> kept; // sorted corners, corners
  for (std::int32_t f = 0; f < faces.count(); ++f)
  {
    std::vector<Index> loop(faces.corners.begin() + faces.start[f], faces.corners.begin() + faces.start[f + 1]);
    collapse(loop);
    std::vector<Index> sorted = loop;
    std::sort(sorted.begin(), sorted.end());
    const auto same = std::find_if(kept.begin(), kept.end(), [&](const auto& other) { return other.first == sorted; });
    if (same != kept.end())
    {
      kept.erase(same);
    }
    else if (loop.size() >= 3)
    {
      kept.emplace_back(std::move(sorted), std::move(loop));
    }
  }
  CellFaces result;
  for (const auto& [sorted, loop] : kept)
  {
    result.corners.insert(result.corners.end(), loop.begin(), loop.end());
    result.start.push_back(static_cast<std::int32_t>(result.corners.size()));
    result.neighbours.push_back(-1);
  }
  return result;
}

/// Whether every edge belongs to two faces, and no face has a corner twice.
bool isClosed(const CellFaces& faces)
{
  std::vector<std::pair<Index, Index>> edges;
  for (std::int32_t f = 0; f < faces.count(); ++f)
  {
    const Index* first = faces.corners.data() + faces.start[f];
    const Index* last = faces.corners.data() + faces.start[f + 1];
    if (repeatsCorner(first, last))
    {
      return false;
    }
    for (const Index* a = first; a != last; ++a)
    {
      const Index* b = a + 1 == last ? first : a + 1;
      edges.emplace_back(std::min(*a, *b), std::max(*a, *b));
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size(); i += 2)
  {
    if (i + 1 == edges.size() || edges[i] != edges[i + 1] || (i + 2 < edges.size() && edges[i] == edges[i + 2]))
    {
      return false;
    }
  }
  return faces.count() >= 4;
}

bool repeatsCorner(const UnstructuredGrid& grid, Index cell, const CellFaces& faces)
{
  if (grid.shapes[cell] != CellShape::Polyhedron)
  {
    return repeatsCorner(
      grid.corners.data() + grid.cornerOffsets[cell], grid.corners.data() + grid.cornerOffsets[cell + 1]);
  }
  for (std::int32_t f = 0; f < faces.count(); ++f)
  {
    if (repeatsCorner(faces.corners.data() + faces.start[f], faces.corners.data() + faces.start[f + 1]))
    {
      return true;
    }
  }
  return false;
}

CellState stateOf(const UnstructuredGrid& grid, Index cell)
{
  const bool polyhedron = grid.shapes[cell] == CellShape::Polyhedron;
  CellFaces faces;
  if (polyhedron)
  {
    addNativeFaces(grid, cell, faces);
  }
  if (!repeatsCorner(grid, cell, faces))
  {
    return !polyhedron || isClosed(faces) ? CellState::Regular : CellState::Unusable;
  }
  faces.clear();
  addNativeFaces(grid, cell, faces);
  return isClosed(collapsedFaces(faces)) ? CellState::Collapsed : CellState::Unusable;
}
}

UsableCells findUsableCells(const UnstructuredGrid& grid, Progress& progress)
{
  UsableCells result;
  result.hidden = grid.hidden;
  std::vector<CellState> states(static_cast<std::size_t>(grid.cellCount()), CellState::Regular);
  forEach(grid.cellCount(), progress, [&](Index cell) {
    states[cell] = grid.hidden.empty() || grid.hidden[cell] == 0 ? stateOf(grid, cell) : CellState::Regular;
  });
  Index unusable = 0;
  Index first = 0;
  for (Index cell = 0; cell < grid.cellCount(); ++cell)
  {
    if (states[cell] == CellState::Collapsed)
    {
      CellFaces faces;
      addNativeFaces(grid, cell, faces);
      faces = collapsedFaces(faces);
      result.replaced.set(cell, faces.corners, faces);
    }
    else if (states[cell] == CellState::Unusable)
    {
      first = unusable++ == 0 ? cell : first;
      result.hidden.resize(states.size(), 0);
      result.hidden[cell] = 1;
    }
  }
  if (unusable > 0)
  {
    result.warnings.push_back("Cell " + std::to_string(first) +
                              (unusable > 1 ? " and " + std::to_string(unusable - 1) + " others are no closed polyhedra"
                                            : " is no closed polyhedron") +
                              ": left out");
  }
  return result;
}
}
