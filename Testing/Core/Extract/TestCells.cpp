#include "ExtractCases.h"

#include "Octrees.h"
#include "PolyhedralGrids.h"

using namespace strata;
using namespace strata::test;

namespace
{
const Box unitBox{ Vector::Zero(), Vector::Ones() };

/// The same cells as hexahedra with repeated corners, as meshers write them. `order` maps the hexahedron's corners.
UnstructuredGrid asDegenerateHexahedra(const UnstructuredGrid& mesh, const std::vector<int>& order)
{
  UnstructuredGrid result;
  result.points = mesh.points;
  result.cornerOffsets = { 0 };
  for (Index cell = 0; cell < mesh.cellCount(); ++cell)
  {
    for (int corner : order)
    {
      result.corners.push_back(mesh.corners[mesh.cornerOffsets[cell] + corner]);
    }
    result.shapes.push_back(CellShape::Hexahedron);
    result.cornerOffsets.push_back(static_cast<Index>(result.corners.size()));
  }
  return result;
}

void expectEqualSurfaces(const UnstructuredGrid& mesh, const UnstructuredGrid& degenerate)
{
  Simulation simulation = sampledSimulation(mesh, sphere({ 0.45, 0.5, 0.55 }, 0.33));
  const ExtractedInterfaces a = extract(simulation);
  simulation.grid.emplace<UnstructuredGrid>(degenerate);
  const ExtractedInterfaces b = extract(simulation);
  expectSound(b.interfaces, 2, unitBox);
  EXPECT_TRUE(b.warnings.empty());
  EXPECT_EQ(a.interfaces.triangleCount(), b.interfaces.triangleCount());
  ASSERT_EQ(a.interfaces.points.size(), b.interfaces.points.size());
  EXPECT_NEAR(a.volumes[0].given, b.volumes[0].given, 1e-12);
  EXPECT_NEAR(b.volumes[0].reconstructed, b.volumes[0].given, 1e-6);
}
}

TEST(Cells, HexahedraWithRepeatedCornersAreTheWedgesTheyCollapseTo)
{
  expectEqualSurfaces(wedges(5), asDegenerateHexahedra(wedges(5), { 0, 1, 2, 2, 3, 4, 5, 5 }));
}

TEST(Cells, HexahedraWithRepeatedCornersAreThePyramidsTheyCollapseTo)
{
  expectEqualSurfaces(pyramids(4), asDegenerateHexahedra(pyramids(4), { 0, 1, 2, 3, 4, 4, 4, 4 }));
}

TEST(Cells, HexahedraWithRepeatedCornersAreTheTetrahedraTheyCollapseTo)
{
  expectEqualSurfaces(tetrahedra(4), asDegenerateHexahedra(tetrahedra(4), { 0, 1, 2, 2, 3, 3, 3, 3 }));
}

TEST(Cells, CellsThatAreNoPolyhedraAreLeftOutWithAWarning)
{
  UnstructuredGrid mesh = polyhedra(6);
  const Distance distance = sphere({ 0.5, 0.5, 0.5 }, 0.3);
  // Two cells at opposite corners of the cube, away from the sphere: one loses a face, one all its corners but two.
  mesh.faceCorners[3] = mesh.faceCorners[2];
  mesh.faceCorners[2] = mesh.faceCorners[1];
  Simulation simulation = sampledSimulation(mesh, distance);
  for (Index f = mesh.faceOffsets[215]; f < mesh.faceOffsets[216]; ++f)
  {
    for (Index i = mesh.faceStart[f]; i < mesh.faceStart[f + 1]; ++i)
    {
      mesh.faceCorners[i] = mesh.faceCorners[mesh.faceStart[f]];
    }
  }
  simulation.grid.emplace<UnstructuredGrid>(mesh);
  const ExtractedInterfaces result = extract(simulation);
  expectSound(result.interfaces, 2, unitBox);
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_EQ(result.warnings[0], "Cell 0 and 1 others are no closed polyhedra: left out");
  EXPECT_NEAR(result.volumes[0].reconstructed, result.volumes[0].given, 1e-6);
  EXPECT_NEAR(result.volumes[0].given + result.volumes[1].given, 214.0 / 216.0, 1e-12);
}

TEST(Cells, AQuadrangleAgainstTwoTrianglesConforms)
{
  // The cube has the triangles' corners, but not these faces.
  UnstructuredGrid mesh = asHexahedra(cubeGrid(1));
  mesh.points.emplace_back(0.5, 0.5, 2.0);
  for (Index corner : { 4, 5, 7, 8, 4, 7, 6, 8 })
  {
    mesh.corners.push_back(corner);
  }
  for (int i = 0; i < 2; ++i)
  {
    mesh.shapes.push_back(CellShape::Tetrahedron);
    mesh.cornerOffsets.push_back(mesh.cornerOffsets.back() + 4);
  }
  Simulation simulation;
  simulation.grid.emplace<UnstructuredGrid>(mesh);
  simulation.materials = namedMaterials(3);
  simulation.materials[2] = { "outside", false };
  simulation.fractions = { ownedArray({ 0.6, 0.5, 0.4 }), ownedArray({ 0.4, 0.5, 0.6 }), ownedArray({ 0, 0, 0 }) };
  const ExtractedInterfaces result = extract(simulation);
  EXPECT_TRUE(result.warnings.empty());
  expectSound(result.interfaces, 3, bounds(simulation.grid));
}

TEST(Cells, AFaceCoveredInPartIsJoinedThere)
{
  // A coarse layer below a fine one that lacks some cells.
  Octree tree = makeOctree(2, 4, 1, [](const Box& box, int) { return box.center()[2] > 0.5; });
  tree.grid.hidden.assign(tree.boxes.size(), 0);
  double volume = 0.0;
  for (std::size_t cell = 0; cell < tree.boxes.size(); ++cell)
  {
    const Vector c = tree.boxes[cell].center();
    tree.grid.hidden[cell] = c[2] > 0.5 && (c[0] < 0.3 || (c[1] - 0.6) * (c[0] - 0.5) > 0.05) ? 1 : 0;
    volume += tree.grid.hidden[cell] ? 0.0 : tree.boxes[cell].volume();
  }
  Simulation simulation = fractionsOnOctree(tree, 3, [](const Box& box) {
    const double inside = fractionInside(box, sphere({ 0.5, 0.5, 0.45 }, 0.35), 4);
    return std::vector<double>{ inside, 1.0 - inside, 0.0 };
  });
  simulation.materials[2] = { "outside", false };
  const ExtractedInterfaces result = extract(simulation);
  EXPECT_TRUE(result.warnings.empty());
  expectSound(result.interfaces, 3, unitBox);
  EXPECT_NEAR(result.volumes[0].reconstructed + result.volumes[1].reconstructed, volume, 1e-12);
  EXPECT_NEAR(result.volumes[0].reconstructed, result.volumes[0].given, 1e-6);
}
