#include "Core/Geometry/CutSupport.h"

#include "Geometry/CutPolygon.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace strata;
using namespace strata::testing;

namespace
{
const std::array<Vector, 4> corners{ Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1) };

Vector position(const CutPoint& point)
{
  return point.interpolate([](std::int64_t vertex) -> Vector { return corners[vertex]; });
}

KeyLoop loopOf(const PolygonCut& cut, const PolygonCut::Region& region)
{
  KeyLoop result;
  for (int i = region.begin; i < region.end; ++i)
  {
    result.push_back(cut.points()[cut.loops()[i]].key);
  }
  std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
  return result;
}

Vector areaVector(const PolygonCut& cut, const PolygonCut::Region& region)
{
  Vector sum = Vector::Zero();
  const Vector origin = position(cut.points()[cut.loops()[region.begin]]);
  for (int i = region.begin + 1; i + 1 < region.end; ++i)
  {
    const Vector a = position(cut.points()[cut.loops()[i]]) - origin;
    const Vector b = position(cut.points()[cut.loops()[i + 1]]) - origin;
    sum += 0.5 * a.cross(b);
  }
  return sum;
}
}

TEST(CutPolygon, TrianglesAreCutAsTheTetrahedraOnThemAre)
{
  std::mt19937 random(8);
  TetrahedronCut tetrahedron;
  PolygonCut triangle;
  for (int i = 0; i < 30000; ++i)
  {
    const VertexValues values = randomValues(4, 1 + i % 6, drawOf(i / 6), random);
    std::array<std::int64_t, 4> vertices{ 0, 1, 2, 3 };
    std::shuffle(vertices.begin(), vertices.end(), random);
    const std::vector<CornerValues> all = valuesAt(values, vertices);
    const int count = static_cast<int>(all.size());
    tetrahedron.cut(vertices, all.data(), count);
    // The face opposite to corner 3, seen from outside.
    const std::array<std::int64_t, 3> face{ vertices[0], vertices[2], vertices[1] };
    triangle.cutTriangle(face, valuesAt(values, { face[0], face[1], face[2], vertices[3] }).data(), count);
    std::map<int, KeyLoop> expected;
    std::map<int, KeyLoop> found;
    for (const TetrahedronCut::Face& region : tetrahedron.faces())
    {
      if (region.beyond == -4)
      {
        expected[region.function] = strata::testing::loopOf(tetrahedron, region);
      }
    }
    for (const PolygonCut::Region& region : triangle.regions())
    {
      found[region.function] = loopOf(triangle, region);
    }
    ASSERT_EQ(found, expected) << "case " << i;
  }
}

TEST(CutPolygon, SectionsFillThePlaneWithConvexPolygonsTurnedToItsPositiveSide)
{
  std::mt19937 random(9);
  PolygonCut cut;
  for (int i = 0; i < 60000; ++i)
  {
    const Draw draw = drawOf(i / 6);
    const VertexValues values = randomValues(4, 1 + i % 6, draw, random);
    const VertexValues plane = randomValues(4, 1, draw, random);
    std::array<std::int64_t, 4> vertices{ 0, 1, 2, 3 };
    const int swaps = i % 2;
    std::shuffle(vertices.begin() + swaps, vertices.end(), random);
    // Keep the orientation positive.
    const Vector a = corners[vertices[1]] - corners[vertices[0]];
    const Vector b = corners[vertices[2]] - corners[vertices[0]];
    if (a.cross(b).dot(corners[vertices[3]] - corners[vertices[0]]) < 0.0)
    {
      std::swap(vertices[2], vertices[3]);
    }
    const std::vector<CornerValues> all = valuesAt(values, vertices);
    std::array<double, 4> planeValues;
    for (int corner = 0; corner < 4; ++corner)
    {
      planeValues[corner] = plane[vertices[corner]][0];
    }
    cut.cutSection(vertices, planeValues, all.data(), 1);
    const Vector whole = cut.regions().empty() ? Vector(Vector::Zero()) : areaVector(cut, cut.regions().front());
    const Vector gradient(plane[1][0] - plane[0][0], plane[2][0] - plane[0][0], plane[3][0] - plane[0][0]);
    cut.cutSection(vertices, planeValues, all.data(), static_cast<int>(all.size()));
    Vector sum = Vector::Zero();
    for (const PolygonCut::Region& region : cut.regions())
    {
      const Vector area = areaVector(cut, region);
      ASSERT_GE(area.dot(gradient), -1e-14) << "case " << i;
      sum += area;
      for (int p = region.begin; p < region.end; ++p)
      {
        const CutPoint& point = cut.points()[cut.loops()[p]];
        const auto at = [&](int f) { return point.interpolate([&](std::int64_t v) { return values[v][f]; }); };
        ASSERT_NEAR(point.interpolate([&](std::int64_t v) { return plane[v][0]; }), 0.0, 1e-10);
        for (std::size_t f = 0; f < all.size(); ++f)
        {
          ASSERT_LE(at(region.function), at(static_cast<int>(f)) + 1e-9) << "case " << i;
        }
      }
    }
    ASSERT_LT((sum - whole).norm(), 1e-13) << "case " << i;
    ASSERT_LT(whole.cross(gradient).norm(), 1e-13 * (1.0 + gradient.norm()));
  }
}

TEST(CutPolygon, APlaneThroughAFaceIsCutOutOfTheNegativeSideOnly)
{
  const CornerValues function{ 0, { 1, 1, 1, 1 } };
  PolygonCut cut;
  cut.cutSection({ 0, 1, 2, 3 }, { 0, 0, 0, -1 }, &function, 1);
  ASSERT_EQ(cut.regions().size(), 1u);
  EXPECT_DOUBLE_EQ(areaVector(cut, cut.regions().front()).norm(), 0.5);
  cut.cutSection({ 0, 1, 2, 3 }, { 0, 0, 0, 1 }, &function, 1);
  EXPECT_TRUE(cut.regions().empty());
  // A plane that touches an edge or a corner leaves nothing on either side.
  cut.cutSection({ 0, 1, 2, 3 }, { 0, 0, -1, -1 }, &function, 1);
  EXPECT_TRUE(cut.regions().empty());
  cut.cutSection({ 0, 1, 2, 3 }, { 0, -1, -1, -1 }, &function, 1);
  EXPECT_TRUE(cut.regions().empty());
}

TEST(CutPolygon, SectionsOfNeighboursShareTheirEndsBitForBit)
{
  std::mt19937 random(12);
  PolygonCut first;
  PolygonCut second;
  for (int i = 0; i < 30000; ++i)
  {
    const Draw draw = drawOf(i / 6);
    const VertexValues values = randomValues(5, 2 + i % 4, draw, random);
    const VertexValues plane = randomValues(5, 1, draw, random);
    std::array<std::int64_t, 5> ids{ 0, 1, 2, 3, 4 };
    std::shuffle(ids.begin(), ids.end(), random);
    EdgeBalance balance;
    std::map<CutKey, std::array<double, 4>> weights;
    const auto add = [&](PolygonCut& cut, const std::array<std::int64_t, 4>& vertices) {
      const std::vector<CornerValues> all = valuesAt(values, vertices);
      std::array<double, 4> planeValues;
      for (int corner = 0; corner < 4; ++corner)
      {
        planeValues[corner] = plane[vertices[corner]][0];
      }
      cut.cutSection(vertices, planeValues, all.data(), static_cast<int>(all.size()));
      for (const PolygonCut::Region& region : cut.regions())
      {
        KeyLoop loop = loopOf(cut, region);
        for (std::size_t k = 0; k < loop.size(); ++k)
        {
          const CutKey& a = loop[k];
          const CutKey& b = loop[(k + 1) % loop.size()];
          const auto shared = [&](const CutKey& key) {
            return std::all_of(key.vertices.begin(), key.vertices.end(),
              [&](std::int64_t v) { return v < 0 || (v != ids[3] && v != ids[4]); });
          };
          if (shared(a) && shared(b))
          {
            balance.add({ a, b }, false);
          }
        }
      }
      for (const CutPoint& point : cut.points())
      {
        const auto known = weights.emplace(point.key, point.weights).first;
        ASSERT_EQ(known->second, point.weights);
      }
    };
    // Equal orientation relative to the shared face on opposite sides of it.
    add(first, { ids[0], ids[1], ids[2], ids[3] });
    add(second, { ids[0], ids[2], ids[1], ids[4] });
    const int zeros =
      static_cast<int>(std::count_if(ids.begin(), ids.begin() + 3, [&](std::int64_t v) { return plane[v][0] == 0.0; }));
    // Where the plane holds an edge of the face, the neighbour across it may be a third tetrahedron. Otherwise the ends
    // of all polygons cancel; a polygon that collapses into the face leaves its end to a tying function.
    ASSERT_TRUE(zeros >= 2 || balance.closed()) << "case " << i;
  }
}
