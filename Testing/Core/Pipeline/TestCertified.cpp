#include "Pipeline.h"

#include "Support/MeshAssertions.h"
#include "Support/SphereCase.h"

namespace strata
{
namespace
{
using namespace test;

/// The ball in a cube with point data on the grid's points, on a rectilinear grid or as hexahedra.
std::shared_ptr<const NativeData> withPointData(const SphereCase& sphere, bool asUnstructured)
{
  const UnstructuredGrid hexahedra = asHexahedra(std::get<RectilinearGrid>(sphere.simulation.grid));
  Simulation simulation = sphere.simulation;
  SimulationField& density = simulation.fields[0];
  density.association = Association::Points;
  for (std::size_t m = 0; m < 2; ++m)
  {
    std::vector<double> values;
    for (const Vector& p : hexahedra.points)
    {
      values.push_back(wavyField(m, p));
    }
    density.values[m] = ownedArray(std::move(values));
  }
  if (asUnstructured)
  {
    simulation.grid = hexahedra;
  }
  Progress progress;
  return readNativeData(simulation, {}, progress);
}

BuildOptions certified()
{
  BuildOptions build;
  build.nativeElements = NativeElements::Cells;
  return build;
}

class CertifiedBy : public testing::TestWithParam<ErrorMethod>
{
};

INSTANTIATE_TEST_SUITE_P(EveryMethod, CertifiedBy,
  testing::Values(ErrorMethod::Direct, ErrorMethod::Saturated, ErrorMethod::Fitted, ErrorMethod::Accumulated));

TEST_P(CertifiedBy, BoundsOverWholeCellsAreMetOnEveryKindOfData)
{
  const SphereCase sphere = sphereCase(7, 2, wavyField);
  SelectOptions select;
  select.errorMethod = GetParam();
  select.bounds = { 0.04, { 0.1 } };
  Progress progress;
  for (const auto& native : { sphere.native, withPointData(sphere, false), withPointData(sphere, true) })
  {
    const Mesh mesh = Multiresolution(native, sphere.interfaces, certified()).level(select, progress);
    EXPECT_TRUE(mesh.achieved.boundMet);
    EXPECT_EQ("bounds met", mesh.achieved.stoppedBy);
    expectConforming(mesh, native->box());
    const Mesh points = Multiresolution(native, sphere.interfaces, {}).level(select, progress);
    EXPECT_GT(mesh.cellCount(), points.cellCount());
    EXPECT_LT(mesh.cellCount(), 10 * points.cellCount());
  }
}

TEST(Certified, TheSameDataAsHexahedraGiveAboutTheBoundsOfTheirRectilinearGrid)
{
  const SphereCase sphere = sphereCase(6, 2, wavyField);
  SelectOptions select;
  select.bounds = { 10.0, { 1e9 } };
  Progress progress;
  const Mesh boxes =
    Multiresolution(withPointData(sphere, false), sphere.interfaces, certified()).level(select, progress);
  const Mesh hexahedra =
    Multiresolution(withPointData(sphere, true), sphere.interfaces, certified()).level(select, progress);
  ASSERT_EQ(boxes.cellCount(), hexahedra.cellCount());
  for (Index c = 0; c < boxes.cellCount(); ++c)
  {
    // Values beyond a material's data differ a little, being fitted to other samples.
    EXPECT_GT(hexahedra.cellFieldErrors[0][c], 0.6f * boxes.cellFieldErrors[0][c]);
    EXPECT_LT(hexahedra.cellFieldErrors[0][c], 1.6f * boxes.cellFieldErrors[0][c]);
  }
}
}
}
