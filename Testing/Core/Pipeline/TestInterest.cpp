#include "Pipeline.h"

#include "Model/Errors.h"
#include "Support/MeshAssertions.h"
#include "Support/SphereCase.h"

#include <random>

namespace strata
{
namespace
{
using namespace test;

const SphereCase& sphere()
{
  static const SphereCase instance = sphereCase(10, 3, wavyField);
  return instance;
}

Mesh meshWith(const Interest& interest)
{
  SelectOptions options;
  options.bounds = { 0.005, { 0.02 } };
  options.interest = interest;
  Progress progress;
  return Multiresolution(sphere().native, sphere().interfaces, {}).level(options, progress);
}

/// Whether the cell, for sure, does not touch the place.
double distanceFrom(const Mesh& mesh, Index cell, const Vector& p)
{
  Box box;
  for (const Vector& corner : cornersOf(mesh, cell))
  {
    box.add(corner);
  }
  return std::sqrt(box.squaredDistance(p));
}

TEST(Interest, CellsWithoutAFocusMaterialAreOnlyAsFineAsConformityAsks)
{
  Interest interest;
  interest.focus = MaterialSet::of(MaterialId(0));
  const Mesh focused = meshWith(interest);
  const Mesh all = meshWith({});
  expectConforming(focused, sphere().native->box());
  expectRefines(all, focused);
  EXPECT_LT(focused.cellCount(), all.cellCount());
  EXPECT_TRUE(focused.achieved.boundMet);
  for (Index c = 0; c < focused.cellCount(); ++c)
  {
    if (focused.cellMaterial[c] != 1)
    {
      EXPECT_LE(focused.cellFieldErrors[0][c], 0.02f);
      EXPECT_LE(focused.cellInterfaceError[c], 0.005f);
    }
  }
}

TEST(Interest, OutsideTheRegionTheBoundsAreCoarser)
{
  for (const auto shape : { RegionOfInterest::Shape::Box, RegionOfInterest::Shape::Sphere })
  {
    RegionOfInterest region;
    region.shape = shape;
    region.center = Vector(0.75, 0.55, 0.5);
    region.radius = 0.1;
    region.box.add(region.center - Vector::Constant(0.1));
    region.box.add(region.center + Vector::Constant(0.1));
    region.coarsening = 8.0;
    Interest interest;
    interest.region = region;
    const Mesh mesh = meshWith(interest);
    expectConforming(mesh, sphere().native->box());
    EXPECT_LT(mesh.cellCount(), meshWith({}).cellCount());
    EXPECT_TRUE(mesh.achieved.boundMet);
    for (Index c = 0; c < mesh.cellCount(); ++c)
    {
      const bool inside = distanceFrom(mesh, c, region.center) < 0.05;
      EXPECT_LE(mesh.cellInterfaceError[c], (inside ? 1.0f : 8.0f) * 0.005f * 1.00001f);
      EXPECT_LE(mesh.cellFieldErrors[0][c], (inside ? 1.0f : 8.0f) * 0.02f * 1.00001f);
    }
  }
}

TEST(Interest, EveryCellThatTheCameraSeesIsExactToThePixelBound)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1.0, 2.0);
  for (int trial = 0; trial < 8; ++trial)
  {
    View view;
    view.position = Vector(place(random), place(random), 2.5);
    view.focalPoint = Vector(0.5, 0.5, 0.5);
    view.viewUp = Vector::UnitY();
    view.viewAngle = 20.0;
    view.imageHeight = 300;
    view.pixelBound = 2.0;
    Interest interest;
    interest.view = view;
    const Mesh mesh = meshWith(interest);
    expectConforming(mesh, sphere().native->box());
    EXPECT_TRUE(mesh.achieved.boundMet);
    const double pixelsAtOne = 300 / (2.0 * std::tan(10.0 * M_PI / 180.0));
    const Vector forward = (view.focalPoint - view.position).normalized();
    for (Index c = 0; c < mesh.cellCount(); ++c)
    {
      const std::array<Vector, 4> corners = cornersOf(mesh, c);
      bool seen = false;
      double nearest = 1e30;
      double diameter = 0.0;
      for (const Vector& corner : corners)
      {
        const Vector d = corner - view.position;
        // Well within the picture's inscribed cone.
        seen = seen || d.normalized().dot(forward) > std::cos(9.0 * M_PI / 180.0);
        nearest = std::min(nearest, d.norm());
        for (const Vector& other : corners)
        {
          diameter = std::max(diameter, (corner - other).norm());
        }
      }
      const double error = std::min(diameter, static_cast<double>(mesh.cellInterfaceError[c]));
      if (seen)
      {
        EXPECT_LE(error * pixelsAtOne / nearest, std::max(2.0, 0.005 * pixelsAtOne / nearest) + 1e-6);
      }
    }
  }
}

TEST(Interest, ACameraInsideTheDataGetsAMeshToo)
{
  Interest interest;
  interest.view.emplace();
  interest.view->position = sphere().center;
  const Mesh mesh = meshWith(interest);
  expectConforming(mesh, sphere().native->box());
  EXPECT_GT(mesh.cellCount(), 6);
}

TEST(Interest, AViewThatShowsNothingIsRefused)
{
  Interest interest;
  interest.view.emplace();
  interest.view->focalPoint = interest.view->position;
  EXPECT_THROW(meshWith(interest), InvalidInput);
  interest.view.emplace();
  interest.view->viewAngle = 180.0;
  EXPECT_THROW(meshWith(interest), InvalidInput);
  interest.view.emplace();
  interest.view->pixelBound = 0.0;
  EXPECT_THROW(meshWith(interest), InvalidInput);
}
}
}
