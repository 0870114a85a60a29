#include "Support/RandomRegions.h"

#include "Model/Errors.h"
#include "Pieces/Pieces.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <map>

using namespace strata;
using namespace strata::test;

namespace
{
Vector pointOf(const Buffer<double>& points, Index point)
{
  return { points[3 * point], points[3 * point + 1], points[3 * point + 2] };
}

double volume(const Buffer<double>& points, const std::int64_t* corners)
{
  const Vector origin = pointOf(points, corners[0]);
  return (pointOf(points, corners[1]) - origin)
           .cross(pointOf(points, corners[2]) - origin)
           .dot(pointOf(points, corners[3]) - origin) /
         6.0;
}

Pieces allPieces(const Mesh& mesh)
{
  Progress progress;
  return cutPieces(view(mesh), allMaterials(mesh), progress);
}

RandomDistances kind(unsigned seed)
{
  return seed % 2 ? RandomDistances::Ties : RandomDistances::Reals;
}
}

TEST(CutPieces, FillEveryCellExactly)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    const Mesh mesh = randomRegions(2, 1 + seed % 6, kind(seed), seed);
    const Pieces pieces = allPieces(mesh);
    std::vector<double> filled(static_cast<std::size_t>(mesh.cellCount()), 0.0);
    for (Index piece = 0; piece < pieces.material.size(); ++piece)
    {
      const double part = volume(pieces.points, &pieces.tetrahedra[4 * piece]);
      ASSERT_GT(part, 0.0);
      filled[pieces.cell[piece]] += part;
    }
    for (Index cell = 0; cell < mesh.cellCount(); ++cell)
    {
      const double whole = volume(mesh.points, &mesh.tetrahedra[4 * cell]);
      ASSERT_NEAR(filled[cell], whole, 1e-12 * whole) << "seed " << seed;
    }
  }
}

TEST(CutPieces, LieWhereTheirMaterialIsNearest)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const int materials = 2 + seed % 4;
    const Mesh mesh = randomRegions(2, materials, kind(seed), seed);
    const Pieces pieces = allPieces(mesh);
    for (Index piece = 0; piece < pieces.material.size(); ++piece)
    {
      for (int corner = 0; corner < 4; ++corner)
      {
        const Index point = pieces.tetrahedra[4 * piece + corner];
        const float own = pieces.distances[pieces.material[piece]][point];
        for (int m = 0; m < materials; ++m)
        {
          ASSERT_LE(own, pieces.distances[m][point] + 1e-6f);
        }
      }
    }
  }
}

TEST(CutPieces, FaceEachOtherOneToOne)
{
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    // Reals: with ties, pieces without volume are left out.
    const Mesh mesh = randomRegions(2, 1 + seed % 5, RandomDistances::Reals, seed);
    const Pieces pieces = allPieces(mesh);
    // Faces by position, since points aren't shared across materials.
    std::map<std::array<double, 9>, int> uses;
    for (Index piece = 0; piece < pieces.material.size(); ++piece)
    {
      for (int omitted = 0; omitted < 4; ++omitted)
      {
        std::array<std::array<double, 3>, 3> face;
        for (int corner = 0, to = 0; corner < 4; ++corner)
        {
          if (corner != omitted)
          {
            const Vector p = pointOf(pieces.points, pieces.tetrahedra[4 * piece + corner]);
            face[to++] = { p[0], p[1], p[2] };
          }
        }
        std::sort(face.begin(), face.end());
        ++uses[{
          face[0][0], face[0][1], face[0][2], face[1][0], face[1][1], face[1][2], face[2][0], face[2][1], face[2][2] }];
      }
    }
    for (const auto& use : uses)
    {
      const std::array<double, 9>& f = use.first;
      bool onSide = false;
      for (int axis = 0; axis < 3; ++axis)
      {
        onSide = onSide || (f[axis] == 0.0 && f[axis + 3] == 0.0 && f[axis + 6] == 0.0) ||
                 (f[axis] == 1.0 && f[axis + 3] == 1.0 && f[axis + 6] == 1.0);
      }
      ASSERT_EQ(use.second, onSide ? 1 : 2) << "seed " << seed;
    }
  }
}

TEST(CutPieces, ACellOfOneMaterialPassesAsItIs)
{
  const int n = 4;
  Box box;
  box.add(Vector(0, 0, 0));
  box.add(Vector(1, 1, 1));
  Mesh mesh = kuhnMesh(box, n, { { "left", true }, { "right", true } }, {});
  setTwoMaterials(mesh, MaterialId(0), MaterialId(1), [](const Vector& p) { return 0.375 - p[0]; });
  const Pieces pieces = allPieces(mesh);
  double left = 0.0;
  std::map<Index, int> count;
  for (Index piece = 0; piece < pieces.material.size(); ++piece)
  {
    left += pieces.material[piece] == 0 ? volume(pieces.points, &pieces.tetrahedra[4 * piece]) : 0.0;
    ++count[pieces.cell[piece]];
  }
  EXPECT_NEAR(left, 0.375, 1e-7); // distances are floats
  for (Index cell = 0; cell < mesh.cellCount(); ++cell)
  {
    double least = 1.0;
    double most = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const double x = mesh.points[3 * mesh.tetrahedra[4 * cell + corner]];
      least = std::min(least, x);
      most = std::max(most, x);
    }
    const bool cut = least < 0.375 && most > 0.375;
    EXPECT_EQ(count[cell] == 1, !cut);
  }
}

TEST(CutPieces, CarryTheFieldsOfTheirMaterial)
{
  const int materials = 4;
  const Mesh mesh = randomRegions(2, materials, RandomDistances::Reals, 3);
  const Pieces pieces = allPieces(mesh);
  for (Index piece = 0; piece < pieces.material.size(); ++piece)
  {
    for (int corner = 0; corner < 4; ++corner)
    {
      const Index point = pieces.tetrahedra[4 * piece + corner];
      const Vector p = pointOf(pieces.points, point);
      const int m = pieces.material[piece];
      if (m + 1 == materials)
      {
        ASSERT_TRUE(std::isnan(pieces.values[0][point]));
        continue;
      }
      ASSERT_NEAR(pieces.values[0][point], 10.0 * m + p[0] - 2.0 * p[1] + 3.0 * p[2], 1e-5);
      ASSERT_NEAR(pieces.values[1][3 * point + 2], p[2] - m, 1e-6);
    }
  }
}

TEST(CutPieces, ShareEachPointWithinAMaterialOnly)
{
  const Mesh mesh = randomRegions(3, 3, RandomDistances::Reals, 3);
  const Pieces pieces = allPieces(mesh);
  std::vector<std::int32_t> owner(static_cast<std::size_t>(pieces.points.size() / 3), -1);
  for (Index corner = 0; corner < pieces.tetrahedra.size(); ++corner)
  {
    std::int32_t& of = owner[pieces.tetrahedra[corner]];
    ASSERT_TRUE(of < 0 || of == pieces.material[corner / 4]);
    of = pieces.material[corner / 4];
  }
  std::map<std::array<double, 4>, int> places;
  for (std::size_t point = 0; point < owner.size(); ++point)
  {
    const Vector p = pointOf(pieces.points, static_cast<Index>(point));
    ASSERT_GE(owner[point], 0) << "a point that no piece uses";
    ++places[{ p[0], p[1], p[2], static_cast<double>(owner[point]) }];
  }
  EXPECT_EQ(places.size(), owner.size());
}

TEST(CutPieces, OfChosenMaterialsAreThoseAmongAllPieces)
{
  const Mesh mesh = randomRegions(2, 4, RandomDistances::Reals, 3);
  const Pieces all = allPieces(mesh);
  Progress progress;
  const Pieces chosen = cutPieces(view(mesh), MaterialSet::of(MaterialId(2)), progress);
  Index expected = 0;
  for (const std::int32_t m : all.material)
  {
    expected += m == 2 ? 1 : 0;
  }
  EXPECT_EQ(chosen.material.size(), expected);
  EXPECT_TRUE(std::all_of(chosen.material.begin(), chosen.material.end(), [](std::int32_t m) { return m == 2; }));
}

TEST(CutPieces, AreTheSameForAnyNumberOfThreads)
{
  const Mesh mesh = randomRegions(8, 4, RandomDistances::Ties, 3);
  const Pieces two = allPieces(mesh);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Pieces single = allPieces(mesh);
  EXPECT_EQ(copyOf(two.points), copyOf(single.points));
  EXPECT_EQ(copyOf(two.tetrahedra), copyOf(single.tetrahedra));
  EXPECT_EQ(copyOf(two.material), copyOf(single.material));
  EXPECT_EQ(copyOf(two.cell), copyOf(single.cell));
}

TEST(CutPieces, AnEmptyMeshHasNone)
{
  Progress progress;
  const Pieces pieces = cutPieces(Representation(), MaterialSet(), progress);
  EXPECT_EQ(pieces.material.size(), 0);
  EXPECT_EQ(pieces.points.size(), 0);
}
