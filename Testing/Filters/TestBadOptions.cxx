#include "TwoHalves.h"

#include "vtkStrataTetrahedra.h"

#include <gtest/gtest.h>

#include <limits>

using namespace strata::test;

namespace
{
struct BadOptions : testing::Test
{
  BadOptions()
  {
    filter->SetInputData(twoHalves(4));
    filter->SetInterfaceErrorBound(0.2);
  }
  vtkNew<vtkStrataTetrahedra> filter;
};
}

TEST_F(BadOptions, BoundsMustBePositive)
{
  filter->SetInterfaceErrorBound(-1.0);
  EXPECT_REFUSED(filter, "InterfaceErrorBound is -1");
  filter->SetInterfaceErrorBound(std::numeric_limits<double>::quiet_NaN());
  EXPECT_REFUSED(filter, "InterfaceErrorBound is nan");
  filter->SetInterfaceErrorBound(0.0);
  EXPECT_EQ(update(filter).error, "");
  filter->SetFieldErrorBound(0.0);
  EXPECT_REFUSED(filter, "FieldErrorBound is 0");
  filter->SetFieldErrorBound(0.01);
  filter->AddAbsoluteFieldErrorBound("density", -3.0);
  EXPECT_REFUSED(filter, "density", "-3");
}

TEST_F(BadOptions, NamesThatAreMissingAreNamedWithWhatThereIs)
{
  filter->AddFieldArray("temperature");
  EXPECT_REFUSED(filter, "temperature", "density");
  filter->ClearFieldArrays();
  filter->AddVolumeFractionArray("vf_lead");
  EXPECT_REFUSED(filter, "vf_lead", "volume_fraction_left");
  filter->ClearVolumeFractionArrays();
  filter->AddMaterialWithoutFields("lead");
  EXPECT_REFUSED(filter, "lead", "'left', 'right'");
  filter->ClearMaterialsWithoutFields();
  filter->AddAbsoluteFieldErrorBound("temperature", 1.0);
  EXPECT_REFUSED(filter, "temperature");
}

TEST_F(BadOptions, LimitsMustMakeSense)
{
  filter->SetBaseCubes(1, 0, 1);
  EXPECT_REFUSED(filter, "BaseCubes is 0");
  filter->SetBaseCubes(1, 1, 1);
  filter->SetMaximumLevel(-1);
  EXPECT_REFUSED(filter, "MaximumLevel is -1");
  filter->SetMaximumLevel(60);
  filter->SetMinimumVolumeFraction(1.5);
  EXPECT_REFUSED(filter, "MinimumVolumeFraction is 1.5");
}

TEST_F(BadOptions, TheFilterWorksAgainAfterAnError)
{
  filter->SetInterfaceErrorBound(-1.0);
  EXPECT_REFUSED(filter, "InterfaceErrorBound");
  filter->SetInterfaceErrorBound(0.2);
  EXPECT_EQ(update(filter).error, "");
  EXPECT_GT(cellsOf(filter), 0);
}
