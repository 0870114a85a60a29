#pragma once

#include <vtkAlgorithm.h>
#include <vtkCellData.h>
#include <vtkDataObject.h>
#include <vtkExecutive.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkTestErrorObserver.h>

#include <cmath>
#include <string>

namespace strata::test
{
/// Two materials in the unit cube of n^3 cells, parted by the plane x = 1/2 (n even): `left` with the density 1 + y,
/// `right` with the density 10 - z.
inline vtkSmartPointer<vtkImageData> twoHalves(int n)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n + 1, n + 1, n + 1);
  image->SetSpacing(1.0 / n, 1.0 / n, 1.0 / n);
  vtkNew<vtkFloatArray> arrays[4];
  const char* const names[4] = { "volume_fraction_left", "volume_fraction_right", "density_left", "density_right" };
  for (int a = 0; a < 4; ++a)
  {
    arrays[a]->SetName(names[a]);
    arrays[a]->SetNumberOfTuples(image->GetNumberOfCells());
    image->GetCellData()->AddArray(arrays[a]);
  }
  vtkIdType cell = 0;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i, ++cell)
      {
        const bool left = 2 * i < n;
        arrays[0]->SetValue(cell, left ? 1.0f : 0.0f);
        arrays[1]->SetValue(cell, left ? 0.0f : 1.0f);
        arrays[2]->SetValue(cell, left ? 1.0f + static_cast<float>((j + 0.5) / n) : 0.0f);
        arrays[3]->SetValue(cell, left ? 0.0f : 10.0f - static_cast<float>((k + 0.5) / n));
      }
  return image;
}

inline vtkFloatArray* cellArray(vtkDataSet* data, const char* name)
{
  return vtkFloatArray::SafeDownCast(data->GetCellData()->GetArray(name));
}

/// Two halves whose densities are waves, so that each half asks for cells.
inline vtkSmartPointer<vtkImageData> twoWaves(int n)
{
  vtkSmartPointer<vtkImageData> image = twoHalves(n);
  for (const char* name : { "density_left", "density_right" })
  {
    vtkFloatArray* density = cellArray(image, name);
    for (vtkIdType cell = 0; cell < density->GetNumberOfTuples(); ++cell)
    {
      double b[6];
      image->GetCellBounds(cell, b);
      density->SetValue(cell, static_cast<float>(2.0 + std::sin(6.0 * (b[0] + b[2])) * std::cos(6.0 * b[4])));
    }
  }
  return image;
}

/// What a run of a filter said.
struct Outcome
{
  std::string error;
  std::string warning;
};

inline Outcome update(vtkAlgorithm* filter)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->Update();
  filter->RemoveObserver(observer);
  filter->GetExecutive()->RemoveObserver(observer);
  return { observer->GetErrorMessage(), observer->GetWarningMessage() };
}

inline vtkIdType cellsOf(vtkAlgorithm* filter)
{
  return filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL);
}

/// Expects a clear end: an error that says each of the texts, and an empty output.
#define EXPECT_REFUSED(filter, ...)                                                                                    \
  do                                                                                                                   \
  {                                                                                                                    \
    const strata::test::Outcome outcome = strata::test::update(filter);                                                \
    for (const std::string text : { __VA_ARGS__ })                                                                     \
    {                                                                                                                  \
      EXPECT_NE(outcome.error.find(text), std::string::npos) << text << " in: " << outcome.error;                      \
    }                                                                                                                  \
    EXPECT_EQ(strata::test::cellsOf(filter), 0);                                                                       \
  } while (false)
}

/// Leaves the cells from `begin` to `end` along z.
inline void cropAlongZ(vtkImageData* image, int begin, int end)
{
  int extent[6];
  image->GetExtent(extent);
  extent[4] = begin;
  extent[5] = end;
  image->Crop(extent);
}
