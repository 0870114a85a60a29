#include "Pieces/Pieces.h"

#include "Model/CellDistances.h"
#include "Pieces/CellPieces.h"
#include "Pieces/PiecePoints.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace strata
{
namespace
{
using Range = tbb::blocked_range<Index>;
constexpr Index grain = 4096;

MaterialSet known(MaterialSet materials, const Representation& representation)
{
  MaterialSet result;
  for (const MaterialId m : materials)
  {
    if (m.value < static_cast<Index>(representation.materials.size()))
    {
      result.insert(m);
    }
  }
  return result;
}

void writePieces(
  const Representation& representation, const CellPieces& cells, const PiecePoints& points, Pieces& result)
{
  const Index count = static_cast<Index>(cells.pieces.size());
  result.tetrahedra = Buffer<std::int64_t>(4 * count);
  result.material = Buffer<std::int32_t>(count);
  result.cell = Buffer<std::int64_t>(count);
  tbb::parallel_for(Range(0, count, grain), [&](const Range& range) {
    for (Index piece = range.begin(); piece != range.end(); ++piece)
    {
      result.material[piece] = cells.pieces[piece].material;
      result.cell[piece] = cells.pieces[piece].cell;
      for (int corner = 0; corner < 4; ++corner)
      {
        result.tetrahedra[4 * piece + corner] = points.number(cells, representation, piece, corner);
      }
    }
  });
}

void writePoints(const Representation& representation, const PiecePoints& points, Pieces& result)
{
  const Index count = points.count();
  result.points = Buffer<double>(3 * count);
  for (const Field& field : representation.fields)
  {
    result.values.emplace_back(field.components * count);
  }
  for (std::size_t m = 0; m < representation.materials.size(); ++m)
  {
    result.distances.emplace_back(count);
  }
  tbb::parallel_for(Range(0, count, grain), [&](const Range& range) {
    for (Index point = range.begin(); point != range.end(); ++point)
    {
      const PointUse use = points.use(point);
      interpolatePosition(representation, use.point, &result.points[3 * point]);
      for (std::size_t field = 0; field < representation.fields.size(); ++field)
      {
        const int components = representation.fields[field].components;
        const float* values = representation.values[field][static_cast<std::size_t>(use.owner)];
        interpolateField(values, components, use.point, &result.values[field][components * point]);
      }
      for (std::size_t m = 0; m < representation.materials.size(); ++m)
      {
        interpolateField(representation.distances[m], 1, use.point, &result.distances[m][point]);
      }
    }
  });
}
}

Pieces cutPieces(const Representation& representation, MaterialSet materials, Progress& progress)
{
  const MaterialSet chosen = known(materials, representation);
  const CellPieces cells = cutCells(representation, chosen, progress);
  progress.update(0.6);
  const PiecePoints points(representation, cells, chosen);
  progress.check();
  Pieces result;
  writePieces(representation, cells, points, result);
  writePoints(representation, points, result);
  progress.update(1.0);
  return result;
}
}
