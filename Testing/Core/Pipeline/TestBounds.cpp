#include "Pipeline.h"

#include "Model/Errors.h"
#include "Support/MeshAssertions.h"
#include "Support/SphereCase.h"

namespace strata
{
namespace
{
using namespace test;

SelectOptions bounds(double interfaceError, double fieldError, ErrorMethod method = ErrorMethod::Direct)
{
  SelectOptions options;
  options.errorMethod = method;
  options.bounds = { interfaceError, { fieldError } };
  return options;
}

Mesh meshOf(const SphereCase& sphere, const SelectOptions& select, const BuildOptions& build = {})
{
  Progress progress;
  return Multiresolution(sphere.native, sphere.interfaces, build).level(select, progress);
}

/// Calls visit(cell, weights) for every cell of the mesh that holds the point.
template<typename Visit>
void forCellsAt(const Mesh& mesh, const Vector& p, Visit visit)
{
  for (Index c = 0; c < mesh.cellCount(); ++c)
  {
    const std::array<Vector, 4> corners = cornersOf(mesh, c);
    Box box;
    for (const Vector& corner : corners)
    {
      box.add(corner);
    }
    if (box.contains(p))
    {
      const std::array<double, 4> weights = weightsIn(corners, p);
      if (*std::min_element(weights.begin(), weights.end()) >= 0.0)
      {
        visit(c, weights);
      }
    }
  }
}

double interpolated(const Mesh& mesh, const Buffer<float>& values, Index cell, const std::array<double, 4>& weights)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    sum += weights[i] * values[mesh.tetrahedra[4 * cell + static_cast<Index>(i)]];
  }
  return sum;
}

class BoundsBy : public testing::TestWithParam<ErrorMethod>
{
};

INSTANTIATE_TEST_SUITE_P(EveryMethod, BoundsBy,
  testing::Values(ErrorMethod::Direct, ErrorMethod::Saturated, ErrorMethod::Fitted, ErrorMethod::Accumulated));

TEST_P(BoundsBy, NoSampleIsFartherFromItsMaterialsFieldThanItsCellClaims)
{
  const SphereCase sphere = sphereCase(12, 3, wavyField);
  const Mesh mesh = meshOf(sphere, bounds(0.02, 0.05, GetParam()));
  EXPECT_TRUE(mesh.achieved.boundMet);
  double largest = 0.0;
  double claimed = 0.0;
  for (SampleIndex s = 0; s < sphere.native->sampleCount(); ++s)
  {
    Vector p;
    MaterialSet materials;
    sphere.native->positions(&s, 1, &p);
    sphere.native->materialsAt(&s, 1, &materials);
    for (const MaterialId m : materials)
    {
      double value = 0.0;
      sphere.native->values(FieldId(0), m, &s, 1, &value);
      int cells = 0;
      forCellsAt(mesh, p, [&](Index c, const std::array<double, 4>& weights) {
        const auto& field = mesh.values[0][static_cast<std::size_t>(m.value)];
        const double error = std::abs(value - interpolated(mesh, field, c, weights));
        ASSERT_LE(error, static_cast<double>(mesh.cellFieldErrors[0][c]) + 1e-12) << "sample " << s;
        largest = std::max(largest, error);
        ++cells;
      });
      EXPECT_GT(cells, 0) << "sample " << s << " lies in no cell";
    }
  }
  for (const float error : mesh.cellFieldErrors[0])
  {
    claimed = std::max(claimed, static_cast<double>(error));
  }
  EXPECT_LE(claimed, 0.05);
  // A claim that no sample reaches would be no bound but a guess.
  EXPECT_NEAR(largest, claimed, 1e-6 * claimed);
}

TEST_P(BoundsBy, NoInterfaceVertexIsFartherFromThePlaneThanItsCellClaims)
{
  const SphereCase sphere = sphereCase(8, 3, wavyField);
  const Mesh mesh = meshOf(sphere, bounds(0.01, 1.0, GetParam()));
  double largest = 0.0;
  for (const Vector& p : sphere.interfaces.points)
  {
    forCellsAt(mesh, p, [&](Index c, const std::array<double, 4>& weights) {
      const std::array<Vector, 4> corners = cornersOf(mesh, c);
      const double d =
        interpolated(mesh, mesh.distances[0], c, weights) - interpolated(mesh, mesh.distances[1], c, weights);
      // The gradient of a linear function from its differences along three edges.
      Eigen::Matrix3d edges;
      Vector differences;
      const auto signedDistance = [&](Index i) {
        const Index v = mesh.tetrahedra[4 * c + i];
        return static_cast<double>(mesh.distances[0][v]) - static_cast<double>(mesh.distances[1][v]);
      };
      for (Index i = 0; i < 3; ++i)
      {
        edges.row(i) = corners[static_cast<std::size_t>(i + 1)] - corners[0];
        differences[i] = signedDistance(i + 1) - signedDistance(0);
      }
      const Vector gradient = edges.inverse() * differences;
      const double error = std::abs(d) / gradient.norm();
      ASSERT_LE(error, static_cast<double>(mesh.cellInterfaceError[c]) * (1.0 + 1e-9) + 1e-12);
      largest = std::max(largest, error);
    });
  }
  EXPECT_LE(largest, 0.01);
  EXPECT_NEAR(largest, mesh.achieved.interfaceError, 1e-5 * largest);
}

TEST(Bounds, AFieldThatIsLinearInEachMaterialHasNoErrorInTheBaseMesh)
{
  const auto linear = [](std::size_t m, const Vector& p) {
    return m == 0 ? 5.0 + p.x() - 2.0 * p.y() + 0.5 * p.z() : -p.x() + 3.0 * p.z();
  };
  const SphereCase sphere = sphereCase(8, 2, linear);
  const Mesh mesh = meshOf(sphere, bounds(10.0, 1e-5));
  EXPECT_EQ(6, mesh.cellCount());
  EXPECT_LE(mesh.achieved.fieldErrors[0], 5e-6);
}

TEST(Bounds, AMaximumLevelThatStopsRefinementIsReported)
{
  const SphereCase sphere = sphereCase(8, 2, wavyField);
  BuildOptions shallow;
  shallow.maximumLevel = 6;
  const Mesh mesh = meshOf(sphere, bounds(1e-3, 1e-3), shallow);
  EXPECT_FALSE(mesh.achieved.boundMet);
  EXPECT_EQ("maximum level", mesh.achieved.stoppedBy);
  EXPECT_GT(mesh.achieved.interfaceError, 1e-3);
  EXPECT_EQ(6, *std::max_element(mesh.cellLevel.begin(), mesh.cellLevel.end()));
}

TEST(Bounds, BoundsThatAreNotPositiveAreRefusedByName)
{
  const SphereCase sphere = sphereCase(4, 1, wavyField);
  try
  {
    meshOf(sphere, bounds(0.1, 0.0));
    FAIL() << "a bound of zero was taken";
  }
  catch (const InvalidInput& error)
  {
    EXPECT_NE(std::string::npos, std::string(error.what()).find("'density'"));
  }
  EXPECT_THROW(meshOf(sphere, bounds(-1.0, 0.1)), InvalidInput);
  EXPECT_THROW(meshOf(sphere, bounds(std::nan(""), 0.1)), InvalidInput);
}

TEST(Bounds, CellsOfOneMaterialNameItAndMixedCellsDoNot)
{
  const SphereCase sphere = sphereCase(8, 3, wavyField);
  const Mesh mesh = meshOf(sphere, bounds(0.01, 0.1));
  for (Index c = 0; c < mesh.cellCount(); ++c)
  {
    int inside = 0;
    int outside = 0;
    for (Index i = 0; i < 4; ++i)
    {
      const Index v = mesh.tetrahedra[4 * c + i];
      const Vector p(mesh.points[3 * v], mesh.points[3 * v + 1], mesh.points[3 * v + 2]);
      const double d = (p - sphere.center).norm() - sphere.radius;
      // The triangulated sphere lies up to 1 % of the radius within the true one.
      inside += d < -0.01 ? 1 : 0;
      outside += d > 0.01 ? 1 : 0;
    }
    if (inside > 0 && outside > 0)
    {
      EXPECT_EQ(-1, mesh.cellMaterial[c]) << "cell " << c;
    }
    else if (inside == 4 || outside == 4)
    {
      EXPECT_EQ(inside == 4 ? 0 : 1, mesh.cellMaterial[c]) << "cell " << c;
    }
  }
}
}
}
