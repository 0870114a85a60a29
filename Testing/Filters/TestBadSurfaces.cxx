#include "TwoHalves.h"

#include "vtkStrataTetrahedra.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataSet.h>
#include <vtkInformation.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <vector>

using namespace strata::test;

namespace
{
enum class Shape
{
  Triangles,
  Quad,
  Strip,
  Lines
};

/// The square x = 1/2 of the unit cube, by its corners (y, z); counter-clockwise: the normal is +x.
vtkSmartPointer<vtkPolyData> square(Shape shape, bool flipped = false)
{
  vtkNew<vtkPoints> points;
  for (const auto& [y, z] : { std::pair(0.0, 0.0), std::pair(1.0, 0.0), std::pair(1.0, 1.0), std::pair(0.0, 1.0) })
  {
    points->InsertNextPoint(0.5, y, z);
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  std::vector<std::vector<vtkIdType>> lists = { { 0, 1, 2 }, { 0, 2, 3 } };
  if (shape == Shape::Quad || shape == Shape::Lines)
  {
    lists = { { 0, 1, 2, 3 } };
  }
  if (shape == Shape::Strip)
  {
    lists = { { 0, 1, 3, 2 } };
  }
  for (auto& list : lists)
  {
    if (flipped)
    {
      std::reverse(list.begin(), list.end());
    }
    cells->InsertNextCell(static_cast<vtkIdType>(list.size()), list.data());
  }
  shape == Shape::Strip   ? surface->SetStrips(cells)
  : shape == Shape::Lines ? surface->SetLines(cells)
                          : surface->SetPolys(cells);
  return surface;
}

vtkSmartPointer<vtkPartitionedDataSetCollection> named(vtkPolyData* surface, const char* name)
{
  auto collection = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  collection->SetPartition(0, 0, surface);
  collection->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), name);
  return collection;
}

vtkSmartPointer<vtkStrataTetrahedra> filterWith(vtkDataObject* surfaces)
{
  auto filter = vtkSmartPointer<vtkStrataTetrahedra>::New();
  filter->SetInputData(twoHalves(4));
  filter->SetInputDataObject(1, surfaces);
  filter->SetInterfaceErrorBound(0.05);
  return filter;
}

/// The share of the vertices with x < 1/2 that lie in material 0 (left).
double shareOfLeft(vtkStrataTetrahedra* filter)
{
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
  vtkDataArray* material = mesh->GetPointData()->GetArray("material");
  int all = 0;
  int right = 0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const bool isLeft = mesh->GetPoint(i)[0] < 0.5 - 1e-6;
    all += isLeft;
    right += isLeft && material->GetTuple1(i) == 0.0;
  }
  return all > 0 ? static_cast<double>(right) / all : -1.0;
}
}

TEST(Surfaces, TrianglesQuadsAndStripsAreTaken)
{
  for (const Shape shape : { Shape::Triangles, Shape::Quad, Shape::Strip })
  {
    auto filter = filterWith(named(square(shape), "right|left"));
    EXPECT_EQ(update(filter).error, "");
    EXPECT_EQ(shareOfLeft(filter), 1.0);
  }
}

TEST(Surfaces, NormalsTurnTrianglesThatAreWoundTheOtherWay)
{
  auto surface = square(Shape::Triangles, true);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 4; ++i)
  {
    normals->InsertNextTuple3(1.0, 0.0, 0.0);
  }
  surface->GetPointData()->SetNormals(normals);
  auto filter = filterWith(named(surface, "right|left"));
  EXPECT_EQ(update(filter).error, "");
  EXPECT_EQ(shareOfLeft(filter), 1.0);
}

TEST(Surfaces, WithoutNormalsTheWindingCounts)
{
  auto filter = filterWith(named(square(Shape::Triangles, true), "left|right"));
  EXPECT_EQ(update(filter).error, "");
  EXPECT_EQ(shareOfLeft(filter), 1.0);
}

TEST(Surfaces, LinesAreRefused)
{
  EXPECT_REFUSED(filterWith(named(square(Shape::Lines), "right|left")), "right|left", "lines");
}

TEST(Surfaces, TheMaterialsMustBeKnown)
{
  EXPECT_REFUSED(filterWith(named(square(Shape::Triangles), "right|lead")), "lead", "'left', 'right'");
  EXPECT_REFUSED(filterWith(square(Shape::Triangles)), "positive_material");
  EXPECT_REFUSED(filterWith(named(square(Shape::Triangles), "left|left")), "from itself");
}

TEST(Surfaces, PointsOutOfRangeAreNamed)
{
  auto surface = square(Shape::Triangles);
  vtkNew<vtkCellArray> cells;
  const vtkIdType corners[3] = { 0, 1, 77 };
  cells->InsertNextCell(3, corners);
  surface->SetPolys(cells);
  EXPECT_REFUSED(filterWith(named(surface, "right|left")), "point 77");
}

TEST(Surfaces, TrianglesThatRepeatOthersAreLeftOut)
{
  auto surface = square(Shape::Triangles);
  const vtkIdType again[3] = { 1, 2, 0 };
  surface->GetPolys()->InsertNextCell(3, again);
  auto filter = filterWith(named(surface, "right|left"));
  const Outcome outcome = update(filter);
  EXPECT_EQ(outcome.error, "");
  EXPECT_NE(outcome.warning.find("1 triangles of the interfaces repeat"), std::string::npos) << outcome.warning;
  EXPECT_EQ(shareOfLeft(filter), 1.0);
}

TEST(Surfaces, ASheetThatEndsBeforeTheWallsIsContinuedWithAWarningOfHowFar)
{
  auto surface = square(Shape::Triangles);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    surface->GetPoints()->SetPoint(i, p[0], 0.05 + 0.9 * p[1], 0.05 + 0.9 * p[2]);
  }
  auto filter = filterWith(named(surface, "right|left"));
  const Outcome outcome = update(filter);
  EXPECT_EQ(outcome.error, "");
  EXPECT_NE(outcome.warning.find("open along 4 edges of length 3.6"), std::string::npos) << outcome.warning;
  EXPECT_NE(outcome.warning.find("up to 0.05 from its edges"), std::string::npos) << outcome.warning;
  EXPECT_EQ(shareOfLeft(filter), 1.0);
}
