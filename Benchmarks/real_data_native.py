"""What a data set says of its fields: at its samples (cell centres or points) and between them, found with VTK and numpy
and none of Strata's code.

Between samples, a field is what interpolation gives: trilinear between the centres of a rectilinear grid's cells, by
VTK's functions of each cell for fields at points. A material's field is known where all the samples used count for it.
"""
import numpy
from real_data_sets import as_numpy, averages_at_points, leaves, visible
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import reference, vtkIdList
from vtkmodules.vtkCommonDataModel import (
    VTK_POLYHEDRON, VTK_TETRA, VTK_WEDGE, vtkImageData, vtkRectilinearGrid, vtkStructuredGrid, vtkUnstructuredGrid)
from vtkmodules.vtkFiltersCore import vtkCellCenters

MINIMUM_VOLUME_FRACTION = 0.1
BETWEEN = 100000  # points between samples
PLACES = 64       # parameters in a cell that these are taken from
SHAPES = {  # VTK cell type -> faces
    12: [(0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)],
    10: [(0, 1, 2), (0, 1, 3), (1, 2, 3), (0, 2, 3)],
    13: [(0, 1, 2), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)],
    14: [(0, 1, 2, 3), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)],
}


def fan_centroids(points, faces):
    """Centres of volume of cells: tetrahedra from the mean corner to triangles round the means of the faces.
    `points`: cells x corners x 3."""
    apex = points.mean(axis=1)
    volumes, moments = 0.0, 0.0
    for face in faces:
        corners = points[:, face] - apex[:, None]
        middle = corners.mean(axis=1)
        for i in range(len(face)):
            a, b = corners[:, i], corners[:, (i + 1) % len(face)]
            volume = numpy.abs((middle * numpy.cross(a, b)).sum(axis=1))
            volumes = volumes + volume
            moments = moments + volume[:, None] * 0.25 * (middle + a + b)
    return apex + moments / volumes[:, None]


def polyhedron_centroid(data, cell):
    ids = vtkIdList()
    data.GetFaceStream(cell, ids)
    stream = [ids.GetId(i) for i in range(ids.GetNumberOfIds())]
    faces, at = [], 1
    for _ in range(stream[0]):
        faces.append(stream[at + 1:at + 1 + stream[at]])
        at += stream[at] + 1
    corners = sorted(set(sum(faces, [])))
    points = numpy.array([data.GetPoint(p) for p in corners])
    return fan_centroids(points[None], [[corners.index(p) for p in face] for face in faces])[0]


def centers(data):
    """Centres of volume of a data set's cells."""
    if isinstance(data, vtkStructuredGrid):
        shape = [0] * 3
        data.GetDimensions(shape)
        points = as_numpy(data.GetPoints().GetData()).reshape(shape[2], shape[1], shape[0], 3)
        corners = [points[c:shape[2] - 1 + c, b:shape[1] - 1 + b, a:shape[0] - 1 + a].reshape(-1, 3)
                   for a, b, c in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))]
        return fan_centroids(numpy.stack(corners, axis=1), SHAPES[12])
    if not isinstance(data, vtkUnstructuredGrid):
        filter_ = vtkCellCenters()
        filter_.SetInputData(data)
        filter_.Update()
        return as_numpy(filter_.GetOutput().GetPoints().GetData())
    result = numpy.full((data.GetNumberOfCells(), 3), numpy.nan)
    kinds = vtk_to_numpy(data.GetCellTypesArray())
    offsets, corners = (vtk_to_numpy(a) for a in (data.GetCells().GetOffsetsArray(),
                                                  data.GetCells().GetConnectivityArray()))
    places = as_numpy(data.GetPoints().GetData())
    for kind, faces in SHAPES.items():
        cells = numpy.flatnonzero(kinds == kind)
        count = 1 + max(max(face) for face in faces)
        if len(cells):
            result[cells] = fan_centroids(places[corners[offsets[cells][:, None] + numpy.arange(count)]], faces)
    voxels = numpy.flatnonzero(kinds == 11)
    result[voxels] = places[corners[offsets[voxels][:, None] + numpy.arange(8)]].mean(axis=1)
    for cell in numpy.flatnonzero(kinds == VTK_POLYHEDRON):
        result[cell] = polyhedron_centroid(data, cell)
    return result


def fraction_array(cells, material):
    """The array of a material's fractions by the conventions that the data sets follow; None for what is left."""
    number = material.rsplit(" ", 1)[-1]
    for name in (f"volume_fraction_{material}", f"vf_{material}", f"alpha.{material}", f"{material}_fraction",
                 f"Volume Fraction for {material}", f"{material} Volume Fraction", f"{material} volume fraction",
                 f"Material volume fraction - {number}"):
        if cells.HasArray(name):
            return as_numpy(cells.GetArray(name))
    return None


def fractions(cells, materials, settings, count):
    """One row of fractions per material."""
    if "ids" in settings:
        ids = as_numpy(cells.GetArray(settings["ids"]))
        return numpy.stack([ids == float(name.rsplit(" ", 1)[-1]) if name != "outside" else 0.0 * ids
                            for name in materials])
    rows = [fraction_array(cells, name) for name in materials]
    known = [row for row in rows if row is not None]
    rest = 1.0 - sum(known) if known else numpy.ones(count)
    return numpy.stack([rest if row is None and name != "outside" else 0.0 * rest if row is None else row
                        for row, name in zip(rows, materials)])


class Samples:
    """Where the fields of a data set are known: `positions`, `counts` (a row per material: whether a sample counts for
    it), `values(material)`. `leaf` is the grid where there is just one."""

    def __init__(self, run, materials, field):
        grids = leaves(run.data)
        self.leaf = grids[0] if len(grids) == 1 else None
        self.field = field
        self.at_points = not any(has_field(grids[0].GetCellData(), name) for name in self.names(materials))
        positions, parts, self.blocks = [], [], []
        for grid in grids:
            cells = grid.GetCellData()
            seen = visible(grid)
            part = fractions(cells, materials, run.settings, grid.GetNumberOfCells()) * seen
            if self.at_points:
                part, seen = at_points(grid, part, seen, "ids" in run.settings)
            positions.append(point_positions(grid) if self.at_points else centers(grid))
            parts.append(part)
            self.blocks.append((grid.GetPointData() if self.at_points else cells, len(seen)))
        self.positions, parts = numpy.concatenate(positions), numpy.concatenate(parts, axis=1)
        largest = (parts.argmax(axis=0) == numpy.arange(len(parts))[:, None]) & (parts.max(axis=0) > 0.0)
        self.counts = (parts >= MINIMUM_VOLUME_FRACTION) | largest

    def names(self, materials):
        return [self.field] + [f"{self.field}_{name}" for name in materials]

    def values(self, material):
        """A material's values, one row per sample; None where it has none."""
        result = []
        for arrays, count in self.blocks:
            own = f"{self.field}_{material}"
            array = arrays.GetArray(own if arrays.HasArray(own) else self.field)
            if array is None:
                return None
            result.append(as_numpy(array).reshape(count, -1))
        return numpy.concatenate(result)


def has_field(arrays, name):
    return bool(arrays.HasArray(name))


def at_points(grid, parts, seen, are_ids):
    """The materials' parts of what lies round the points, and which points touch visible cells. With ids, each
    material round a point counts."""
    means = averages_at_points(grid, numpy.column_stack([seen.astype(float), parts.T]))
    seen = means[:, 0] > 0.0
    parts = (means[:, 1:] / numpy.where(seen, means[:, 0], 1.0)[:, None]).T
    return ((parts > 0.0).astype(float) if are_ids else parts), seen


def point_positions(grid):
    if isinstance(grid, (vtkStructuredGrid, vtkUnstructuredGrid)):
        return as_numpy(grid.GetPoints().GetData())
    return numpy.array([grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())])


def boxes_of_lattice(shape):
    """The eight samples of each cell of a lattice of samples, those along x first, and weights at random places."""
    first = numpy.arange(numpy.prod(shape)).reshape(shape[::-1])[:-1, :-1, :-1].ravel()
    steps = [dx + shape[0] * (dy + shape[1] * dz) for dz in (0, 1) for dy in (0, 1) for dx in (0, 1)]
    u = places(numpy.random.default_rng(2))
    weights = numpy.stack([(u[:, 0] if dx else 1 - u[:, 0]) * (u[:, 1] if dy else 1 - u[:, 1]) *
                           (u[:, 2] if dz else 1 - u[:, 2]) for dz in (0, 1) for dy in (0, 1) for dx in (0, 1)], axis=1)
    return first[:, None] + numpy.array(steps), weights


def places(random):
    """Random parameters in the unit cube, some on its faces and edges."""
    u = random.random((PLACES, 3))
    return numpy.where(random.random(u.shape) < 0.2, numpy.round(u), u)


def cells_of_kind(grid, kind):
    """The points of the visible cells of a VTK type, and weights at random places of them."""
    kinds = vtk_to_numpy(grid.GetCellTypesArray())
    chosen = numpy.flatnonzero((kinds == kind) & visible(grid))
    cell = grid.GetCell(int(chosen[0]))
    offsets, corners = (vtk_to_numpy(a) for a in (grid.GetCells().GetOffsetsArray(),
                                                  grid.GetCells().GetConnectivityArray()))
    count = cell.GetNumberOfPoints()
    u = places(numpy.random.default_rng(2))
    u = u[u.sum(axis=1) <= 1.0] if kind == VTK_TETRA else u[u[:, :2].sum(axis=1) <= 1.0] if kind == VTK_WEDGE else u
    weights, at, part = numpy.zeros((len(u), count)), [0.0] * 3, reference(0)
    for i, place in enumerate(u):
        row = [0.0] * count
        cell.EvaluateLocation(part, place, at, row)
        weights[i] = row
    return corners[offsets[chosen][:, None] + numpy.arange(count)], weights


def native_cells(samples):
    """The cells between samples: the samples of each, and weights at random places."""
    grid = samples.leaf
    if grid is None:
        return []
    if isinstance(grid, vtkUnstructuredGrid):
        kinds = numpy.unique(vtk_to_numpy(grid.GetCellTypesArray())) if samples.at_points else []
        return [cells_of_kind(grid, kind) for kind in kinds if kind != VTK_POLYHEDRON]
    if not samples.at_points and not isinstance(grid, (vtkImageData, vtkRectilinearGrid)):
        return []
    extent = grid.GetExtent()
    shape = [extent[2 * axis + 1] - extent[2 * axis] + 1 for axis in range(3)]
    if not samples.at_points:
        return [boxes_of_lattice([n - 1 for n in shape])]
    corners, weights = boxes_of_lattice(shape)
    return [(corners[visible(grid)], weights)]


def between(samples, m, values):
    """Positions between samples and a material's values there."""
    random = numpy.random.default_rng(3)
    positions, found = [numpy.zeros((0, 3))], [numpy.zeros((0, values.shape[1]))]
    for corners, weights in native_cells(samples):
        corners = corners[samples.counts[m][corners].all(axis=1)]
        if len(corners):
            chosen = corners[random.integers(len(corners), size=BETWEEN)]
            parts = weights[random.integers(len(weights), size=BETWEEN)]
            positions.append(numpy.einsum("nk,nki->ni", parts, samples.positions[chosen]))
            found.append(numpy.einsum("nk,nki->ni", parts, values[chosen]))
    return numpy.concatenate(positions), numpy.concatenate(found)
