"""One analytic problem on any grid: three layers parted by slanted planes, smooth fields, exact volume fractions.

Cells are known here by the positions of their corners, so that a check needs nothing of what VTK, or Strata, makes of
a data object.
"""
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk

NORMAL = numpy.array([0.8, 0.48, 0.36])  # of length 1
LEVELS = (0.52, 1.01)
NAMES = ("low", "middle", "high")

# Corners of the tetrahedra of each shape, in VTK's numbers of corners.
TETRAHEDRA = {
    "tetrahedron": [(0, 1, 2, 3)],
    "hexahedron": [(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)],
    "wedge": [(0, 1, 2, 5), (0, 1, 5, 4), (0, 4, 5, 3)],
    "pyramid": [(0, 1, 2, 4), (0, 2, 3, 4)],
}


def densities(points):
    """Density of each material at points: linear, linear, and of second degree."""
    x, y, z = points.T
    return numpy.stack([1.0 + x + 2.0 * y, 10.0 - z, 20.0 + x * y])


def materials(points):
    height = points @ NORMAL
    return (height[:, None] >= numpy.array(LEVELS)).sum(axis=1)


def fractions_below(values):
    """The part of each tetrahedron where the linear function with these values at its corners is negative."""
    a, b, c, d = numpy.sort(values, axis=1).T

    def share(inside, outside):  # of an edge, from its end inside
        return inside / numpy.where(inside == outside, 1.0, inside - outside)

    one = share(a, b) * share(a, c) * share(a, d)
    three = 1.0 - share(d, a) * share(d, b) * share(d, c)
    ac, ad, bc, bd = share(a, c), share(a, d), share(b, c), share(b, d)
    two = bc * bd + ac * ad * (1.0 - bd) + ac * bd * (1.0 - bc)
    below = (numpy.stack([a, b, c, d]) < 0.0).sum(axis=0)
    return numpy.choose(below, [0.0 * a, one, two, three, 0.0 * a + 1.0])


class Cells:
    """Cells of one shape: their corners (cells x corners x 3), and what the simulation knows in them."""

    at_nodes = False  # where densities are given

    def __init__(self, corners, shape):
        self.corners = corners
        tetrahedra = corners[:, numpy.array(TETRAHEDRA[shape])]
        volumes = numpy.abs(numpy.linalg.det(tetrahedra[:, :, 1:] - tetrahedra[:, :, :1])) / 6.0
        self.volumes = volumes.sum(axis=1)
        self.centers = (tetrahedra.mean(axis=2) * volumes[..., None]).sum(axis=1) / self.volumes[:, None]
        below = []
        for level in LEVELS:
            heights = tetrahedra.reshape(-1, 4, 3) @ NORMAL - level
            below.append((fractions_below(heights).reshape(volumes.shape) * volumes).sum(axis=1) / self.volumes)
        self.fractions = numpy.stack([below[0], below[1] - below[0], 1.0 - below[1]])
        self.densities = densities(self.centers)

    def places(self, weights):
        """Where the corners' weights (cells x places x corners) lead."""
        return numpy.einsum("ckn,cnx->ckx", weights, self.corners)


def add_values(attributes, name, values):
    array = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
    array.SetName(name)
    attributes.AddArray(array)


def add_arrays(data, cells):
    """Attaches the fractions and the densities; densities of materials that a cell lacks are 0."""
    for m, name in enumerate(NAMES):
        present = cells.fractions[m] > 0.0
        add_values(data.GetCellData(), "volume_fraction_" + name, cells.fractions[m])
        add_values(data.GetCellData(), "density_" + name, numpy.where(present, cells.densities[m], 0.0))


def joined(parts):
    """All cells' centers, volumes, fractions and densities."""
    return (numpy.concatenate([p.centers for p in parts]), numpy.concatenate([p.volumes for p in parts]),
            numpy.concatenate([p.fractions for p in parts], axis=1),
            numpy.concatenate([p.densities for p in parts], axis=1))


def random_points(parts, count):
    """`count` points in each convex cell, means of its corners with random weights, and the volumes of their cells."""
    random = numpy.random.default_rng(11)
    points, volumes = [], []
    for part in parts:
        weights = random.dirichlet(numpy.full(part.corners.shape[1], 0.5), (len(part.corners), count))
        points.append(part.places(weights).reshape(-1, 3))
        volumes.append(numpy.repeat(part.volumes, count))
    return numpy.concatenate(points), numpy.concatenate(volumes)
