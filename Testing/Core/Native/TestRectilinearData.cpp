#include "SampledSimulations.h"

#include "Native/LinearFit.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace strata;
using namespace strata::test;

namespace
{
constexpr std::array<GhostMethod, 3> methods = { GhostMethod::DataThenLinear, GhostMethod::Linear,
  GhostMethod::Constant };

/// Material 0 fills the part x < 0.5 of the unit box; cells cut by x = 0.5 are mixed.
double leftHalf(const Vector& p)
{
  return p.x() < 0.5 ? 1.0 : 0.0;
}

/// Volume fraction (nearly) of the outside of a ball of radius 0.3, on a grid of spacing 1/8.
double outsideBall(const Vector& p)
{
  return std::clamp(0.5 + 8.0 * ((p - Vector(0.5, 0.5, 0.5)).norm() - 0.3), 0.0, 1.0);
}

Vector closestOnBall(const Vector& p)
{
  const Vector center(0.5, 0.5, 0.5);
  return center + 0.3 * (p - center).normalized();
}
}

TEST(RectilinearData, ReproducesALinearFieldInTheWholeBoxAndHalfACellBeyond)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    std::mt19937 random(seed);
    const Function field = randomLinear(random);
    for (const Association association : { Association::Cells, Association::Points })
    {
      const auto data = read(twoMaterials(
        boxGrid(4, 5, 6, 1.0 + 0.05 * seed), [](const Vector&) { return 1.0; }, field, association));
      for (int i = 0; i < 50; ++i)
      {
        const Vector point = randomPoint(random, -0.05, 1.05);
        EXPECT_NEAR(valueAt(*data, block, point), field(block, point), 1e-12);
      }
    }
  }
}

TEST(RectilinearData, ReproducesEachMaterialsLinearFieldOnBothSidesOfTheInterface)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    std::mt19937 random(seed);
    const Function field = randomLinear(random);
    const auto data = read(twoMaterials(boxGrid(8, 8, 8, 1.0 + 0.01 * seed), outsideBall, field));
    for (int i = 0; i < 100; ++i)
    {
      const Vector point = randomPoint(random);
      const Vector closest = closestOnBall(point);
      const bool inBall = (point - Vector(0.5, 0.5, 0.5)).norm() < 0.3;
      for (const GhostMethod method : methods)
      {
        for (const MaterialId m : { block, rod })
        {
          const bool inside = (m == rod) == inBall;
          if (inside || method != GhostMethod::Constant)
          {
            EXPECT_NEAR(valueAt(*data, m, point, inside, closest, method), field(m, point), 1e-10);
          }
        }
      }
    }
  }
}

TEST(RectilinearData, GivesTheSamplesOwnValueAtItsPosition)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const Function noise = [&](MaterialId, const Vector&) { return number(random); };
  for (const Association association : { Association::Cells, Association::Points })
  {
    const auto data = read(twoMaterials(boxGrid(6, 7, 5, 1.1), outsideBall, noise, association));
    for (SampleIndex sample = 0; sample < data->sampleCount(); ++sample)
    {
      for (const MaterialId m : materialsOf(*data, sample))
      {
        for (const GhostMethod method : methods)
        {
          EXPECT_EQ(valueAt(*data, m, positionOf(*data, sample), true, Vector::Zero(), method),
            sampleValue(*data, FieldId(0), m, sample));
        }
      }
    }
  }
}

TEST(RectilinearData, ConvergesWithSecondOrderOnBothSidesOfTheInterface)
{
  const Function field = [](MaterialId m, const Vector& p) {
    return (m == block ? 1.0 : -2.0) * p.squaredNorm() + p.x() * p.y();
  };
  std::array<double, 2> errors{};
  for (std::size_t refinement = 0; refinement < 2; ++refinement)
  {
    const int n = refinement == 0 ? 16 : 32;
    const auto data = read(twoMaterials(boxGrid(n, n, n), outsideBall, field));
    std::mt19937 random(5);
    for (int i = 0; i < 3000; ++i)
    {
      const Vector direction = randomPoint(random, -1.0, 1.0).normalized();
      // Up to one cell beyond the material's region, where its closest point is the foot on the ball.
      const double beyond = std::uniform_real_distribution<double>(0.0, 1.0 / n)(random);
      const Vector point = Vector(0.5, 0.5, 0.5) + (0.3 + beyond) * direction;
      errors[refinement] = std::max(
        errors[refinement], std::abs(valueAt(*data, rod, point, false, closestOnBall(point)) - field(rod, point)));
    }
  }
  EXPECT_GT(std::log2(errors[0] / errors[1]), 1.8) << errors[0] << ' ' << errors[1];
}

TEST(RectilinearData, ContinuesAMaterialByTheConstantAtItsClosestPoint)
{
  const Function field = [](MaterialId, const Vector& p) { return p.x() + 10.0 * p.y(); };
  const auto data = read(twoMaterials(boxGrid(8, 8, 8), leftHalf, field));
  // The closest sample layer of the block is x = 7/16, half a cell before the interface.
  const Vector point(0.9, 0.25, 0.5);
  EXPECT_NEAR(
    valueAt(*data, block, point, false, Vector(0.5, 0.25, 0.5), GhostMethod::Constant), 7.0 / 16.0 + 2.5, 1e-12);
}

TEST(RectilinearData, KeepsAnExtrapolationWithinOneRangeOfTheData)
{
  // A parabola that falls from 1 to 0 towards the interface and would go far below.
  const Function field = [](MaterialId m, const Vector& p) { return m == block ? 1.0 - 4.0 * p.x() * p.x() : 0.0; };
  const auto data = read(twoMaterials(boxGrid(8, 8, 8), leftHalf, field));
  const double smallest = 1.0 - 4.0 * 49.0 / 256.0;
  const double largest = 1.0 - 4.0 / 256.0;
  const double far = valueAt(*data, block, Vector(1.0, 0.5, 0.5), false, Vector(0.5, 0.5, 0.5));
  EXPECT_NEAR(far, smallest - (largest - smallest), 1e-12);
}

TEST(RectilinearData, ExtrapolatesFromTheNearestSamplesOfASmallMaterial)
{
  const Function field = [](MaterialId m, const Vector&) { return m == rod ? 7.0 : 1.0; };
  const Vector home(0.5 / 32, 0.5 / 32, 0.5 / 32);
  const auto data = read(twoMaterials(
    boxGrid(32, 32, 32), [&](const Vector& p) { return (p - home).norm() < 1e-6 ? 0.0 : 1.0; }, field));
  EXPECT_EQ(valueAt(*data, rod, Vector(1, 1, 1), false, Vector(0.03, 0.03, 0.03)), 7.0);
  EXPECT_EQ(valueAt(*data, rod, Vector(1, 1, 1), false, Vector(0.9, 0.9, 0.9)), 7.0);
  EXPECT_EQ(valueAt(*data, rod, Vector(1, 1, 1), false, Vector(0.9, 0.9, 0.9), GhostMethod::Constant), 7.0);
}

TEST(RectilinearData, ContinuesALinearFieldWhoseNearestSamplesAreAFewCellsAway)
{
  // The interface's closest point is at the corner of the box, three cells from the rod's first sample.
  std::mt19937 random(3);
  const Function field = randomLinear(random);
  const auto data = read(twoMaterials(
    boxGrid(16, 16, 16), [](const Vector& p) { return p.y() - p.x() - p.z() < 0.15 ? 1.0 : 0.0; }, field));
  for (const double y : { 0.0, 0.01, 0.05, 0.1 })
  {
    const Vector point(0.0, y, 0.0);
    EXPECT_NEAR(valueAt(*data, rod, point, false, Vector(0.0, 0.1, 0.0)), field(rod, point), 1e-10) << y;
    EXPECT_NEAR(valueAt(*data, rod, point, false, point), field(rod, point), 1e-10) << y;
  }
}

TEST(LinearFit, ToOneSampleIsConstantWhateverItsOffsetAndWeight)
{
  std::mt19937 random(1);
  for (int trial = 0; trial < 1000; ++trial)
  {
    FitSamples samples;
    samples.add(0, 3.0 * randomPoint(random, -1.0, 1.0), randomPoint(random, 0.01, 1.0).x());
    // The same sample twice is no more.
    samples.add(0, samples.offsets[0], randomPoint(random, 0.01, 1.0).y());
    for (const int count : { 1, 2 })
    {
      samples.count = count;
      const LinearFit fit(samples);
      EXPECT_EQ(0, fit.rank());
      std::array<double, 2> coefficients{};
      fit.coefficients(samples, randomPoint(random, -3.0, 3.0), coefficients.data());
      EXPECT_NEAR(1.0, coefficients[0] + coefficients[1], 1e-12);
      EXPECT_GE(coefficients[0], 0.0);
    }
  }
}

TEST(RectilinearData, HasNoValueForAMaterialWithoutSamples)
{
  const auto data = read(twoMaterials(
    boxGrid(4, 4, 4), [](const Vector&) { return 1.0; }, [](MaterialId, const Vector&) { return 1.0; }));
  for (const GhostMethod method : methods)
  {
    EXPECT_TRUE(std::isnan(valueAt(*data, rod, Vector(0.5, 0.5, 0.5), false, Vector(0.1, 0.1, 0.1), method)));
  }
}

TEST(RectilinearData, WorksOnAGridOneCellThick)
{
  std::mt19937 random(3);
  const Function field = [](MaterialId m, const Vector& p) { return m.value + p.x() - 2.0 * p.y(); };
  const auto data = read(twoMaterials(boxGrid(8, 8, 1), leftHalf, field));
  for (int i = 0; i < 100; ++i)
  {
    const Vector point = randomPoint(random);
    for (const MaterialId m : { block, rod })
    {
      const bool inside = (m == block) == (point.x() < 0.5);
      EXPECT_NEAR(valueAt(*data, m, point, inside, Vector(0.5, point.y(), point.z())), field(m, point), 1e-10);
    }
  }
}

TEST(RectilinearData, ApproachesTheSamplesValueBesideTheInterface)
{
  std::mt19937 random(8);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const Function noise = [&](MaterialId, const Vector&) { return number(random); };
  const auto data = read(twoMaterials(boxGrid(6, 7, 5), outsideBall, noise));
  for (SampleIndex sample = 0; sample < data->sampleCount(); ++sample)
  {
    for (const MaterialId m : materialsOf(*data, sample))
    {
      const Vector near = positionOf(*data, sample) + 1e-5 * randomPoint(random, -1.0, 1.0);
      EXPECT_NEAR(valueAt(*data, m, near), sampleValue(*data, FieldId(0), m, sample), 1e-2);
    }
  }
}

TEST(RectilinearData, InterpolatesMultilinearlyWhereAllSamplesRoundThePointCount)
{
  // Without an interface, a product of linear functions is its own multilinear interpolation.
  const Function field = [](MaterialId, const Vector& p) { return (1.0 + p.x()) * (2.0 - p.y()) * (0.5 + p.z()); };
  const auto data = read(twoMaterials(
    boxGrid(5, 4, 3, 1.2), [](const Vector&) { return 1.0; }, field));
  std::mt19937 random(9);
  for (int i = 0; i < 100; ++i)
  {
    const Vector point = randomPoint(random);
    EXPECT_NEAR(valueAt(*data, block, point), field(block, point), 1e-12);
  }
}

TEST(RectilinearData, IgnoresTheOtherMaterialsValues)
{
  const Function one = [](MaterialId m, const Vector& p) { return m == block ? p.x() : 0.0; };
  const Function other = [](MaterialId m, const Vector& p) { return m == block ? p.x() : 1e6 * p.y(); };
  const auto first = read(twoMaterials(boxGrid(8, 8, 8), outsideBall, one));
  const auto second = read(twoMaterials(boxGrid(8, 8, 8), outsideBall, other));
  std::mt19937 random(10);
  for (int i = 0; i < 200; ++i)
  {
    const Vector point = randomPoint(random);
    const Vector closest = closestOnBall(point);
    for (const GhostMethod method : methods)
    {
      EXPECT_EQ(
        valueAt(*first, block, point, false, closest, method), valueAt(*second, block, point, false, closest, method));
    }
  }
}

TEST(RectilinearData, ContinuesTheFieldOfCompleteCellsThroughTheirFaces)
{
  // Curved, so that a linear fit differs from the multilinear interpolation.
  const Function field = [](MaterialId, const Vector& p) { return p.x() * p.x() + 2.0 * p.y() * p.z(); };
  const auto data = read(twoMaterials(boxGrid(8, 8, 8), outsideBall, field));
  int faces = 0;
  for (NativeCellIndex cell = 0; cell < data->nativeCellCount(); ++cell)
  {
    const NativeCell element = data->nativeCell(cell);
    if (!element.materials.contains(block))
    {
      continue;
    }
    // A point of each face and one just beyond it.
    const Vector size = element.corners[7] - element.corners[0];
    for (int axis = 0; axis < 3; ++axis)
    {
      Vector on = element.corners[0] + 0.37 * size;
      on[axis] = element.corners[7][axis];
      Vector beyond = on;
      beyond[axis] += 1e-9 * size[axis];
      EXPECT_NEAR(valueAt(*data, block, on), valueAt(*data, block, beyond), 1e-7);
      ++faces;
    }
  }
  EXPECT_GT(faces, 300);
}

TEST(RectilinearData, HasACellBetweenEveryEightSamplesThatCountsWhereAllOfThemDo)
{
  for (const Association association : { Association::Cells, Association::Points })
  {
    const Function zero = [](MaterialId, const Vector&) { return 0.0; };
    const auto data = read(twoMaterials(boxGrid(4, 3, 5, 1.1), leftHalf, zero, association));
    const int less = association == Association::Cells ? 1 : 0;
    ASSERT_EQ(static_cast<NativeCellIndex>((4 - less) * (3 - less) * (5 - less)), data->nativeCellCount());
    for (NativeCellIndex cell = 0; cell < data->nativeCellCount(); ++cell)
    {
      const NativeCell element = data->nativeCell(cell);
      Box box;
      data->nativeCellBoxes(&cell, 1, &box);
      MaterialSet common = materialsOf(*data, element.samples[0]);
      for (std::size_t i = 0; i < 8; ++i)
      {
        EXPECT_EQ(positionOf(*data, element.samples[i]), element.corners[i]);
        for (int axis = 0; axis < 3; ++axis)
        {
          EXPECT_EQ(((i >> axis) & 1) != 0 ? box.upper[axis] : box.lower[axis], element.corners[i][axis]);
        }
        common = common & materialsOf(*data, element.samples[i]);
      }
      EXPECT_EQ(common, element.materials);
    }
  }
}
