#include "KeptLevels.h"

#include "Pipeline.h"
#include "Support/MeshAssertions.h"
#include "Support/SphereCase.h"

#include <set>
#include <string>

namespace strata
{
namespace
{
using namespace test;

constexpr Index numbersInMesh = 100;
constexpr std::size_t bytesInMesh = numbersInMesh * sizeof(double);

/// A mesh that can be told by its points.
Mesh meshOf(double number)
{
  Mesh mesh;
  mesh.points = Buffer<double>(numbersInMesh);
  std::fill(mesh.points.begin(), mesh.points.end(), number);
  return mesh;
}

KeptLevels::Key keyOf(double number)
{
  return { { number, { number } }, {} };
}

double found(KeptLevels& levels, const KeptLevels::Key& key)
{
  const Mesh* mesh = levels.find(key);
  return mesh ? mesh->points[numbersInMesh - 1] : 0.0;
}

TEST(KeptLevels, ThoseThatWereLongestNotAskedForAreForgottenFirst)
{
  KeptLevels levels(2 * bytesInMesh);
  levels.keep(keyOf(1.0), meshOf(1.0));
  levels.keep(keyOf(2.0), meshOf(2.0));
  EXPECT_EQ(1.0, found(levels, keyOf(1.0)));
  levels.keep(keyOf(3.0), meshOf(3.0));
  EXPECT_EQ(1.0, found(levels, keyOf(1.0)));
  EXPECT_EQ(nullptr, levels.find(keyOf(2.0)));
  EXPECT_EQ(3.0, found(levels, keyOf(3.0)));
}

TEST(KeptLevels, AMeshLargerThanTheLimitIsNotKeptAndDrivesNoneOut)
{
  KeptLevels levels(bytesInMesh);
  levels.keep(keyOf(1.0), meshOf(1.0));
  Mesh large = meshOf(2.0);
  large.tetrahedra = Buffer<std::int64_t>(1);
  levels.keep(keyOf(2.0), large);
  EXPECT_EQ(nullptr, levels.find(keyOf(2.0)));
  EXPECT_EQ(1.0, found(levels, keyOf(1.0)));
}

TEST(KeptLevels, OtherBoundsOrArraysAreAnotherLevel)
{
  KeptLevels levels(bytesInMesh);
  const KeptLevels::Key kept = keyOf(1.0);
  levels.keep(kept, meshOf(1.0));
  KeptLevels::Key other = kept;
  other.bounds.interfaceError = 0.5;
  EXPECT_EQ(nullptr, levels.find(other));
  other = kept;
  other.bounds.fieldErrors[0] = 0.5;
  EXPECT_EQ(nullptr, levels.find(other));
  for (bool EmitOptions::*const array :
    { &EmitOptions::distances, &EmitOptions::perMaterialValues, &EmitOptions::ghosts })
  {
    other = kept;
    other.emitted.*array = false;
    EXPECT_EQ(nullptr, levels.find(other));
  }
  EXPECT_EQ(1.0, found(levels, kept));
}

TEST(KeptLevels, AFittedLevelThatIsComeBackToHasTheSameBytesAndIsNotFittedAgain)
{
  const SphereCase sphere = sphereCase(10, 3, wavyField);
  Multiresolution hierarchy(sphere.native, sphere.interfaces, {});
  const auto visit = [&](double scale, const EmitOptions& emitted = {}) {
    SelectOptions options;
    options.bounds = { 0.01 * scale, { 0.05 * scale } };
    options.errorMethod = ErrorMethod::Fitted;
    std::set<std::string> stages;
    Progress progress([&](const std::string& stage, double) { return stages.insert(stage), true; });
    Mesh mesh = hierarchy.level(options, progress, emitted);
    return std::make_pair(std::move(mesh), stages.count("Writing the mesh") > 0);
  };
  const auto [first, firstWritten] = visit(1.0);
  EXPECT_TRUE(firstWritten);
  EXPECT_TRUE(visit(2.0).second);
  const auto [again, againWritten] = visit(1.0);
  EXPECT_FALSE(againWritten);
  expectSameMesh(first, again);
  // Whoever gets a level may change it.
  visit(1.0).first.points[0] = 17.0;
  expectSameMesh(first, visit(1.0).first);
  const auto [bare, bareWritten] = visit(1.0, { false, false, false });
  EXPECT_TRUE(bareWritten);
  EXPECT_EQ(first.cellCount(), bare.cellCount());
}
}
}
