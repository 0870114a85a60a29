#include "vtkStrataTetrahedra.h"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <sys/resource.h>

#include <cmath>
#include <cstdlib>
#include <ctime>

namespace
{
/// Blocks along each edge of the cube: 100 for a million of them, of which VTK's own objects take 5 GiB.
int blocksAlongEdge()
{
  const char* wanted = std::getenv("STRATA_BLOCKS_ALONG_EDGE");
  return wanted ? std::atoi(wanted) : 40;
}

double peakMebibytes()
{
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_maxrss) / 1024.0;
}

double processorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

template<typename Array>
vtkSmartPointer<Array> oneValue(const char* name, double value)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->InsertNextTuple1(value);
  return array;
}

/// edge^3 blocks of one cell each: material 1 of density 1 in the lower half, material 2 of density 2 in the upper one.
vtkSmartPointer<vtkMultiBlockDataSet> tinyBlocks(int edge)
{
  // Blocks of one material share their arrays: memory is for what the filter takes, not for VTK's objects.
  vtkSmartPointer<vtkIntArray> ids[2];
  vtkSmartPointer<vtkFloatArray> densities[2];
  for (int half = 0; half < 2; ++half)
  {
    ids[half] = oneValue<vtkIntArray>("material", half + 1);
    densities[half] = oneValue<vtkFloatArray>("density", half + 1);
  }
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetNumberOfBlocks(edge * edge * edge);
  for (int number = 0; number < edge * edge * edge; ++number)
  {
    const int layer = number / (edge * edge);
    const int half = 2 * layer < edge ? 0 : 1;
    vtkNew<vtkImageData> block;
    block->SetDimensions(2, 2, 2);
    block->SetOrigin(number % edge, number / edge % edge, layer);
    block->GetCellData()->AddArray(ids[half]);
    block->GetCellData()->AddArray(densities[half]);
    blocks->SetBlock(static_cast<unsigned int>(number), block);
  }
  return blocks;
}
}

TEST(ManyBlocks, TinyBlocksByTheTenThousandsAreRefinedAsOneGrid)
{
  vtkNew<vtkStrataTetrahedra> filter;
  const int edge = blocksAlongEdge();
  filter->SetInputData(tinyBlocks(edge));
  filter->AddFieldArray("density");
  filter->SetInterfaceErrorBound(0.1);
  const double mebibytes = peakMebibytes();
  const double seconds = processorSeconds();
  filter->Update();
  // Told, not tested: a busy machine decides.
  RecordProperty("filter_processor_milliseconds", static_cast<int>(1000.0 * (processorSeconds() - seconds)));
  RecordProperty("filter_mebibytes", static_cast<int>(peakMebibytes() - mebibytes));
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_GT(mesh->GetNumberOfCells(), 0);
  EXPECT_TRUE(filter->GetBoundMet());
  auto* names = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("material_names"));
  ASSERT_EQ(names->GetNumberOfValues(), 2);
  EXPECT_EQ(names->GetValue(0), "Material 1");
  EXPECT_EQ(names->GetValue(1), "Material 2");
  vtkDataArray* materials = mesh->GetPointData()->GetArray("material");
  vtkDataArray* densities = mesh->GetPointData()->GetArray("density");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double height = mesh->GetPoint(i)[2] - 0.5 * edge;
    if (std::abs(height) > 0.1)
    {
      EXPECT_EQ(materials->GetTuple1(i), height < 0.0 ? 0.0 : 1.0);
      EXPECT_NEAR(densities->GetTuple1(i), height < 0.0 ? 1.0 : 2.0, 1e-6);
    }
  }
}
