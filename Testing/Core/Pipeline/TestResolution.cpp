#include "Pipeline.h"

#include "Support/MeshAssertions.h"
#include "Support/SphereCase.h"

namespace strata
{
namespace
{
using namespace test;

/// A step of the floats just below 1, of which bounds need a few.
constexpr double floatStep = static_cast<double>(std::numeric_limits<float>::epsilon());

Mesh meshOf(const FieldOf& field, double fieldError, ErrorMethod method)
{
  const SphereCase sphere = sphereCase(6, 2, field);
  SelectOptions options;
  options.errorMethod = method;
  options.bounds = { 10.0, { fieldError } };
  Progress progress;
  return Multiresolution(sphere.native, sphere.interfaces, {}).level(options, progress);
}

class ResolutionBy : public testing::TestWithParam<ErrorMethod>
{
};

INSTANTIATE_TEST_SUITE_P(EveryMethod, ResolutionBy,
  testing::Values(ErrorMethod::Direct, ErrorMethod::Saturated, ErrorMethod::Fitted, ErrorMethod::Accumulated));

TEST_P(ResolutionBy, AConstantFieldNeedsNoCellsHoweverTightItsBound)
{
  // Neither value is a float: rounding alone makes errors.
  const auto constant = [](std::size_t, const Vector&) { return 1000.0 / 3.0; };
  const Mesh mesh = meshOf(constant, std::numeric_limits<double>::denorm_min(), GetParam());
  EXPECT_EQ(6, mesh.cellCount());
  EXPECT_LE(mesh.achieved.fieldErrors[0], 4.0 * floatStep * 1000.0 / 3.0);
  EXPECT_FALSE(mesh.achieved.boundMet);
  EXPECT_EQ("resolution of the stored values", mesh.achieved.stoppedBy);
}

TEST_P(ResolutionBy, AFieldOfZerosMeetsAnyBound)
{
  const Mesh mesh = meshOf([](std::size_t, const Vector&) { return 0.0; }, 1e-300, GetParam());
  EXPECT_EQ(6, mesh.cellCount());
  EXPECT_TRUE(mesh.achieved.boundMet);
  EXPECT_EQ("bounds met", mesh.achieved.stoppedBy);
}

TEST(Resolution, ALargeOffsetHidesBoundsBelowItsRounding)
{
  // Steps of floats near a million are 1/16.
  const auto offset = [](std::size_t m, const Vector& p) { return 1e6 + wavyField(m, p); };
  const Mesh mesh = meshOf(offset, 0.001, ErrorMethod::Direct);
  EXPECT_FALSE(mesh.achieved.boundMet);
  EXPECT_EQ("resolution of the stored values", mesh.achieved.stoppedBy);
  EXPECT_GT(mesh.achieved.fieldErrors[0], 0.001);
  EXPECT_LE(mesh.achieved.fieldErrors[0], 4.0 * floatStep * (1e6 + 13.0));
}
}
}
