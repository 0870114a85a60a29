#include "Conversion/HyperTreeGrids.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSetAttributes.h>
#include <vtkHyperTreeGrid.h>
#include <vtkHyperTreeGridNonOrientedGeometryCursor.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <array>

namespace strata::conversion
{
namespace
{
struct Leaf
{
  Index cell;
  std::array<double, 3> origin;
  std::array<double, 3> size;
};

void collect(vtkHyperTreeGridNonOrientedGeometryCursor* cursor, vtkUnsignedCharArray* ghosts, std::vector<Leaf>& leaves)
{
  if (cursor->IsMasked())
  {
    return;
  }
  if (!cursor->IsLeaf())
  {
    for (unsigned char child = 0; child < cursor->GetNumberOfChildren(); ++child)
    {
      cursor->ToChild(child);
      collect(cursor, ghosts, leaves);
      cursor->ToParent();
    }
    return;
  }
  const Index cell = cursor->GetGlobalNodeIndex();
  if (!ghosts || cell >= ghosts->GetNumberOfTuples() || ghosts->GetValue(cell) == 0)
  {
    const double* o = cursor->GetOrigin();
    const double* s = cursor->GetSize();
    leaves.push_back({ cell, { o[0], o[1], o[2] }, { s[0], s[1], s[2] } });
  }
}

std::vector<Leaf> leavesOf(vtkHyperTreeGrid* data)
{
  std::vector<Leaf> leaves;
  vtkNew<vtkHyperTreeGridNonOrientedGeometryCursor> cursor;
  vtkHyperTreeGrid::vtkHyperTreeGridIterator trees;
  data->InitializeTreeIterator(trees);
  vtkIdType tree = 0;
  while (trees.GetNextTree(tree))
  {
    cursor->Initialize(data, tree);
    collect(cursor, data->GetGhostCells(), leaves);
  }
  return leaves;
}
}

void addHyperTrees(UnstructuredBuilder& builder, vtkHyperTreeGrid* data, const std::string& blockName)
{
  if (data->GetDimension() != 3)
  {
    throw InvalidInput("The hyper tree grid" + blockName + " has " + std::to_string(data->GetDimension()) +
                       " dimensions; three are needed");
  }
  InputBlock block;
  block.name = blockName;
  block.data = data;
  block.cellData = data->GetCellData();
  block.pointData = vtkSmartPointer<vtkPointData>::New();
  block.cellCount = data->GetNumberOfCells();
  const std::vector<Leaf> leaves = leavesOf(data);
  std::vector<Vector> points;
  points.reserve(8 * leaves.size());
  for (const Leaf& leaf : leaves)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      points.emplace_back(leaf.origin[0] + (corner & 1 ? leaf.size[0] : 0.0),
        leaf.origin[1] + (corner & 2 ? leaf.size[1] : 0.0), leaf.origin[2] + (corner & 4 ? leaf.size[2] : 0.0));
    }
  }
  builder.beginBlock(std::move(block), std::move(points));
  builder.weldAtTheEnd();
  const CellKind& voxel = cellKind(VTK_VOXEL);
  Index first = 0;
  for (const Leaf& leaf : leaves)
  {
    const std::array<Index, 8> corners = { first, first + 1, first + 2, first + 3, first + 4, first + 5, first + 6,
      first + 7 };
    builder.add(voxel, leaf.cell, corners.data(), 8);
    first += 8;
  }
}
}
