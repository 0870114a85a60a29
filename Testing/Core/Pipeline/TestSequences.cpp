#include "Pipeline.h"

#include "Model/Hierarchy.h"
#include "Support/MeshAssertions.h"
#include "Support/SphereCase.h"

#include <limits>
#include <random>
#include <set>

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

Multiresolution multiresolution()
{
  return Multiresolution(sphere().native, sphere().interfaces, {});
}

Mesh levelOf(Multiresolution& from, const SelectOptions& options)
{
  Progress progress;
  return from.level(options, progress);
}

/// Levels chosen at random: bounds, a budget, a view, or a view with a budget.
class RandomChoice
{
public:
  explicit RandomChoice(unsigned seed) : random_(seed) {}

  SelectOptions next()
  {
    SelectOptions options;
    const double scale = between(1.0, 6.0);
    options.bounds = { 0.01 * scale, { 0.05 * between(0.5, 1.5) * scale } };
    const int kind = std::uniform_int_distribution<int>(0, 3)(random_);
    if (kind >= 2)
    {
      View view;
      view.position = Vector(between(-1.0, 2.0), between(-1.0, 2.0), 2.5);
      view.focalPoint = Vector(0.5, 0.5, 0.5);
      view.viewUp = Vector::UnitY();
      view.viewAngle = between(10.0, 40.0);
      view.imageHeight = 300;
      view.pixelBound = between(1.0, 4.0);
      options.interest.view = view;
    }
    if (kind % 2 == 1)
    {
      options.maximumNumberOfCells = std::uniform_int_distribution<Index>(6, 3000)(random_);
    }
    return options;
  }

  /// The same with something asked more exactly or allowed more of.
  SelectOptions finer(SelectOptions options)
  {
    if (options.maximumNumberOfCells < std::numeric_limits<Index>::max())
    {
      options.maximumNumberOfCells += std::uniform_int_distribution<Index>(0, 2000)(random_);
      return options;
    }
    options.bounds.interfaceError *= between(0.5, 1.0);
    options.bounds.fieldErrors[0] *= between(0.5, 1.0);
    if (options.interest.view)
    {
      options.interest.view->pixelBound *= between(0.5, 1.0);
    }
    return options;
  }

private:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  std::mt19937 random_;
};

TEST(Sequences, AnyLevelOfARandomSequenceConformsAndIsRefinedByTheFinerOne)
{
  RandomChoice choice(17);
  Multiresolution hierarchy = multiresolution();
  for (int step = 0; step < 25; ++step)
  {
    const SelectOptions coarse = choice.next();
    const Mesh fine = levelOf(hierarchy, choice.finer(coarse));
    const Mesh mesh = levelOf(hierarchy, coarse);
    expectConforming(mesh, sphere().native->box());
    EXPECT_LE(mesh.cellCount(), coarse.maximumNumberOfCells);
    expectRefines(fine, mesh);
  }
}

TEST(Sequences, ALevelHasTheSameBytesAfterAnySequenceOfOthers)
{
  RandomChoice choice(23);
  Multiresolution moved = multiresolution();
  for (int step = 0; step < 20; ++step)
  {
    const SelectOptions options = choice.next();
    const Mesh mesh = levelOf(moved, options);
    if (step % 4 == 3)
    {
      Multiresolution fresh = multiresolution();
      expectSameMesh(levelOf(fresh, options), mesh);
    }
  }
}

/// Every level of a hierarchy by what the words say: cells whose errors are more than a scale times their bounds are
/// split with all cells round the same edge, and what must be split before.
class EveryLevel
{
public:
  EveryLevel(const Hierarchy& hierarchy, const ErrorBounds& bounds) : hierarchy_(hierarchy), bounds_(bounds) {}

  /// The largest number of cells of a level, at any scale of at least 1, that is no more than the budget.
  Index largestWithin(Index budget) const
  {
    std::set<double> scales = { 1.0 };
    for (Index c = 0; c < static_cast<Index>(hierarchy_.cells.size()); ++c)
    {
      scales.insert(std::max(1.0, ratioOf(CellId(c))));
    }
    Index largest = 0;
    for (const double scale : scales)
    {
      const Index count = cellsAt(scale);
      largest = count <= budget ? std::max(largest, count) : largest;
    }
    return largest;
  }

private:
  double ratioOf(CellId c) const
  {
    return std::max(static_cast<double>(hierarchy_.interfaceError(c)) / bounds_.interfaceError,
      static_cast<double>(hierarchy_.fieldError(c, 0)) / bounds_.fieldErrors[0]);
  }

  Index cellsAt(double scale) const
  {
    std::set<DiamondId> split;
    std::vector<CellId> mesh;
    for (Index c = 0; c < hierarchy_.rootCount; ++c)
    {
      mesh.push_back(CellId(c));
    }
    for (std::size_t before = 0; before != mesh.size();)
    {
      before = mesh.size();
      for (const CellId c : mesh)
      {
        if (ratioOf(c) > scale)
        {
          splitWithParents(hierarchy_.cell(c).diamond, split);
        }
      }
      std::vector<CellId> next;
      for (const CellId c : mesh)
      {
        const HierarchyCell& cell = hierarchy_.cell(c);
        next.push_back(split.count(cell.diamond) > 0 ? cell.firstChild : c);
        if (split.count(cell.diamond) > 0)
        {
          next.push_back(CellId(cell.firstChild.value + 1));
        }
      }
      mesh.swap(next);
    }
    return static_cast<Index>(mesh.size());
  }

  void splitWithParents(DiamondId id, std::set<DiamondId>& split) const
  {
    if (split.insert(id).second)
    {
      for (const LatticePoint& parent : hierarchy_.lattice.parents(hierarchy_.diamond(id).center))
      {
        splitWithParents(hierarchy_.diamondAt(parent), split);
      }
    }
  }

  const Hierarchy& hierarchy_;
  const ErrorBounds& bounds_;
};

TEST(Sequences, ABudgetGivesTheLargestOfAllLevelsThatFits)
{
  SelectOptions options;
  options.bounds = { 0.03, { 0.15 } };
  Multiresolution multi = multiresolution();
  const Index finest = levelOf(multi, options).cellCount();
  ASSERT_GT(finest, 300);
  std::mt19937 random(5);
  for (int trial = 0; trial < 12; ++trial)
  {
    options.maximumNumberOfCells = std::uniform_int_distribution<Index>(6, finest + 20)(random);
    const Index count = levelOf(multi, options).cellCount();
    EXPECT_EQ(EveryLevel(*multi.hierarchy(), options.bounds).largestWithin(options.maximumNumberOfCells), count)
      << "of " << options.maximumNumberOfCells;
  }
}
}
}
