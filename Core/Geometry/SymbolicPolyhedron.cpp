#include "Geometry/SymbolicPolyhedron.h"

#include <algorithm>
#include <cassert>

namespace strata
{
void SymbolicPolyhedron::reset()
{
  vertices_ = { { 1, 0 }, { 2, 0 }, { 4, 0 }, { 8, 0 } };
  faces_ = { { -1, 0, 3 }, { -2, 3, 6 }, { -3, 6, 9 }, { -4, 9, 12 } };
  loops_ = { 1, 2, 3, 0, 3, 2, 0, 1, 3, 0, 2, 1 };
}

void SymbolicPolyhedron::clip(int function, const std::vector<int>& signs)
{
  if (std::find(signs.begin(), signs.end(), -1) == signs.end())
  {
    return;
  }
  clippedVertices_.clear();
  clippedFaces_.clear();
  clippedLoops_.clear();
  crossings_.clear();
  kept_.assign(vertices_.size(), -1);
  for (std::size_t vertex = 0; vertex < vertices_.size(); ++vertex)
  {
    if (signs[vertex] > 0)
    {
      kept_[vertex] = static_cast<int>(clippedVertices_.size());
      clippedVertices_.push_back(vertices_[vertex]);
    }
  }
  for (const Face& face : faces_)
  {
    clipFace(face, function, signs);
  }
  addNewFace(function);
  vertices_.swap(clippedVertices_);
  faces_.swap(clippedFaces_);
  loops_.swap(clippedLoops_);
}

int SymbolicPolyhedron::crossing(int a, int b, int function)
{
  const int from = std::min(a, b);
  const int to = std::max(a, b);
  for (std::size_t i = 0; i < crossings_.size(); ++i)
  {
    if (crossings_[i].from == from && crossings_[i].to == to)
    {
      return static_cast<int>(i);
    }
  }
  crossings_.push_back({ from, to, static_cast<int>(clippedVertices_.size()), 0 });
  clippedVertices_.push_back(SymbolicVertex::between(vertices_[from], vertices_[to], function));
  return static_cast<int>(crossings_.size()) - 1;
}

void SymbolicPolyhedron::clipFace(const Face& face, int function, const std::vector<int>& signs)
{
  const int begin = static_cast<int>(clippedLoops_.size());
  int exit = -1;
  int entry = -1;
  for (int i = face.begin; i < face.end; ++i)
  {
    const int here = loops_[i];
    const int next = loops_[i + 1 < face.end ? i + 1 : face.begin];
    if (signs[here] > 0)
    {
      clippedLoops_.push_back(kept_[here]);
    }
    if (signs[here] != signs[next])
    {
      const int found = crossing(here, next, function);
      clippedLoops_.push_back(crossings_[found].vertex);
      assert((signs[here] > 0 ? exit : entry) == -1);
      (signs[here] > 0 ? exit : entry) = found;
    }
  }
  assert((exit < 0) == (entry < 0));
  if (exit >= 0)
  {
    // This face goes from exit to entry; the new face, on the other side of that edge, comes back.
    crossings_[entry].next = exit;
  }
  const int end = static_cast<int>(clippedLoops_.size());
  if (end > begin)
  {
    clippedFaces_.push_back({ face.label, begin, end });
  }
}

void SymbolicPolyhedron::addNewFace(int function)
{
  if (crossings_.empty())
  {
    return;
  }
  const int begin = static_cast<int>(clippedLoops_.size());
  int current = 0;
  do
  {
    clippedLoops_.push_back(crossings_[current].vertex);
    current = crossings_[current].next;
  } while (current != 0);
  const int end = static_cast<int>(clippedLoops_.size());
  assert(end - begin == static_cast<int>(crossings_.size()));
  clippedFaces_.push_back({ function, begin, end });
}
}
