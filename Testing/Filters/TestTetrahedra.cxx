#include "TwoHalves.h"

#include "vtkStrataTetrahedra.h"

#include <gtest/gtest.h>
#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkTetra.h>
#include <vtkTriQuadraticHexahedron.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>

using namespace strata::test;

namespace
{
struct Tetrahedra : testing::Test
{
  Tetrahedra()
  {
    filter->SetInputData(input);
    filter->SetInterfaceErrorBound(0.05);
    filter->SetFieldErrorBound(0.05);
  }
  vtkUnstructuredGrid* mesh() { return vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0)); }

  vtkSmartPointer<vtkImageData> input = twoHalves(8);
  vtkNew<vtkStrataTetrahedra> filter;
};

/// A unit cube of degree 2 whose top bulges by `height` in the middle of x, with 4 x (1 - x) at its points.
vtkSmartPointer<vtkUnstructuredGrid> bulgingCell(double height)
{
  vtkNew<vtkTriQuadraticHexahedron> shape;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> density;
  density->SetName("density");
  std::vector<vtkIdType> nodes;
  for (int node = 0; node < shape->GetNumberOfPoints(); ++node)
  {
    const double* p = shape->GetParametricCoords() + 3 * node;
    const double bulge = 4.0 * p[0] * (1.0 - p[0]);
    nodes.push_back(points->InsertNextPoint(p[0], p[1], p[2] * (1.0 + height * bulge)));
    density->InsertNextValue(bulge);
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->InsertNextCell(VTK_TRIQUADRATIC_HEXAHEDRON, shape->GetNumberOfPoints(), nodes.data());
  grid->GetPointData()->AddArray(density);
  vtkNew<vtkIntArray> material;
  material->SetName("material");
  material->InsertNextValue(1);
  grid->GetCellData()->AddArray(material);
  return grid;
}

void abortFilter(vtkObject* caller, unsigned long, void*, void*)
{
  static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
}
}

TEST_F(Tetrahedra, TheOutputDescribesItself)
{
  ASSERT_EQ(update(filter).error, "");
  for (const char* name : { "material", "density", "distance_left", "distance_right", "ghost_left", "ghost_right",
         "density_left", "density_right" })
  {
    EXPECT_TRUE(mesh()->GetPointData()->HasArray(name)) << name;
  }
  for (const char* name : { "material", "level", "interface_error", "field_error_density" })
  {
    EXPECT_TRUE(mesh()->GetCellData()->HasArray(name)) << name;
  }
  for (const char* name : { "material_names", "material_has_fields", "field_names", "achieved_interface_error",
         "achieved_field_error_density", "bound_met", "stopped_by" })
  {
    EXPECT_TRUE(mesh()->GetFieldData()->HasArray(name)) << name;
  }
  EXPECT_EQ(mesh()->GetPointData()->GetArray("ghost_left")->GetDataType(), VTK_UNSIGNED_CHAR);
  EXPECT_TRUE(filter->GetBoundMet());
  EXPECT_LE(filter->GetAchievedInterfaceError(), 0.05);
}

TEST_F(Tetrahedra, TheyFillTheBox)
{
  ASSERT_EQ(update(filter).error, "");
  double volume = 0.0;
  for (vtkIdType cell = 0; cell < mesh()->GetNumberOfCells(); ++cell)
  {
    double p[4][3];
    for (int i = 0; i < 4; ++i)
    {
      mesh()->GetPoint(mesh()->GetCell(cell)->GetPointId(i), p[i]);
    }
    const double part = vtkTetra::ComputeVolume(p[0], p[1], p[2], p[3]);
    EXPECT_GT(part, 0.0);
    volume += part;
  }
  EXPECT_NEAR(volume, 1.0, 1e-12);
}

TEST_F(Tetrahedra, EachMaterialKeepsItsOwnField)
{
  ASSERT_EQ(update(filter).error, "");
  vtkDataArray* material = mesh()->GetPointData()->GetArray("material");
  vtkDataArray* density = mesh()->GetPointData()->GetArray("density");
  for (vtkIdType i = 0; i < mesh()->GetNumberOfPoints(); ++i)
  {
    const double* p = mesh()->GetPoint(i);
    const double expected = material->GetTuple1(i) == 0.0 ? 1.0 + p[1] : 10.0 - p[2];
    EXPECT_NEAR(density->GetTuple1(i), expected, 1e-4);
  }
}

TEST_F(Tetrahedra, CertifiedErrorsHoldAtEveryPointOfTheInterface)
{
  // The materials meet in a plane, which a representation within 0.05 may miss by no more than that.
  filter->SetNativeElements(1);
  ASSERT_EQ(update(filter).error, "");
  EXPECT_TRUE(filter->GetBoundMet());
  EXPECT_EQ(filter->GetStoppedBy(), std::string("bounds met"));
  EXPECT_LE(filter->GetAchievedInterfaceError(), 0.05);
  EXPECT_EQ(filter->GetNumberOfBuilds(), 1);
  vtkDataArray* errors = mesh()->GetCellData()->GetArray("interface_error");
  EXPECT_EQ(static_cast<float>(filter->GetAchievedInterfaceError()), static_cast<float>(errors->GetRange()[1]));
  filter->SetNativeElements(0);
  ASSERT_EQ(update(filter).error, "");
  EXPECT_EQ(filter->GetNumberOfBuilds(), 2);
}

TEST_F(Tetrahedra, AChangeOfBoundsKeepsTheHierarchy)
{
  ASSERT_EQ(update(filter).error, "");
  const vtkIdType fine = cellsOf(filter);
  filter->SetInterfaceErrorBound(0.4);
  ASSERT_EQ(update(filter).error, "");
  EXPECT_LE(cellsOf(filter), fine);
  filter->SetInterfaceErrorBound(0.05);
  ASSERT_EQ(update(filter).error, "");
  EXPECT_EQ(cellsOf(filter), fine);
  EXPECT_EQ(filter->GetNumberOfBuilds(), 1);
}

TEST_F(Tetrahedra, AChangeOfInputOrBuildOptionsBuildsAnew)
{
  ASSERT_EQ(update(filter).error, "");
  cellArray(input, "density_left")->SetValue(0, 3.0f);
  cellArray(input, "density_left")->Modified();
  input->Modified();
  ASSERT_EQ(update(filter).error, "");
  EXPECT_EQ(filter->GetNumberOfBuilds(), 2);
  filter->SetGhostMethod(vtkStrataTetrahedra::CONSTANT);
  ASSERT_EQ(update(filter).error, "");
  EXPECT_EQ(filter->GetNumberOfBuilds(), 3);
}

TEST_F(Tetrahedra, ALimitOfCellsIsKeptAndReported)
{
  filter->SetInterfaceErrorBound(0.001);
  filter->SetFieldErrorBound(1e-4);
  filter->LimitCellsOn();
  filter->SetMaximumNumberOfCells(100);
  ASSERT_EQ(update(filter).error, "");
  EXPECT_LE(cellsOf(filter), 100);
}

TEST_F(Tetrahedra, PassArraysLeavesArraysOut)
{
  filter->SetPassArrays(vtkStrataTetrahedra::WITHOUT_GHOSTS);
  ASSERT_EQ(update(filter).error, "");
  EXPECT_FALSE(mesh()->GetPointData()->HasArray("ghost_left"));
  EXPECT_TRUE(mesh()->GetPointData()->HasArray("distance_left"));
  filter->SetPassArrays(vtkStrataTetrahedra::COMPOSITE_ONLY);
  ASSERT_EQ(update(filter).error, "");
  EXPECT_FALSE(mesh()->GetPointData()->HasArray("distance_left"));
  EXPECT_TRUE(mesh()->GetPointData()->HasArray("density"));
}

TEST_F(Tetrahedra, AnAbortGivesAnEmptyOutputAndNoError)
{
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(abortFilter);
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, abort);
  EXPECT_EQ(update(filter).error, "");
  EXPECT_EQ(cellsOf(filter), 0);
  filter->RemoveObserver(tag);
  filter->Modified();
  EXPECT_EQ(update(filter).error, "");
  EXPECT_GT(cellsOf(filter), 0);
}

TEST_F(Tetrahedra, TheOutputSaysWhatCurvedCellsAddToItsErrors)
{
  const auto number = [&](const char* name) {
    auto* array = vtkDoubleArray::SafeDownCast(mesh()->GetFieldData()->GetAbstractArray(name));
    return array ? array->GetValue(0) : -1.0;
  };
  ASSERT_EQ(update(filter).error, "");
  EXPECT_EQ(-1.0, number("not_in_interface_error"));
  filter->SetInputData(bulgingCell(0.2));
  ASSERT_EQ(update(filter).error, "");
  // Half a parabola's chord stays a quarter of its height below it; the bound may be a tenth larger.
  EXPECT_GE(number("not_in_interface_error"), 0.25 * 0.2);
  EXPECT_LE(number("not_in_interface_error"), 1.1 * 0.25 * 0.2 + 1e-12);
  EXPECT_GE(number("not_in_field_error_density"), 0.25 - 1e-12);
  EXPECT_LE(number("not_in_field_error_density"), 1.1 * 0.25 + 1e-12);
}
