#include "Core/Geometry/CutSupport.h"

#include "Geometry/CutVolumes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace strata;
using namespace strata::testing;

namespace
{
const std::array<std::int64_t, 4> plainVertices{ 0, 1, 2, 3 };

/// Volumes of the cut's regions by cones over their faces from the tetrahedron's first corner.
std::vector<double> volumesOfCut(const TetrahedronCut& cut, int count)
{
  const auto position = [&](int point) {
    const std::array<double, 4>& c = cut.coordinates()[point];
    return Vector(c[1], c[2], c[3]);
  };
  std::vector<double> result(count, 0.0);
  for (const TetrahedronCut::Face& face : cut.faces())
  {
    const int* loop = cut.loops().data();
    for (int i = face.begin + 1; i + 1 < face.end; ++i)
    {
      result[face.function] += position(loop[face.begin]).dot(position(loop[i]).cross(position(loop[i + 1])));
    }
  }
  return result;
}
}

TEST(CutVolumes, HalvingTheEdgesAtACornerCutsOffAnEighth)
{
  const std::array<CornerValues, 2> functions{ CornerValues{ 0, { -1, 1, 1, 1 } }, CornerValues{ 1, {} } };
  TetrahedronCut workspace;
  std::array<double, 2> volumes;
  std::array<double, 4> derivatives;
  regionVolumesAndDerivatives(functions.data(), 2, workspace, volumes.data(), derivatives.data());
  EXPECT_DOUBLE_EQ(volumes[0], 0.125);
  EXPECT_DOUBLE_EQ(volumes[1], 0.875);
  // The volume is ((1 + c) / 2)^3 with c added to the second function.
  EXPECT_DOUBLE_EQ(derivatives[1], 0.375);
}

TEST(CutVolumes, AreThoseOfTheCutAndSumToOne)
{
  std::mt19937 random(2);
  TetrahedronCut cut;
  for (int i = 0; i < 60000; ++i)
  {
    const int count = 1 + i % 6;
    const VertexValues values = randomValues(4, count, drawOf(i / 6), random);
    const std::vector<CornerValues> corners = valuesAt(values, plainVertices);
    std::vector<double> volumes(count);
    regionVolumes(corners.data(), count, cut, volumes.data());
    ASSERT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0), 1.0, 1e-14) << "case " << i;
    cut.cut(plainVertices, corners.data(), count);
    const std::vector<double> expected = volumesOfCut(cut, count);
    for (int f = 0; f < count; ++f)
    {
      ASSERT_NEAR(volumes[f], expected[f], 1e-13) << "case " << i << " function " << f;
      ASSERT_GE(volumes[f], -1e-15);
    }
  }
}

TEST(CutVolumes, DerivativesAreDifferencesOfVolumes)
{
  std::mt19937 random(4);
  TetrahedronCut workspace;
  const double step = 1e-6;
  for (int i = 0; i < 3000; ++i)
  {
    const int count = 2 + i % 4;
    const VertexValues values = randomValues(4, count, Draw::Reals, random);
    std::vector<CornerValues> corners = valuesAt(values, plainVertices);
    std::vector<double> volumes(count);
    std::vector<double> derivatives(count * count);
    regionVolumesAndDerivatives(corners.data(), count, workspace, volumes.data(), derivatives.data());
    for (int j = 0; j < count; ++j)
    {
      std::vector<double> above(count);
      std::vector<double> below(count);
      const std::array<double, 4> original = corners[j].values;
      const auto shifted = [&](double by, std::vector<double>& result) {
        for (int corner = 0; corner < 4; ++corner)
        {
          corners[j].values[corner] = original[corner] + by;
        }
        regionVolumes(corners.data(), count, workspace, result.data());
      };
      shifted(step, above);
      shifted(-step, below);
      corners[j].values = original;
      for (int f = 0; f < count; ++f)
      {
        const double difference = (above[f] - below[f]) / (2.0 * step);
        ASSERT_NEAR(derivatives[count * f + j], difference, 1e-3 * (1.0 + std::abs(difference))) << "case " << i;
      }
    }
  }
}

TEST(CutVolumes, DerivativesAtACornerAreDifferencesOfVolumes)
{
  std::mt19937 random(6);
  TetrahedronCut workspace;
  const double step = 1e-6;
  for (int i = 0; i < 3000; ++i)
  {
    const int count = 2 + i % 4;
    const VertexValues values = randomValues(4, count, Draw::Reals, random);
    std::vector<CornerValues> corners = valuesAt(values, plainVertices);
    std::vector<double> volumes(count);
    std::vector<double> derivatives(count * count);
    regionVolumesAndCornerDerivatives(corners.data(), count, workspace, volumes.data(), derivatives.data());
    for (int j = 0; j < count; ++j)
    {
      std::vector<double> above(count);
      std::vector<double> below(count);
      corners[j].values[0] += step;
      regionVolumes(corners.data(), count, workspace, above.data());
      corners[j].values[0] -= 2.0 * step;
      regionVolumes(corners.data(), count, workspace, below.data());
      corners[j].values[0] += step;
      for (int f = 0; f < count; ++f)
      {
        const double difference = (above[f] - below[f]) / (2.0 * step);
        ASSERT_NEAR(derivatives[count * f + j], difference, 1e-3 * (1.0 + std::abs(difference))) << "case " << i;
      }
    }
  }
}
