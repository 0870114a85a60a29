#include "Measure/DirectedDistance.h"
#include "Measure/Measure.h"
#include "Model/Errors.h"

#include <cmath>
#include <string>

namespace strata
{
namespace
{
void requireFinite(const TriangleSoup& soup, const char* name)
{
  for (std::size_t i = 0; i < soup.triangles.size(); ++i)
  {
    for (const Vector& corner : soup.triangles[i])
    {
      if (!corner.allFinite())
      {
        throw InvalidInput("triangle " + std::to_string(i) + " of the " + name + " surface has a corner at (" +
                           std::to_string(corner.x()) + ", " + std::to_string(corner.y()) + ", " +
                           std::to_string(corner.z()) + ")");
      }
    }
  }
}
}

HausdorffDistance hausdorffDistance(
  const TriangleSoup& original, const TriangleSoup& represented, double tolerance, Progress& progress)
{
  if (!(tolerance > 0.0))
  {
    throw InvalidInput("the tolerance of a Hausdorff distance must be positive, not " + std::to_string(tolerance));
  }
  requireFinite(original, "original");
  requireFinite(represented, "represented");
  const TriangleTree originalTree(original.triangles);
  const TriangleTree representedTree(represented.triangles);
  HausdorffDistance result;
  result.originalToRepresented = directedDistance(original.triangles, representedTree, tolerance, progress);
  result.representedToOriginal = directedDistance(represented.triangles, originalTree, tolerance, progress);
  return result;
}
}
