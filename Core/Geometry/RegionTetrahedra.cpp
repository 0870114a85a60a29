#include "Geometry/RegionTetrahedra.h"

#include "Geometry/CutVolumes.h"

#include <algorithm>

namespace strata
{
namespace
{
/// Pieces below this fraction of the tetrahedron are rounding noise of flat ones.
constexpr double leastVolume = 1e-15;

bool lower(const TetrahedronCut& cut, int a, int b)
{
  return cut.points()[a].key < cut.points()[b].key;
}
}

int fanCentre(const TetrahedronCut& cut, const TetrahedronCut::Face& face)
{
  const int* loops = cut.loops().data();
  return static_cast<int>(
    std::min_element(loops + face.begin, loops + face.end, [&](int a, int b) { return lower(cut, a, b); }) - loops);
}

void fillRegion(const TetrahedronCut& cut, int function, std::vector<std::array<int, 4>>& result)
{
  result.clear();
  const std::vector<int>& loops = cut.loops();
  int apex = -1;
  for (const TetrahedronCut::Face& face : cut.faces())
  {
    if (face.function == function)
    {
      const int centre = loops[fanCentre(cut, face)];
      apex = apex < 0 || lower(cut, centre, apex) ? centre : apex;
    }
  }
  for (const TetrahedronCut::Face& face : cut.faces())
  {
    if (face.function != function)
    {
      continue;
    }
    const int centre = fanCentre(cut, face);
    if (loops[centre] == apex)
    {
      continue;
    }
    const int size = face.end - face.begin;
    const auto around = [&](int i) { return loops[face.begin + (centre - face.begin + i) % size]; };
    for (int i = 1; i + 1 < size; ++i)
    {
      const std::array<int, 4> piece{ apex, around(0), around(i), around(i + 1) };
      const std::vector<std::array<double, 4>>& at = cut.coordinates();
      const double volume = volumeFraction(at[piece[0]], at[piece[1]], at[piece[2]], at[piece[3]]);
      if ((cut.reversed() ? -volume : volume) > leastVolume)
      {
        result.push_back(piece);
      }
    }
  }
}
}
