#include "Core/Geometry/CutSupport.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace strata;
using namespace strata::testing;

namespace
{
const std::array<std::int64_t, 4> plainVertices{ 0, 1, 2, 3 };

double valueAt(const CutPoint& point, const VertexValues& values, int function)
{
  return point.interpolate([&](std::int64_t vertex) { return values[vertex][function]; });
}

/// Runs `check(cut, values, vertices)` on many random tetrahedra.
template<typename Check>
void onRandomTetrahedra(int count, const Check& check)
{
  std::mt19937 random(7);
  TetrahedronCut cut;
  for (int i = 0; i < count; ++i)
  {
    const int functions = 1 + i % 6;
    const Draw draw = drawOf(i / 6);
    const VertexValues values = randomValues(4, functions, draw, random);
    std::array<std::int64_t, 4> vertices = plainVertices;
    std::shuffle(vertices.begin(), vertices.end(), random);
    const std::vector<CornerValues> corners = valuesAt(values, vertices);
    cut.cut(vertices, corners.data(), functions);
    check(cut, values, vertices);
    if (::testing::Test::HasFailure())
    {
      FAIL() << "case " << i;
    }
  }
}
}

TEST(CutTetrahedron, OneFunctionKeepsTheWholeTetrahedron)
{
  const CornerValues function{ 5, { 3.0, -1.0, 0.0, 2.0 } };
  TetrahedronCut cut;
  cut.cut({ 17, 3, 9, 4 }, &function, 1);
  EXPECT_EQ(cut.winners(), std::vector<int>{ 5 });
  EXPECT_EQ(cut.points().size(), 4u);
  ASSERT_EQ(cut.faces().size(), 4u);
  for (const TetrahedronCut::Face& face : cut.faces())
  {
    EXPECT_LT(face.beyond, 0);
    EXPECT_EQ(face.end - face.begin, 3);
  }
}

TEST(CutTetrahedron, FacesAreNumberedByTheGivenCornersAndPointOutward)
{
  const std::array<Vector, 4> corners{ Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1) };
  std::array<int, 4> order{ 0, 1, 2, 3 };
  TetrahedronCut cut;
  do
  {
    // Global ids in any order; the given corners stay positively oriented.
    const std::array<std::int64_t, 4> vertices{ order[0], order[1], order[2], order[3] };
    const std::array<CornerValues, 2> functions{ CornerValues{ 0, { -1, 1, 1, 1 } }, CornerValues{ 1, {} } };
    cut.cut(vertices, functions.data(), 2);
    const auto position = [&](int point) -> Vector {
      return cut.points()[point].interpolate([&](std::int64_t vertex) -> Vector {
        return corners[std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin()];
      });
    };
    for (const TetrahedronCut::Face& face : cut.faces())
    {
      const int* loop = cut.loops().data() + face.begin;
      const Vector normal = (position(loop[1]) - position(loop[0])).cross(position(loop[2]) - position(loop[0]));
      Vector outward = Vector::Ones();
      if (face.beyond < 0)
      {
        const int opposite = -1 - face.beyond;
        outward = opposite == 0 ? Vector(1, 1, 1) : Vector(-Vector::Unit(opposite - 1));
        EXPECT_NEAR(outward.dot(position(loop[0])), opposite == 0 ? 1.0 : 0.0, 1e-15);
      }
      else if (face.function == 1)
      {
        outward = -outward;
      }
      EXPECT_GT(normal.dot(outward), 0.1);
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(CutTetrahedron, TiesGoToTheLowestFunction)
{
  const std::array<CornerValues, 3> functions{ CornerValues{ 2, { 1, 1, 1, 1 } }, CornerValues{ 4, { 1, 1, 1, 1 } },
    CornerValues{ 9, { 1, 1, 1, 1 } } };
  TetrahedronCut cut;
  cut.cut(plainVertices, functions.data(), 3);
  EXPECT_EQ(cut.winners(), std::vector<int>{ 2 });
}

TEST(CutTetrahedron, AnInterfaceInAFaceAppearsOnceInThatFace)
{
  // Equal on the face of corners 0, 1, 2; the second function is smaller at corner 3.
  const std::array<CornerValues, 2> functions{ CornerValues{ 0, { 0, 0, 0, 1 } }, CornerValues{ 1, { 0, 0, 0, 0 } } };
  TetrahedronCut cut;
  cut.cut(plainVertices, functions.data(), 2);
  // The region of function 0 is the face alone: a lens without volume whose sides both stay.
  KeyLoop interface;
  for (const TetrahedronCut::Face& face : cut.faces())
  {
    EXPECT_EQ(face.end - face.begin, 3);
    if (face.isInterface())
    {
      interface = loopOf(cut, face);
    }
  }
  ASSERT_EQ(interface.size(), 3u);
  EXPECT_EQ(interface[2].vertices[0] + interface[1].vertices[0] + interface[0].vertices[0], 0 + 1 + 2);
}

TEST(CutTetrahedron, FourFunctionsMeetInTheCentre)
{
  std::array<CornerValues, 4> functions;
  for (int f = 0; f < 4; ++f)
  {
    functions[f].function = f;
    functions[f].values[f] = -1.0;
  }
  TetrahedronCut cut;
  cut.cut(plainVertices, functions.data(), 4);
  const auto inside =
    std::find_if(cut.points().begin(), cut.points().end(), [](const CutPoint& point) { return point.carriers() == 4; });
  ASSERT_NE(inside, cut.points().end());
  for (double weight : inside->weights)
  {
    EXPECT_DOUBLE_EQ(weight, 0.25);
  }
  // 4 corners, 6 edge points, 4 face points, 1 inside.
  EXPECT_EQ(cut.points().size(), 15u);
}

TEST(CutTetrahedron, EveryPointOfARegionHasItsFunctionSmallest)
{
  onRandomTetrahedra(40000, [](const TetrahedronCut& cut, const VertexValues& values, const auto&) {
    for (const TetrahedronCut::Face& face : cut.faces())
    {
      for (int i = face.begin; i < face.end; ++i)
      {
        const CutPoint& point = cut.points()[cut.loops()[i]];
        const double own = valueAt(point, values, face.function);
        for (std::size_t f = 0; f < values.front().size(); ++f)
        {
          EXPECT_LE(own, valueAt(point, values, static_cast<int>(f)) + 1e-10);
        }
        if (face.beyond >= 0)
        {
          EXPECT_NEAR(own, valueAt(point, values, face.beyond), 1e-10);
        }
      }
    }
  });
}

TEST(CutTetrahedron, EveryRegionIsClosedAndInterfacesMatchFromBothSides)
{
  onRandomTetrahedra(40000, [](const TetrahedronCut& cut, const VertexValues&, const auto&) {
    std::map<int, EdgeBalance> regions;
    EdgeBalance interfaces;
    for (const TetrahedronCut::Face& face : cut.faces())
    {
      regions[face.function].add(loopOf(cut, face));
    }
    for (const auto& region : regions)
    {
      EXPECT_TRUE(region.second.closed()) << "function " << region.first;
    }
    std::map<std::pair<int, int>, EdgeBalance> pairs;
    for (const TetrahedronCut::Face& face : cut.faces())
    {
      if (face.beyond >= 0)
      {
        pairs[std::minmax(face.function, face.beyond)].add(loopOf(cut, face));
      }
    }
    for (const auto& pair : pairs)
    {
      EXPECT_TRUE(pair.second.closed());
    }
  });
}

TEST(CutTetrahedron, PointsWithDifferentNamesAreDifferentPoints)
{
  std::mt19937 random(3);
  TetrahedronCut cut;
  for (int i = 0; i < 40000; ++i)
  {
    // Small integers: coordinates are fractions with small denominators, so different points are far apart.
    const VertexValues values = randomValues(4, 2 + i % 5, Draw::Ties, random);
    const std::vector<CornerValues> corners = valuesAt(values, plainVertices);
    cut.cut(plainVertices, corners.data(), static_cast<int>(corners.size()));
    for (std::size_t a = 0; a < cut.points().size(); ++a)
    {
      for (std::size_t b = 0; b < a; ++b)
      {
        double distance = 0.0;
        for (int corner = 0; corner < 4; ++corner)
        {
          distance += std::abs(cut.coordinates()[a][corner] - cut.coordinates()[b][corner]);
        }
        ASSERT_GT(distance, 1e-6) << "case " << i;
      }
    }
  }
}

TEST(CutTetrahedron, TetrahedraCutTheirSharedFaceAlikeBitForBit)
{
  std::mt19937 random(11);
  TetrahedronCut first;
  TetrahedronCut second;
  for (int i = 0; i < 40000; ++i)
  {
    const VertexValues values = randomValues(5, 2 + i % 5, drawOf(i / 5), random);
    std::array<std::int64_t, 5> ids{ 0, 1, 2, 3, 4 };
    std::shuffle(ids.begin(), ids.end(), random);
    // Both share ids[0..2]; on opposite sides of it, the face is opposite to corner 3 and to corner 0.
    const std::array<std::int64_t, 4> one{ ids[0], ids[1], ids[2], ids[3] };
    const std::array<std::int64_t, 4> other{ ids[4], ids[0], ids[1], ids[2] };
    const std::vector<CornerValues> oneValues = valuesAt(values, one);
    const std::vector<CornerValues> otherValues = valuesAt(values, other);
    first.cut(one, oneValues.data(), static_cast<int>(oneValues.size()));
    second.cut(other, otherValues.data(), static_cast<int>(otherValues.size()));
    std::map<int, KeyLoop> fromFirst;
    std::map<int, KeyLoop> fromSecond;
    std::map<CutKey, std::array<double, 4>> weights;
    for (const TetrahedronCut::Face& face : first.faces())
    {
      if (face.beyond == -4)
      {
        fromFirst[face.function] = loopOf(first, face);
      }
    }
    for (const TetrahedronCut::Face& face : second.faces())
    {
      if (face.beyond == -1)
      {
        KeyLoop loop = loopOf(second, face);
        std::reverse(loop.begin() + 1, loop.end());
        fromSecond[face.function] = loop;
      }
    }
    ASSERT_EQ(fromFirst, fromSecond) << "case " << i;
    for (const CutPoint& point : first.points())
    {
      weights[point.key] = point.weights;
    }
    for (const CutPoint& point : second.points())
    {
      const auto found = weights.find(point.key);
      if (found != weights.end())
      {
        ASSERT_EQ(found->second, point.weights);
      }
    }
  }
}

TEST(CutTetrahedron, RenumberingFunctionsOnlyRenumbersGenericCuts)
{
  std::mt19937 random(5);
  TetrahedronCut cut;
  TetrahedronCut permuted;
  for (int i = 0; i < 5000; ++i)
  {
    const int count = 2 + i % 5;
    const VertexValues values = randomValues(4, count, Draw::Reals, random);
    std::vector<int> order(count);
    for (int f = 0; f < count; ++f)
    {
      order[f] = f;
    }
    std::shuffle(order.begin(), order.end(), random);
    VertexValues renumbered = values;
    for (int vertex = 0; vertex < 4; ++vertex)
    {
      for (int f = 0; f < count; ++f)
      {
        renumbered[vertex][order[f]] = values[vertex][f];
      }
    }
    cut.cut(plainVertices, valuesAt(values, plainVertices).data(), count);
    permuted.cut(plainVertices, valuesAt(renumbered, plainVertices).data(), count);
    std::map<std::pair<int, int>, int> faces;
    std::map<std::pair<int, int>, int> permutedFaces;
    for (const TetrahedronCut::Face& face : cut.faces())
    {
      faces[{ order[face.function], face.beyond < 0 ? face.beyond : order[face.beyond] }] = face.end - face.begin;
    }
    for (const TetrahedronCut::Face& face : permuted.faces())
    {
      permutedFaces[{ face.function, face.beyond }] = face.end - face.begin;
    }
    ASSERT_EQ(faces, permutedFaces) << "case " << i;
    ASSERT_EQ(cut.points().size(), permuted.points().size());
  }
}
