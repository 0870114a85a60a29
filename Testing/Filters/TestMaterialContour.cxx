#include "TwoHalves.h"

#include "vtkStrataMaterialContour.h"
#include "vtkStrataTetrahedra.h"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

using namespace strata::test;

namespace
{
/// Density is 1 + y on the left, where x < 1/2, and 10 - z on the right.
struct MaterialContour : testing::Test
{
  MaterialContour()
  {
    tetrahedra->SetInputData(twoHalves(8));
    tetrahedra->SetInterfaceErrorBound(0.05);
    tetrahedra->SetFieldErrorBound(1e-6);
    contour->SetInputConnection(tetrahedra->GetOutputPort());
  }

  vtkPolyData* output() { return vtkPolyData::SafeDownCast(contour->GetOutputDataObject(0)); }

  double area(int material)
  {
    double sum = 0.0;
    double normal[3];
    for (vtkIdType cell = 0; cell < output()->GetNumberOfCells(); ++cell)
    {
      if (output()->GetCellData()->GetArray("material")->GetTuple1(cell) == material)
      {
        vtkIdList* points = output()->GetCell(cell)->GetPointIds();
        sum += vtkPolygon::ComputeArea(output()->GetPoints(), points->GetNumberOfIds(), points->GetPointer(0), normal);
      }
    }
    return sum;
  }

  vtkNew<vtkStrataTetrahedra> tetrahedra;
  vtkNew<vtkStrataMaterialContour> contour;
};
}

TEST_F(MaterialContour, EachMaterialShowsItsOwnValuesUpToTheInterface)
{
  contour->SetIsosurface(0, 1.4);
  contour->SetIsosurface(1, 9.25);
  ASSERT_EQ(update(contour).error, "");
  EXPECT_NEAR(area(0), 0.5, 1e-4); // y = 0.4, x < 1/2
  EXPECT_NEAR(area(1), 0.5, 1e-4); // z = 0.75, x > 1/2
  for (vtkIdType i = 0; i < output()->GetNumberOfPoints(); ++i)
  {
    const double* p = output()->GetPoint(i);
    const double value = output()->GetPointData()->GetArray("density")->GetTuple1(i);
    if (value < 5.0)
    {
      EXPECT_NEAR(p[1], 0.4, 1e-4);
      EXPECT_LE(p[0], 0.5 + 1e-4);
    }
    else
    {
      EXPECT_NEAR(p[2], 0.75, 1e-4);
      EXPECT_GE(p[0], 0.5 - 1e-4);
    }
  }
}

TEST_F(MaterialContour, NothingIsDrawnForAValueThatOnlyTheJumpPasses)
{
  contour->SetIsosurface(0, 5.0);
  ASSERT_EQ(update(contour).error, "");
  EXPECT_EQ(output()->GetNumberOfCells(), 0);
}

TEST_F(MaterialContour, MaterialsAndTheFieldCanBeChosen)
{
  contour->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "density");
  contour->SetIsosurface(0, 1.4);
  contour->SetIsosurface(1, 9.25);
  contour->AddMaterial("right");
  ASSERT_EQ(update(contour).error, "");
  EXPECT_EQ(area(0), 0.0);
  EXPECT_NEAR(area(1), 0.5, 1e-4);
  contour->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "density_left");
  EXPECT_REFUSED(contour, "density_left", "'density'");
}

TEST_F(MaterialContour, WithoutAValueItSaysWhatToDo)
{
  EXPECT_REFUSED(contour, "Isosurfaces");
}

TEST_F(MaterialContour, ASavedRepresentationGivesTheSame)
{
  contour->SetIsosurface(0, 1.4);
  ASSERT_EQ(update(contour).error, "");
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputConnection(tetrahedra->GetOutputPort());
  writer->SetDataModeToBinary();
  writer->WriteToOutputStringOn();
  writer->Write();
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(writer->GetOutputString());
  const vtkIdType points = output()->GetNumberOfPoints();
  const vtkIdType cells = output()->GetNumberOfCells();
  const double before = area(0);
  contour->SetInputConnection(reader->GetOutputPort());
  ASSERT_EQ(update(contour).error, "");
  EXPECT_EQ(output()->GetNumberOfPoints(), points);
  EXPECT_EQ(output()->GetNumberOfCells(), cells);
  EXPECT_EQ(area(0), before);
}

TEST_F(MaterialContour, TheLegendNamesTheMaterials)
{
  contour->SetIsosurface(0, 1.4);
  ASSERT_EQ(update(contour).error, "");
  EXPECT_EQ(contour->GetLegend(), "0\tleft\n1\tright\n");
  EXPECT_EQ(tetrahedra->GetMaterialNames(), "left, right");
}
