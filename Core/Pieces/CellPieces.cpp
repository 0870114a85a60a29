#include "Pieces/CellPieces.h"

#include "Geometry/RegionTetrahedra.h"
#include "Pieces/CellBlocks.h"

namespace strata
{
namespace
{
void addCutPieces(MaterialSet materials, Index cell, CutWorkspace& workspace, CellPieces& result)
{
  const TetrahedronCut& cut = workspace.cut;
  for (int material : cut.winners())
  {
    if (!materials.contains(MaterialId(material)))
    {
      continue;
    }
    fillRegion(cut, material, workspace.pieces);
    for (const std::array<int, 4>& piece : workspace.pieces)
    {
      result.pieces.push_back({ cell, material, static_cast<Index>(result.corners.size()) });
      for (int point : piece)
      {
        result.corners.push_back({ cut.points()[point], material });
      }
    }
  }
}

void addPieces(
  const Representation& representation, MaterialSet materials, Index cell, CutWorkspace& workspace, CellPieces& result)
{
  distancesOfCell(representation, cell, workspace.distances);
  int only = workspace.distances.front().function;
  if (workspace.distances.size() > 1)
  {
    workspace.cut.cut(
      verticesOfCell(representation, cell), workspace.distances.data(), static_cast<int>(workspace.distances.size()));
    if (workspace.cut.winners().size() > 1 || workspace.cut.points().size() > 4)
    {
      addCutPieces(materials, cell, workspace, result);
      return;
    }
    only = workspace.cut.winners().front();
  }
  if (materials.contains(MaterialId(only)))
  {
    result.pieces.push_back({ cell, only, -1 });
  }
}

CellPieces join(const std::vector<CellPieces>& blocks)
{
  std::vector<std::size_t> firstPiece(1, 0);
  std::vector<std::size_t> firstCorner(1, 0);
  for (const CellPieces& block : blocks)
  {
    firstPiece.push_back(firstPiece.back() + block.pieces.size());
    firstCorner.push_back(firstCorner.back() + block.corners.size());
  }
  CellPieces result;
  result.pieces.resize(firstPiece.back());
  result.corners.resize(firstCorner.back());
  tbb::parallel_for(std::size_t{ 0 }, blocks.size(), [&](std::size_t b) {
    const CellPieces& block = blocks[b];
    std::copy(block.corners.begin(), block.corners.end(), result.corners.data() + firstCorner[b]);
    for (std::size_t i = 0; i < block.pieces.size(); ++i)
    {
      CellPiece piece = block.pieces[i];
      piece.corners += piece.corners >= 0 ? static_cast<Index>(firstCorner[b]) : 0;
      result.pieces[firstPiece[b] + i] = piece;
    }
  });
  return result;
}
}

CellPieces cutCells(const Representation& representation, MaterialSet materials, Progress& progress)
{
  return join(forCellBlocks<CellPieces>(
    representation.cellCount, progress, [&](Index cell, CutWorkspace& workspace, CellPieces& block) {
      addPieces(representation, materials, cell, workspace, block);
    }));
}
}
