#include "Pipeline.h"

#include "Model/Errors.h"
#include "Model/Hierarchy.h"
#include "Support/MeshAssertions.h"
#include "Support/SphereCase.h"

#include <tbb/global_control.h>

#include <random>

namespace strata
{
namespace
{
using namespace test;

SelectOptions bounds(double interfaceError, double fieldError, ErrorMethod method = ErrorMethod::Direct)
{
  SelectOptions options;
  options.bounds = { interfaceError, { fieldError } };
  options.errorMethod = method;
  return options;
}

const SphereCase& sphere()
{
  static const SphereCase instance = sphereCase(10, 3, wavyField);
  return instance;
}

Multiresolution multiresolution(const BuildOptions& options = {})
{
  return Multiresolution(sphere().native, sphere().interfaces, options);
}

Mesh levelOf(Multiresolution& from, const SelectOptions& options)
{
  Progress progress;
  return from.level(options, progress);
}

TEST(Levels, EveryLevelConformsAndFillsTheBox)
{
  for (const std::array<int, 3>& cubes : { std::array<int, 3>{ 1, 1, 1 }, std::array<int, 3>{ 2, 1, 3 } })
  {
    BuildOptions build;
    build.baseCubes = cubes;
    Multiresolution hierarchy = multiresolution(build);
    for (const ErrorMethod method :
      { ErrorMethod::Direct, ErrorMethod::Saturated, ErrorMethod::Fitted, ErrorMethod::Accumulated })
    {
      for (const double scale : { 8.0, 2.0, 1.0 })
      {
        const Mesh mesh = levelOf(hierarchy, bounds(0.01 * scale, 0.05 * scale, method));
        expectConforming(mesh, sphere().native->box());
        EXPECT_TRUE(mesh.achieved.boundMet);
      }
    }
  }
}

TEST(Levels, TheTetrahedraFillTheLatticeExactlyInIntegers)
{
  Multiresolution multi = multiresolution();
  levelOf(multi, bounds(0.02, 0.1));
  const Hierarchy& hierarchy = *multi.hierarchy();
  // Six times the volume, in units of 2^-8 of a cube's edge: exact, since no cell is deeper than 24 bisections.
  constexpr int shift = Lattice::octaves - 8;
  std::int64_t sum = 0;
  for (const HierarchyCell& cell : hierarchy.cells)
  {
    ASSERT_LE(cell.level, 24);
    if (cell.firstChild.valid())
    {
      continue;
    }
    std::array<std::array<std::int64_t, 3>, 3> e;
    const LatticePoint& a = hierarchy.vertices[static_cast<std::size_t>(cell.corners[0].value)];
    for (std::size_t i = 0; i < 3; ++i)
    {
      const LatticePoint& b = hierarchy.vertices[static_cast<std::size_t>(cell.corners[i + 1].value)];
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        e[i][axis] = (b.at[axis] - a.at[axis]) >> shift;
      }
    }
    sum +=
      std::abs(e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) - e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
               e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]));
  }
  EXPECT_EQ(std::int64_t{ 6 } * 256 * 256 * 256, sum);
}

TEST(Levels, ATighterBoundRefinesTheMeshOfALooserOne)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> scale(0.5, 8.0);
  for (const ErrorMethod method : { ErrorMethod::Direct, ErrorMethod::Saturated, ErrorMethod::Accumulated })
  {
    Multiresolution hierarchy = multiresolution();
    for (int trial = 0; trial < 6; ++trial)
    {
      SelectOptions loose = bounds(0.01 * scale(random), 0.04 * scale(random), method);
      loose.finestBounds = { 0.005, { 0.02 } };
      SelectOptions tight = loose;
      tight.bounds.interfaceError *= 0.6;
      tight.bounds.fieldErrors[0] *= 0.9;
      expectRefines(levelOf(hierarchy, tight), levelOf(hierarchy, loose));
    }
  }
}

TEST(Levels, TheWayToALevelDoesNotMatter)
{
  for (const ErrorMethod method :
    { ErrorMethod::Direct, ErrorMethod::Saturated, ErrorMethod::Fitted, ErrorMethod::Accumulated })
  {
    Multiresolution moved = multiresolution();
    levelOf(moved, bounds(0.05, 0.5, method));
    levelOf(moved, bounds(0.005, 0.02, method));
    const Mesh there = levelOf(moved, bounds(0.02, 0.1, method));
    Multiresolution fresh = multiresolution();
    expectSameMesh(there, levelOf(fresh, bounds(0.02, 0.1, method)));
  }
}

TEST(Levels, OneThreadAndTwoGiveTheSameBytes)
{
  for (const ErrorMethod method : { ErrorMethod::Direct, ErrorMethod::Fitted })
  {
    Multiresolution two = multiresolution();
    const Mesh withTwo = levelOf(two, bounds(0.01, 0.05, method));
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    Multiresolution single = multiresolution();
    expectSameMesh(withTwo, levelOf(single, bounds(0.01, 0.05, method)));
  }
}

TEST(Levels, FittingNeedsFarFewerCellsForTheSameBounds)
{
  Multiresolution hierarchy = multiresolution();
  const Mesh direct = levelOf(hierarchy, bounds(0.004, 0.02));
  const Mesh fitted = levelOf(hierarchy, bounds(0.004, 0.02, ErrorMethod::Fitted));
  EXPECT_TRUE(fitted.achieved.boundMet);
  EXPECT_LT(static_cast<double>(fitted.cellCount()), 0.7 * static_cast<double>(direct.cellCount()));
}

TEST(Levels, FittingLeavesTheHierarchysOwnValuesAlone)
{
  Multiresolution hierarchy = multiresolution();
  levelOf(hierarchy, bounds(0.01, 0.05, ErrorMethod::Fitted));
  Multiresolution fresh = multiresolution();
  expectSameMesh(levelOf(hierarchy, bounds(0.01, 0.05)), levelOf(fresh, bounds(0.01, 0.05)));
}

TEST(Levels, ABudgetGivesTheLevelWithTheSmallestErrorThatFits)
{
  for (const ErrorMethod method : { ErrorMethod::Direct, ErrorMethod::Saturated })
  {
    Multiresolution hierarchy = multiresolution();
    for (const Index budget : { 6, 100, 777, 2000 })
    {
      SelectOptions options = bounds(1e-3, 1e-2, method);
      options.maximumNumberOfCells = budget;
      options.finestBounds = { 0.005, { 0.02 } };
      if (method == ErrorMethod::Saturated)
      {
        options.bounds = options.finestBounds;
      }
      const Mesh mesh = levelOf(hierarchy, options);
      EXPECT_LE(mesh.cellCount(), budget);
      EXPECT_EQ("maximum number of cells", mesh.achieved.stoppedBy);
      EXPECT_FALSE(mesh.achieved.boundMet);
      expectConforming(mesh, sphere().native->box());
      if (method == ErrorMethod::Direct)
      {
        // Any bounds a little below what this level needs give more cells than the budget allows.
        double scale = mesh.achieved.interfaceError / options.bounds.interfaceError;
        scale = std::max(scale, mesh.achieved.fieldErrors[0] / options.bounds.fieldErrors[0]) * (1.0 - 1e-6);
        SelectOptions finer = bounds(options.bounds.interfaceError * scale, options.bounds.fieldErrors[0] * scale);
        EXPECT_GT(levelOf(hierarchy, finer).cellCount(), budget);
      }
    }
  }
}

TEST(Levels, ALargerBudgetRefinesTheMeshOfASmallerOne)
{
  Multiresolution hierarchy = multiresolution();
  SelectOptions options = bounds(1e-3, 1e-2);
  options.maximumNumberOfCells = 50;
  Mesh coarse = levelOf(hierarchy, options);
  for (const Index budget : { 120, 500, 1200, 3000 })
  {
    options.maximumNumberOfCells = budget;
    Mesh fine = levelOf(hierarchy, options);
    expectRefines(fine, coarse);
    coarse = std::move(fine);
  }
}

TEST(Levels, ABudgetBelowTheBaseMeshIsRefused)
{
  Multiresolution hierarchy = multiresolution();
  SelectOptions options = bounds(0.1, 0.1);
  options.maximumNumberOfCells = 5;
  EXPECT_THROW(levelOf(hierarchy, options), InvalidInput);
}

TEST(Levels, AccumulatedErrorsNeedAtLeastTheCellsOfSaturatedOnes)
{
  Multiresolution hierarchy = multiresolution();
  SelectOptions options = bounds(0.02, 0.08, ErrorMethod::Accumulated);
  options.finestBounds = { 0.005, { 0.01 } };
  const Index accumulated = levelOf(hierarchy, options).cellCount();
  options.errorMethod = ErrorMethod::Saturated;
  const Index saturated = levelOf(hierarchy, options).cellCount();
  options.errorMethod = ErrorMethod::Direct;
  const Index direct = levelOf(hierarchy, options).cellCount();
  EXPECT_GE(accumulated, saturated);
  EXPECT_GE(saturated, direct);
  EXPECT_GT(accumulated, direct);
}

TEST(Levels, AStopByTheUserLeavesAHierarchyThatStillWorks)
{
  Multiresolution hierarchy = multiresolution();
  int reports = 0;
  Progress stopping([&](const std::string&, double) { return ++reports < 2; });
  EXPECT_THROW(hierarchy.level(bounds(0.002, 0.005), stopping), Cancelled);
  Multiresolution fresh = multiresolution();
  expectSameMesh(levelOf(hierarchy, bounds(0.02, 0.1)), levelOf(fresh, bounds(0.02, 0.1)));
}
}
}
