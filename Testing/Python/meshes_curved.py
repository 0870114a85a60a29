"""The problem of meshes_problem.py in curved cells of the second and third degree, all of it given at their nodes.

A bulge bends the inside of the unit cube and leaves its sides where they are; nodes lie on the bent places.
"""
import numpy
from meshes_grids import EDGES, cubes, unstructured_of
from meshes_problem import LEVELS, NAMES, NORMAL, TETRAHEDRA, add_values, densities, fractions_below
from vtkmodules.vtkCommonDataModel import (
    VTK_LAGRANGE_HEXAHEDRON, VTK_LAGRANGE_TETRAHEDRON, VTK_LAGRANGE_WEDGE, VTK_QUADRATIC_HEXAHEDRON,
    VTK_QUADRATIC_PYRAMID, VTK_QUADRATIC_TETRA, VTK_QUADRATIC_WEDGE, VTK_TRIQUADRATIC_HEXAHEDRON,
    vtkHigherOrderHexahedron)

BULGE = numpy.array([0.03, -0.02, 0.025])  # in the middle of the cube
TETRAHEDRON_EDGES = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]
WEDGE_EDGES = [(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)]
PYRAMID_EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 4), (2, 4), (3, 4)]
WEDGE_SIDES = [(0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)]
HEXAHEDRON_SIDES = [(0, 3, 7, 4), (1, 2, 6, 5), (0, 1, 5, 4), (3, 2, 6, 7), (0, 1, 2, 3), (4, 5, 6, 7)]
# Tetrahedra of half the size in one, its corners 0 to 3 and the middles of its edges.
EIGHTHS = [(0, 4, 6, 7), (4, 1, 5, 8), (6, 5, 2, 9), (7, 8, 9, 3),
           (4, 5, 6, 7), (4, 5, 7, 8), (5, 6, 7, 9), (5, 7, 8, 9)]
REFINEMENTS = 2
SMEAR = 0.2  # width over which fractions at nodes go from 0 to 1


def bent(places):
    return places + 64.0 * (places * (1.0 - places)).prod(axis=-1, keepdims=True) * BULGE


def means(corners, groups):
    return numpy.stack([corners[:, list(group)].mean(axis=1) for group in groups], axis=1)


def second_degree(corners, edges, sides=()):
    return numpy.concatenate([corners, means(corners, edges), means(corners, sides)] if sides
                             else [corners, means(corners, edges)], axis=1)


def hexahedron_nodes(corners, degree):
    """The nodes of VTK's Lagrange hexahedra."""
    count = degree + 1
    result = numpy.empty((len(corners), count ** 3, 3))
    for i, j, k in numpy.ndindex(count, count, count):
        node = vtkHigherOrderHexahedron.PointIndexFromIJK(i, j, k, [degree] * 3)
        step = numpy.array([i, j, k]) / degree
        result[:, node] = corners[:, 0] + step * (corners[:, 6] - corners[:, 0])
    return result


class CurvedCells:
    """What Cells are of straight ones; `straight` are their corners before they were bent."""

    at_nodes = True

    def __init__(self, straight, shape):
        self.straight, self.corners = straight, bent(straight)
        pieces = straight[:, numpy.array(TETRAHEDRA[shape])].reshape(-1, 4, 3)
        for _ in range(REFINEMENTS):
            with_middles = second_degree(pieces, TETRAHEDRON_EDGES)
            pieces = with_middles[:, numpy.array(EIGHTHS)].reshape(-1, 4, 3)
        pieces = bent(pieces)
        volumes = numpy.abs(numpy.linalg.det(pieces[:, 1:] - pieces[:, :1])).reshape(len(straight), -1) / 6.0
        self.volumes = volumes.sum(axis=1)
        self.centers = bent(straight.mean(axis=1))
        below = [(fractions_below(pieces @ NORMAL - level).reshape(volumes.shape) * volumes).sum(axis=1) / self.volumes
                 for level in LEVELS]
        self.fractions = numpy.stack([below[0], below[1] - below[0], 1.0 - below[1]])
        self.densities = densities(self.centers)

    def places(self, weights):
        return bent(numpy.einsum("ckn,cnx->ckx", weights, self.straight))


def smeared_fractions(points):
    """Linear near the planes, on each of which two materials are equal."""
    above = [numpy.clip(0.5 + (points @ NORMAL - level) / SMEAR, 0.0, 1.0) for level in LEVELS]
    return 1.0 - above[0], above[0] - above[1], above[1]


def curved(straight, shape, cell_type, nodes):
    data = unstructured_of(bent(nodes), cell_type)
    points = numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    for name, fraction, density in zip(NAMES, smeared_fractions(points), densities(points)):
        add_values(data.GetPointData(), "volume_fraction_" + name, fraction)
        add_values(data.GetPointData(), "density_" + name, density)
    return data, [CurvedCells(straight, shape)]


def parts_of_cubes(parts):
    return cubes()[:, parts].reshape(-1, len(parts[0]), 3)


def quadratic_hexahedra():
    return curved(cubes(), "hexahedron", VTK_QUADRATIC_HEXAHEDRON, second_degree(cubes(), EDGES))


def triquadratic_hexahedra():
    nodes = second_degree(cubes(), EDGES, HEXAHEDRON_SIDES + [range(8)])
    return curved(cubes(), "hexahedron", VTK_TRIQUADRATIC_HEXAHEDRON, nodes)


def lagrange_hexahedra():
    return curved(cubes(), "hexahedron", VTK_LAGRANGE_HEXAHEDRON, hexahedron_nodes(cubes(), 3))


def tetrahedra(cell_type=VTK_QUADRATIC_TETRA):
    straight = parts_of_cubes(TETRAHEDRA["hexahedron"])
    return curved(straight, "tetrahedron", cell_type, second_degree(straight, TETRAHEDRON_EDGES))


def lagrange_tetrahedra():
    return tetrahedra(VTK_LAGRANGE_TETRAHEDRON)


def wedges(cell_type=VTK_QUADRATIC_WEDGE, sides=()):
    straight = parts_of_cubes([(0, 1, 2, 4, 5, 6), (0, 2, 3, 4, 6, 7)])
    return curved(straight, "wedge", cell_type, second_degree(straight, WEDGE_EDGES, sides))


def lagrange_wedges():
    return wedges(VTK_LAGRANGE_WEDGE, WEDGE_SIDES)


def pyramids():
    bases = [(0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)]
    corners = cubes()
    tips = corners.mean(axis=1)
    straight = numpy.concatenate([numpy.concatenate([corners[:, base], tips[:, None]], axis=1) for base in bases])
    return curved(straight, "pyramid", VTK_QUADRATIC_PYRAMID, second_degree(straight, PYRAMID_EDGES))
