/// Random small grids with random materials, fields and options, spoilt now and then: the refinement refuses them, or
/// what it puts out fills the box and keeps what it claims.
#include "Bytes.h"

#include "vtkStrataExtractMaterials.h"
#include "vtkStrataRepresentedInterfaces.h"
#include "vtkStrataTetrahedra.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

using strata::test::Bytes;

namespace
{
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

/// Up to 3 x 3 x 3 cells, their points moved a little.
vtkSmartPointer<vtkDataSet> randomGrid(Bytes& bytes)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(2 + bytes.below(3), 2 + bytes.below(3), 2 + bytes.below(3));
  image->SetSpacing(bytes.chance(50) ? 0.0 : 0.1 + bytes.unit(), 0.1 + bytes.unit(), 0.1 + bytes.unit());
  if (bytes.chance(2))
  {
    return image;
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const double shift = bytes.chance(4) ? 0.3 : 0.05;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    for (double& x : p)
    {
      x = bytes.chance(2000) ? notANumber : x + shift * (bytes.unit() - 0.5) * image->GetSpacing()[0];
    }
    points->InsertNextPoint(p);
  }
  grid->SetPoints(points);
  const int type = bytes.below(3);
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    vtkIdType p[8];
    vtkNew<vtkIdList> ids;
    image->GetCellPoints(cell, ids);
    const int order[8] = { 0, 1, 3, 2, 4, 5, 7, 6 };
    for (int i = 0; i < 8; ++i)
    {
      p[i] = bytes.chance(3000) ? bytes.below(100) - 1 : ids->GetId(order[i]);
    }
    const vtkIdType wedges[2][6] = { { p[0], p[1], p[2], p[4], p[5], p[6] }, { p[0], p[2], p[3], p[4], p[6], p[7] } };
    const vtkIdType tetrahedra[6][4] = { { p[0], p[1], p[2], p[6] }, { p[0], p[2], p[3], p[6] },
      { p[0], p[3], p[7], p[6] }, { p[0], p[7], p[4], p[6] }, { p[0], p[4], p[5], p[6] }, { p[0], p[5], p[1], p[6] } };
    for (int i = 0; i < 6 && type == 0; ++i)
    {
      grid->InsertNextCell(VTK_TETRA, 4, tetrahedra[i]);
    }
    for (int i = 0; i < 2 && type == 1; ++i)
    {
      grid->InsertNextCell(VTK_WEDGE, 6, wedges[i]);
    }
    if (type == 2)
    {
      grid->InsertNextCell(VTK_HEXAHEDRON, 8, p);
    }
  }
  return grid;
}

vtkSmartPointer<vtkDoubleArray> named(const std::string& name, vtkIdType count)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfValues(count);
  return array;
}

void addMaterials(vtkDataSet* grid, Bytes& bytes)
{
  const vtkIdType count = grid->GetNumberOfCells();
  const int materials = 1 + bytes.below(4);
  if (bytes.chance(2))
  {
    vtkNew<vtkIntArray> ids;
    ids->SetName("material");
    for (vtkIdType i = 0; i < count; ++i)
    {
      ids->InsertNextValue(bytes.chance(1000) ? -1 : bytes.below(materials));
    }
    grid->GetCellData()->AddArray(ids);
    return;
  }
  std::vector<vtkSmartPointer<vtkDoubleArray>> fractions;
  for (int m = 0; m < materials; ++m)
  {
    fractions.push_back(named("vf_" + std::to_string(m), count));
    grid->GetCellData()->AddArray(fractions.back());
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    double left = 1.0;
    for (int m = 0; m < materials; ++m)
    {
      const double part = m + 1 == materials ? left : left * (bytes.chance(2) ? bytes.below(2) : bytes.unit());
      fractions[static_cast<std::size_t>(m)]->SetValue(i, bytes.chance(2000) ? notANumber : part);
      left -= part;
    }
  }
}

void addField(vtkDataSet* grid, Bytes& bytes)
{
  const bool atPoints = bytes.chance(2);
  const vtkIdType count = atPoints ? grid->GetNumberOfPoints() : grid->GetNumberOfCells();
  const auto field = named("density", count);
  const double scale = std::pow(10.0, bytes.below(13) - 6);
  for (vtkIdType i = 0; i < count; ++i)
  {
    field->SetValue(i, bytes.chance(3000) ? notANumber : scale * bytes.unit());
  }
  (atPoints ? static_cast<vtkDataSetAttributes*>(grid->GetPointData()) : grid->GetCellData())->AddArray(field);
}

void require(bool holds, const char* what)
{
  if (!holds)
  {
    std::fprintf(stderr, "%s\n", what);
    std::abort();
  }
}

double volumeOf(vtkUnstructuredGrid* mesh)
{
  double sum = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    double p[4][3];
    for (int i = 0; i < 4; ++i)
    {
      mesh->GetPoint(ids->GetId(i), p[i]);
    }
    double e[3][3];
    for (int i = 0; i < 3; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        e[i][axis] = p[i + 1][axis] - p[0][axis];
      }
    }
    const double volume = e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                          e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                          e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
    sum += std::abs(volume) / 6.0;
  }
  return sum;
}

void checkOutput(vtkStrataTetrahedra* filter)
{
  vtkUnstructuredGrid* mesh = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
  if (mesh->GetNumberOfCells() == 0)
  {
    return;
  }
  double bounds[6];
  mesh->GetBounds(bounds); // the input may have points that no cell uses
  const double box = (bounds[1] - bounds[0]) * (bounds[3] - bounds[2]) * (bounds[5] - bounds[4]);
  require(std::abs(volumeOf(mesh) - box) <= 1e-4 * box, "The cells don't fill the box");
  require(
    !filter->GetBoundMet() || filter->GetAchievedInterfaceError() <= filter->GetInterfaceErrorBound() * (1.0 + 1e-6),
    "The bound is met, but the achieved interface error is larger");
  vtkNew<vtkStrataExtractMaterials> pieces;
  pieces->SetInputData(mesh);
  pieces->Update();
  vtkNew<vtkStrataRepresentedInterfaces> interfaces;
  interfaces->SetInputData(mesh);
  interfaces->Update();
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  vtkObject::GlobalWarningDisplayOff();
  Bytes bytes(data, size);
  vtkNew<vtkStrataTetrahedra> filter;
  filter->SetMaximumLevel(bytes.below(13));
  filter->SetInterfaceErrorBound(0.02 + bytes.unit());
  filter->SetFieldErrorBound(0.01 + bytes.unit());
  filter->SetErrorMethod(bytes.below(4));
  filter->SetNativeElements(bytes.below(2));
  filter->SetGhostMethod(bytes.below(3));
  filter->SetDistanceMethod(bytes.below(2));
  filter->SetMinimumVolumeFraction(bytes.unit());
  filter->SetLimitCells(bytes.chance(4));
  filter->SetMaximumNumberOfCells(1 + bytes.below(5000));
  const vtkSmartPointer<vtkDataSet> grid = randomGrid(bytes);
  addMaterials(grid, bytes);
  addField(grid, bytes);
  filter->SetInputData(grid);
  filter->Update();
  checkOutput(filter);
  return 0;
}
