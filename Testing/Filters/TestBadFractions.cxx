#include "TwoHalves.h"

#include "vtkStrataMaterialInterfaces.h"
#include "vtkStrataTetrahedra.h"

#include <gtest/gtest.h>
#include <vtkIntArray.h>

#include <cmath>
#include <limits>

using namespace strata::test;

namespace
{
Outcome refine(vtkImageData* image)
{
  vtkNew<vtkStrataTetrahedra> filter;
  filter->SetInputData(image);
  const Outcome outcome = update(filter);
  EXPECT_EQ(outcome.error.empty(), cellsOf(filter) > 0);
  return outcome;
}

/// The two halves with another fraction in cell 5 (in `left`).
vtkSmartPointer<vtkImageData> withFraction(float value)
{
  auto image = twoHalves(4);
  cellArray(image, "volume_fraction_left")->SetValue(5, value);
  return image;
}
}

TEST(BadFractions, SmallOvershootsAreSilent)
{
  const Outcome outcome = refine(withFraction(1.008f));
  EXPECT_EQ(outcome.error + outcome.warning, "");
}

TEST(BadFractions, LargerOvershootsWarnWithTheCountAndTheWorstCell)
{
  auto image = withFraction(1.05f);
  cellArray(image, "volume_fraction_left")->SetValue(9, 0.97f);
  const Outcome outcome = refine(image);
  EXPECT_EQ(outcome.error, "");
  for (const char* text : { " 2 cells", "cell 5", "1.05" })
  {
    EXPECT_NE(outcome.warning.find(text), std::string::npos) << outcome.warning;
  }
}

TEST(BadFractions, SumsFarFromOneAreAnErrorThatNamesCellAndSum)
{
  auto image = twoHalves(4);
  cellArray(image, "volume_fraction_left")->SetValue(5, 0.7f);
  cellArray(image, "volume_fraction_right")->SetValue(5, 0.61f);
  const Outcome outcome = refine(image);
  EXPECT_NE(outcome.error.find("cell 5 sum to 1.31"), std::string::npos) << outcome.error;
}

TEST(BadFractions, FractionsOutsideTheUnitIntervalAreNamed)
{
  const Outcome outcome = refine(withFraction(-0.4f));
  EXPECT_NE(outcome.error.find("cell 5"), std::string::npos) << outcome.error;
}

TEST(BadFractions, NotANumberIsAnErrorThatNamesMaterialAndCell)
{
  const Outcome outcome = refine(withFraction(std::nanf("")));
  EXPECT_NE(outcome.error.find("'left' in cell 5 is nan"), std::string::npos) << outcome.error;
}

TEST(BadFractions, AFieldMustBeFiniteWhereItsMaterialIs)
{
  auto image = twoHalves(4);
  cellArray(image, "density_left")->SetValue(5, std::numeric_limits<float>::infinity());
  const Outcome outcome = refine(image);
  for (const char* text : { "density", "cell 5", "inf" })
  {
    EXPECT_NE(outcome.error.find(text), std::string::npos) << outcome.error;
  }
}

TEST(BadFractions, AFieldMayBeAnythingWhereItsMaterialIsNot)
{
  auto image = twoHalves(4);
  cellArray(image, "density_right")->SetValue(5, std::nanf(""));
  EXPECT_EQ(refine(image).error, "");
}

TEST(BadFractions, ASingleFractionLeavesTheRestToTheRemainder)
{
  auto image = twoHalves(4);
  image->GetCellData()->RemoveArray("volume_fraction_right");
  vtkNew<vtkStrataMaterialInterfaces> filter;
  filter->SetRemainderMaterial("air");
  filter->SetInputData(image);
  EXPECT_EQ(update(filter).error, "");
  auto* names = filter->GetOutputDataObject(0)->GetFieldData()->GetAbstractArray("material_names");
  ASSERT_EQ(names->GetNumberOfValues(), 2);
  EXPECT_EQ(names->GetVariantValue(1).ToString(), "air");
}

TEST(BadFractions, IdsMustBeIntegersAndNotNegative)
{
  auto image = twoHalves(2);
  vtkNew<vtkIntArray> ids;
  ids->SetName("region");
  ids->SetNumberOfTuples(8);
  ids->FillValue(7);
  ids->SetValue(3, -2);
  image->GetCellData()->AddArray(ids);
  vtkNew<vtkStrataMaterialInterfaces> filter;
  filter->SetInputData(image);
  filter->SetMaterialIdArray("region");
  EXPECT_REFUSED(filter, "cell 3", "-2");
  filter->SetMaterialIdArray("density_left");
  EXPECT_REFUSED(filter, "density_left", "integer");
  filter->SetMaterialIdArray("nowhere");
  EXPECT_REFUSED(filter, "nowhere", "missing", "density_left");
}
