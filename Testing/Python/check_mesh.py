"""What a representation promises, checked with numpy alone: nothing here comes from Strata.

A Representation holds plain arrays read from a vtkUnstructuredGrid; each check returns a list of faults, which is
empty if the promise holds.
"""
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

# Barycentric coordinates down to this count as inside: points on faces belong to all cells round them.
ON_FACE = 1e-9
# Stored values are floats; errors are rounded up when stored.
ROUNDING = 1e-5


class Representation:
    """Arrays of a mesh of tetrahedra: points, cells, and the values of each material at the vertices."""

    def __init__(self, grid, field):
        points, cells = grid.GetPointData(), grid.GetCellData()
        names = grid.GetFieldData().GetAbstractArray("material_names")
        self.materials = [names.GetValue(m) for m in range(names.GetNumberOfValues())]
        self.points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
        self.cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4).copy()
        self.distances = {m: self.array(points, "distance_" + name) for m, name in enumerate(self.materials)}
        self.values = {m: self.array(points, f"{field}_{name}") for m, name in enumerate(self.materials)
                       if points.HasArray(f"{field}_{name}")}
        self.interface_errors = self.array(cells, "interface_error")
        self.field_errors = self.array(cells, "field_error_" + field)

    @staticmethod
    def array(data, name):
        return vtk_to_numpy(data.GetArray(name)).astype(float)

    def corners(self):
        """Positions of the corners, cells x 4 x 3."""
        return self.points[self.cells]

    def gradients(self):
        """Gradients of the barycentric coordinates, cells x 4 x 3."""
        corners = self.corners()
        inverse = numpy.linalg.inv(corners[:, 1:] - corners[:, :1])  # columns: gradients of coordinates 1 to 3
        rest = inverse.transpose(0, 2, 1)
        return numpy.concatenate([-rest.sum(axis=1, keepdims=True), rest], axis=1)


def expand(starts, counts):
    """All of starts[i] .. starts[i] + counts[i] - 1, and the i of each."""
    owner = numpy.repeat(numpy.arange(len(counts)), counts)
    first = numpy.cumsum(counts) - counts
    return numpy.arange(counts.sum()) - first[owner] + starts[owner], owner


class Bins:
    """Points sorted into the boxes of a coarse grid."""

    def __init__(self, points, lower, upper, shape):
        self.shape = numpy.array(shape)
        self.lower, self.scale = lower, self.shape / (upper - lower)
        bins = self.ids(self.at(points))
        self.order = numpy.argsort(bins, kind="stable")
        self.starts = numpy.searchsorted(bins[self.order], numpy.arange(self.shape.prod() + 1))

    def at(self, points):
        return numpy.clip(((points - self.lower) * self.scale).astype(int), 0, self.shape - 1)

    def ids(self, ijk):
        return ijk[:, 0] + self.shape[0] * (ijk[:, 1] + self.shape[1] * ijk[:, 2])

    def near(self, corners):
        """Pairs (cell, point) such that the point may lie in the cell."""
        first, last = self.at(corners.min(axis=1) - ON_FACE), self.at(corners.max(axis=1) + ON_FACE)
        extent = last - first + 1
        number, cell = expand(numpy.zeros(len(corners), int), extent.prod(axis=1))
        size = extent[cell]
        ijk = numpy.stack([number % size[:, 0], number // size[:, 0] % size[:, 1],
                           number // (size[:, 0] * size[:, 1])], axis=1)
        bins = self.ids(first[cell] + ijk)
        place, pair = expand(self.starts[bins], self.starts[bins + 1] - self.starts[bins])
        return cell[pair], self.order[place]


def locate(representation, points):
    """All pairs of a cell and a point in it, with barycentric coordinates: cells, points, weights."""
    corners = representation.corners()
    lower, upper = representation.points.min(axis=0), representation.points.max(axis=0)
    cells, members = Bins(points, lower, upper, (32, 32, 56)).near(corners)
    offsets = points[members] - corners[cells, 0]
    rest = numpy.einsum("nij,nj->ni", representation.gradients()[cells, 1:], offsets)
    weights = numpy.concatenate([1.0 - rest.sum(axis=1, keepdims=True), rest], axis=1)
    inside = weights.min(axis=1) >= -ON_FACE
    return cells[inside], members[inside], weights[inside]


def interpolate(values, weights):
    """Linear interpolation; a corner without weight may be NaN."""
    return numpy.where(weights > ON_FACE, weights * values, 0.0).sum(axis=1)


def largest_per_cell(count, cells, errors):
    result = numpy.zeros(count)
    numpy.maximum.at(result, cells, numpy.nan_to_num(errors, nan=numpy.inf))
    return result


def check_errors(what, errors, stored, bound):
    """Errors per cell against the requested bound and against what the cells say of themselves."""
    faults = []
    if not errors.max() <= bound * (1.0 + ROUNDING):
        faults.append(f"{what}: error {errors.max():.6g} in cell {errors.argmax()} exceeds the bound {bound}")
    low = errors > stored * (1.0 + ROUNDING) + 1e-7
    if low.any():
        cell = numpy.flatnonzero(low)[0]
        faults.append(f"{what}: {low.sum()} cells claim less than their error, "
                      f"first cell {cell}: {stored[cell]:.6g} < {errors[cell]:.6g}")
    if stored.max() > errors.max() * 1.005 + 1e-6:
        faults.append(f"{what}: claimed {stored.max():.6g}, found no more than {errors.max():.6g}")
    return faults


def check_field(representation, samples, materials, bound):
    """`samples`: positions; `materials`: m -> (native values, which samples count)."""
    cells, members, weights = locate(representation, samples)
    faults = []
    errors = numpy.zeros(len(representation.cells))
    for m, (native, counts) in materials.items():
        missing = counts.copy()
        missing[members] = False
        if missing.any():
            faults.append(f"field: {missing.sum()} samples of {representation.materials[m]} lie in no cell")
        of_m = counts[members]
        corner_values = representation.values[m][representation.cells[cells[of_m]]]
        represented = interpolate(corner_values, weights[of_m])
        found = largest_per_cell(len(errors), cells[of_m], numpy.abs(represented - native[members[of_m]]))
        errors = numpy.maximum(errors, found)
    return faults + check_errors("field", errors, representation.field_errors, bound)


def plane_distances(representation, positive, negative, located):
    """Distances of located points to where both materials are as far: a plane, or everything."""
    cells, _, weights = located
    difference = representation.distances[negative] - representation.distances[positive]
    corners = difference[representation.cells[cells]]
    gradient = numpy.einsum("ni,nij->nj", corners, representation.gradients()[cells])
    values = numpy.abs(interpolate(corners, weights))
    with numpy.errstate(divide="ignore", invalid="ignore"):
        return numpy.where(values == 0.0, 0.0, values / numpy.linalg.norm(gradient, axis=1))


def check_interfaces(representation, surfaces, bound, distances=plane_distances):
    """`surfaces`: (positive, negative, vertices, ...). `distances`: of located vertices to what stands for them."""
    faults = []
    errors = numpy.zeros(len(representation.cells))
    for positive, negative, vertices, _ in surfaces:
        located = locate(representation, vertices)
        if len(numpy.unique(located[1])) < len(vertices):
            faults.append(f"interface {positive}|{negative}: vertices lie in no cell")
        found = distances(representation, positive, negative, located)
        errors = numpy.maximum(errors, largest_per_cell(len(errors), located[0], found))
    return faults + check_errors("interface", errors, representation.interface_errors, bound)


def check_mesh(representation, lower, upper):
    """Positive volumes that fill the box, faces that match, and no two vertices in one place."""
    faults = []
    corners = representation.corners()
    volumes = numpy.linalg.det(corners[:, 1:] - corners[:, :1]) / 6.0
    box = (upper - lower).prod()
    if not volumes.min() > 0.0:
        faults.append(f"mesh: cell {volumes.argmin()} has volume {volumes.min():g}")
    if abs(volumes.sum() - box) > 1e-10 * box:
        faults.append(f"mesh: volumes sum to {volumes.sum():.12g}, not {box:.12g}")
    faces = numpy.sort(representation.cells[:, [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]]].reshape(-1, 3), axis=1)
    faces, uses = numpy.unique(faces, axis=0, return_counts=True)
    if uses.max() > 2:
        faults.append(f"mesh: a face is used {uses.max()} times")
    single = representation.points[faces[uses == 1]]
    on_box = ((single == lower).all(axis=1) | (single == upper).all(axis=1)).any(axis=1)
    if not on_box.all():
        faults.append(f"mesh: {(~on_box).sum()} hanging faces")
    # One place, one vertex: then arrays at the vertices hold one value for each vertex, field and material.
    if len(numpy.unique(representation.points, axis=0)) < len(representation.points):
        faults.append("mesh: two vertices in one place")
    return faults


def first_hits(points, triangles, direction):
    """The triangle that a ray from each point along +z (direction 1) or -z (-1) meets first, -1 for none, and whether
    the ray meets its front, against its normal. `triangles`: n x 3 x 3; rays must avoid edges."""
    flat, lower, upper = triangles.copy(), points.min(axis=0), points.max(axis=0)
    flat[:, :, 2] = lower[2]
    pair, member = Bins(points * [1, 1, 0] + [0, 0, lower[2]], lower, upper, (64, 64, 1)).near(flat)
    a, b, c = (triangles[pair, corner] for corner in range(3))
    p = points[member]

    def area(u, v):
        return (u[:, 0] - p[:, 0]) * (v[:, 1] - p[:, 1]) - (u[:, 1] - p[:, 1]) * (v[:, 0] - p[:, 0])

    weights = numpy.stack([area(b, c), area(c, a), area(a, b)], axis=1)
    up = (weights > 0).all(axis=1)  # counter-clockwise seen from above: the normal points upwards
    met = up | (weights < 0).all(axis=1)
    weights, member, pair, up = weights[met], member[met], pair[met], up[met]
    heights = (weights * triangles[pair][:, :, 2]).sum(axis=1) / weights.sum(axis=1)
    ahead = direction * (heights - points[member, 2])
    order = numpy.flatnonzero(ahead > 0)
    order = order[numpy.lexsort((ahead[order], member[order]))]
    seen, place = numpy.unique(member[order], return_index=True)
    hit, front = numpy.full(len(points), -1), numpy.zeros(len(points), bool)
    hit[seen] = pair[order[place]]
    front[seen] = up[order[place]] != (direction > 0)
    return hit, front


def check_vertices(representation, triangles, positive, negative, margin):
    """Every vertex lies in the material on its side of the original interface that a ray meets first. Vertices nearer
    than a margin to another material are left out."""
    distances = numpy.stack([representation.distances[m] for m in range(len(representation.materials))])
    clear = numpy.sort(distances, axis=0)[1] > margin  # NaN sorts last
    found = numpy.nanargmin(distances, axis=0)
    # Off the lattice's planes, where rays would meet edges; inside of the box's walls, where the surfaces end.
    center = 0.5 * (representation.points.min(axis=0) + representation.points.max(axis=0))
    points = representation.points + 1e-6 * (center - representation.points) + [3e-7, 7e-7, 0.0]
    faults = []
    for direction in (1, -1):
        hit, front = first_hits(points, triangles, direction)
        expected = numpy.where(front, positive[hit], negative[hit])
        wrong = clear & (hit >= 0) & (expected != found)
        faults += [f"vertices: {representation.points[v]} lies in {representation.materials[expected[v]]}, "
                   f"not in {representation.materials[found[v]]}" for v in numpy.flatnonzero(wrong)]
    return faults


def polygon_areas(points, offsets, corners):
    """Areas of planar polygons: half the length of the sum of cross products of consecutive corners."""
    polygon = numpy.repeat(numpy.arange(len(offsets) - 1), numpy.diff(offsets))
    following = numpy.arange(1, len(corners) + 1)
    following[offsets[1:] - 1] = offsets[:-1]
    first = points[corners[offsets[:-1]]][polygon]
    cross = numpy.cross(points[corners] - first, points[corners[following]] - first)
    sums = numpy.stack([numpy.bincount(polygon, cross[:, axis], len(offsets) - 1) for axis in range(3)], axis=1)
    return 0.5 * numpy.linalg.norm(sums, axis=1)
