#include "Conversion/MaterialNames.h"

#include <gtest/gtest.h>

#include <utility>

using strata::conversion::isEmptySpace;
using strata::conversion::isMaterialIdName;
using strata::conversion::materialOfFractions;

TEST(MaterialNames, FractionArraysOfTheCodesAreRecognized)
{
  const std::pair<const char*, const char*> conventions[] = { { "volume_fraction_block", "block" },
    { "block_vf", "block" }, { "vf_block", "block" }, { "alpha.block", "block" },
    { "Volume Fraction for Armor Plate", "Armor Plate" }, { "Armor Plate Volume Fraction", "Armor Plate" },
    { "Volume Fraction for Body, Nose", "Body, Nose" }, { "liquid_fraction", "liquid" },
    { "Material volume fraction - 3", "Material 3" }, { "Void volume fraction", "Void" } };
  for (const auto& [array, material] : conventions)
  {
    EXPECT_EQ(materialOfFractions(array), std::optional<std::string>(material)) << array;
  }
}

TEST(MaterialNames, OtherArraysAreNoFractions)
{
  for (const char* array :
    { "density", "mass_fraction", "oxygen_mass_fraction", "alpha", "alpha.", "_vf", "vf_", "volume_fraction", "" })
  {
    EXPECT_FALSE(materialOfFractions(array).has_value()) << array;
  }
}

TEST(MaterialNames, EmptySpaceHasItsUsualNames)
{
  EXPECT_TRUE(isEmptySpace("Void"));
  EXPECT_TRUE(isEmptySpace("empty"));
  EXPECT_FALSE(isEmptySpace("air"));
  EXPECT_TRUE(isMaterialIdName("MaterialIds"));
  EXPECT_FALSE(isMaterialIdName("materials_of_interest"));
}
