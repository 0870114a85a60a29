#include "TwoHalves.h"

#include "vtkStrataTetrahedra.h"

#include <gtest/gtest.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkShortArray.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <vector>

using namespace strata::test;

namespace
{
constexpr int cells = 4;
using Names = std::vector<std::string>;

/// Half of the unit cube, from `begin` on along x; in each cell the density is 1 + y in the left half, 10 - z in the
/// right one.
vtkSmartPointer<vtkImageData> half(double begin)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(cells / 2 + 1, cells + 1, cells + 1);
  image->SetSpacing(1.0 / cells, 1.0 / cells, 1.0 / cells);
  image->SetOrigin(begin, 0.0, 0.0);
  vtkNew<vtkFloatArray> density;
  density->SetName("density");
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    double b[6];
    image->GetCellBounds(cell, b);
    density->InsertNextValue(static_cast<float>(begin < 0.5 ? 1.0 + (b[2] + b[3]) / 2.0 : 10.0 - (b[4] + b[5]) / 2.0));
  }
  image->GetCellData()->AddArray(density);
  return image;
}

template<typename Array>
void addIds(vtkDataSet* data, const char* name, int left, int right)
{
  vtkNew<Array> ids;
  ids->SetName(name);
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    double b[6];
    data->GetCellBounds(cell, b);
    ids->InsertNextValue(b[0] + b[1] < 1.0 ? left : right);
  }
  data->GetCellData()->AddArray(ids);
}

vtkSmartPointer<vtkMultiBlockDataSet> twoBlocks(const char* left, const char* right)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, half(0.0));
  blocks->SetBlock(1, half(0.5));
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), left);
  blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), right);
  return blocks;
}

/// Names of the materials after a run, which must end without an error.
Names namesAfter(vtkStrataTetrahedra* filter, vtkDataObject* data)
{
  filter->SetInputDataObject(data);
  filter->SetInterfaceErrorBound(0.01);
  EXPECT_EQ(update(filter).error, "");
  Names result;
  auto* names =
    vtkStringArray::SafeDownCast(filter->GetOutputDataObject(0)->GetFieldData()->GetAbstractArray("material_names"));
  for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
  {
    result.push_back(names->GetValue(i));
  }
  return result;
}

/// Every vertex off the plane x = 1/2 lies in the material of its half.
void expectHalves(vtkStrataTetrahedra* filter)
{
  auto* mesh = vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0));
  vtkDataArray* material = mesh->GetPointData()->GetArray("material");
  ASSERT_GT(mesh->GetNumberOfCells(), 0);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double x = mesh->GetPoint(i)[0];
    if (std::abs(x - 0.5) > 0.01)
    {
      ASSERT_EQ(material->GetTuple1(i), x < 0.5 ? 0 : 1) << "at x = " << x;
    }
  }
}
}

TEST(MaterialsGiven, AsVolumeFractions)
{
  vtkNew<vtkStrataTetrahedra> filter;
  EXPECT_EQ(namesAfter(filter, twoHalves(cells)), Names({ "left", "right" }));
  expectHalves(filter);
}

TEST(MaterialsGiven, AsIdsOfCells)
{
  auto image = twoHalves(cells);
  addIds<vtkIntArray>(image, "region", 1, 2);
  vtkNew<vtkStrataTetrahedra> filter;
  filter->SetMaterialIdArray("region");
  EXPECT_EQ(namesAfter(filter, image), Names({ "Material 1", "Material 2" }));
  expectHalves(filter);
}

TEST(MaterialsGiven, AsLabelsAtThePointsOfAnImage)
{
  // The centers of the cells of the unit cube.
  vtkNew<vtkImageData> image;
  image->SetDimensions(cells, cells, cells);
  image->SetSpacing(1.0 / cells, 1.0 / cells, 1.0 / cells);
  image->SetOrigin(0.5 / cells, 0.5 / cells, 0.5 / cells);
  auto cellImage = twoHalves(cells);
  addIds<vtkShortArray>(cellImage, "tissue", 1, 2);
  image->GetPointData()->ShallowCopy(cellImage->GetCellData());
  vtkNew<vtkStrataTetrahedra> filter;
  filter->SetMaterialIdArray("tissue");
  EXPECT_EQ(namesAfter(filter, image), Names({ "Material 1", "Material 2" }));
  expectHalves(filter);
  double bounds[6];
  vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0))->GetBounds(bounds);
  EXPECT_NEAR(bounds[0], 0.0, 1e-12);
  EXPECT_NEAR(bounds[5], 1.0, 1e-12);
}

TEST(MaterialsGiven, AsBlocks)
{
  vtkNew<vtkStrataTetrahedra> filter;
  filter->SetBlocksAsMaterials(true);
  EXPECT_EQ(namesAfter(filter, twoBlocks("copper", "lead")), Names({ "copper", "lead" }));
  expectHalves(filter);
}

TEST(MaterialsGiven, AsPartitionsOfANamedSet)
{
  // The left half in two parts, which have no names of their own.
  vtkNew<vtkPartitionedDataSetCollection> sets;
  auto left = half(0.0);
  auto lower = half(0.0);
  auto upper = half(0.0);
  int extent[6];
  left->GetExtent(extent);
  const int middle = extent[5] / 2;
  const int lowerExtent[6] = { extent[0], extent[1], extent[2], extent[3], extent[4], middle };
  const int upperExtent[6] = { extent[0], extent[1], extent[2], extent[3], middle, extent[5] };
  lower->Crop(lowerExtent);
  upper->Crop(upperExtent);
  sets->SetPartition(0, 0, lower);
  sets->SetPartition(0, 1, upper);
  sets->SetPartition(1, 0, half(0.5));
  sets->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "copper");
  vtkNew<vtkStrataTetrahedra> filter;
  filter->SetBlocksAsMaterials(true);
  EXPECT_EQ(namesAfter(filter, sets), Names({ "copper", "Block 3" }));
  expectHalves(filter);
}

TEST(MaterialsGiven, AsNumbersOfBlocksThatHaveNames)
{
  auto blocks = twoBlocks("copper", "lead");
  addIds<vtkIntArray>(vtkDataSet::SafeDownCast(blocks->GetBlock(0)), "ObjectId", 1, 2);
  addIds<vtkIntArray>(vtkDataSet::SafeDownCast(blocks->GetBlock(1)), "ObjectId", 1, 2);
  vtkNew<vtkStrataTetrahedra> filter;
  filter->SetMaterialIdArray("ObjectId");
  EXPECT_EQ(namesAfter(filter, blocks), Names({ "copper", "lead" }));
  expectHalves(filter);
}

TEST(MaterialsGiven, NumbersThatSeveralBlocksShareKeepTheirNames)
{
  auto blocks = twoBlocks("copper", "lead");
  addIds<vtkIntArray>(vtkDataSet::SafeDownCast(blocks->GetBlock(0)), "ObjectId", 3, 3);
  addIds<vtkIntArray>(vtkDataSet::SafeDownCast(blocks->GetBlock(1)), "ObjectId", 3, 3);
  vtkNew<vtkStrataTetrahedra> filter;
  filter->SetMaterialIdArray("ObjectId");
  EXPECT_EQ(namesAfter(filter, blocks), Names({ "Material 1", "Material 2", "Material 3" }));
}

TEST(MaterialsGiven, NotAtAllIsOneMaterial)
{
  vtkNew<vtkStrataTetrahedra> filter;
  EXPECT_EQ(namesAfter(filter, half(0.0)), Names({ "material" }));
  EXPECT_GT(cellsOf(filter), 0);
}
