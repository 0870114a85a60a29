"""What a representation's errors are at points that are chosen here, found with VTK and numpy and none of Strata's code.

Native samples (cell centres) are compared with the linear interpolation of their material's values, vertices of the
original interfaces with the plane of their cell, and points strewn over both interfaces with the other one.
"""
import numpy
import strata
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import reference, vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_POLYHEDRON, vtkCellArray, vtkCompositeDataSet, vtkHyperTreeGrid, vtkPolyData, vtkStaticCellLocator,
    vtkStructuredGrid, vtkUnstructuredGrid)
from vtkmodules.vtkFiltersCore import vtkCellCenters, vtkProbeFilter, vtkTriangleFilter
from vtkmodules.vtkFiltersHyperTree import vtkHyperTreeGridToUnstructuredGrid

MINIMUM_VOLUME_FRACTION = 0.1
STREWN = 4000
SHAPES = {  # VTK cell type -> faces
    12: [(0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)],
    10: [(0, 1, 2), (0, 1, 3), (1, 2, 3), (0, 2, 3)],
    13: [(0, 1, 2), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)],
    14: [(0, 1, 2, 3), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)],
}


def as_numpy(array):
    return vtk_to_numpy(array).astype(float)


def leaves(data):
    """The data sets that hold cells."""
    if isinstance(data, vtkHyperTreeGrid):
        convert = vtkHyperTreeGridToUnstructuredGrid()
        convert.SetInputData(data)
        convert.Update()
        return [convert.GetOutput()]
    if not isinstance(data, vtkCompositeDataSet):
        return [data]
    iterator, result = data.NewIterator(), []
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        result.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return result


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


def native_samples(run, materials, field):
    """Positions, fractions (a row per material) and a function that gives a material's values."""
    positions, parts, blocks = [], [], []
    for leaf in leaves(run.data):
        cells = leaf.GetCellData()
        ghosts = cells.GetArray("vtkGhostType")
        seen = vtk_to_numpy(ghosts) == 0 if ghosts else numpy.ones(leaf.GetNumberOfCells(), bool)
        positions.append(centers(leaf)[seen])
        parts.append(fractions(cells, materials, run.settings, leaf.GetNumberOfCells())[:, seen])
        blocks.append((cells, seen))

    def values(material):
        own = f"{field}_{material}"
        names = [own if cells.HasArray(own) else field for cells, _ in blocks]
        return numpy.concatenate([as_numpy(cells.GetArray(name))[seen].reshape(seen.sum(), -1)
                                  for name, (cells, seen) in zip(names, blocks)])

    return numpy.concatenate(positions), numpy.concatenate(parts, axis=1), values


class Mesh:
    """A representation, and where points lie in it."""

    def __init__(self, grid):
        self.grid = grid
        self.points = as_numpy(grid.GetPoints().GetData())
        self.cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)

    def array(self, name):
        array = self.grid.GetPointData().GetArray(name)
        return None if array is None else as_numpy(array)

    def locate(self, positions):
        """For each point its cell, -1 outside, and its weights there."""
        cloud, mesh, places = vtkPolyData(), vtkUnstructuredGrid(), vtkPoints()
        places.SetData(numpy_to_vtk(positions, deep=True))
        cloud.SetPoints(places)
        mesh.CopyStructure(self.grid)
        numbers = numpy_to_vtk(numpy.arange(len(self.cells)), deep=True)
        numbers.SetName("cell")
        mesh.GetCellData().AddArray(numbers)
        probe = vtkProbeFilter()
        probe.SetInputData(cloud)
        probe.SetSourceData(mesh)
        probe.SetCellLocatorPrototype(vtkStaticCellLocator())
        probe.ComputeToleranceOff()  # the computed one finds cells beside the one that holds a point
        probe.SetTolerance(0.0)
        probe.Update()
        result = probe.GetOutput().GetPointData()
        found = vtk_to_numpy(result.GetArray("cell")).astype(int)
        found[vtk_to_numpy(result.GetArray("vtkValidPointMask")) == 0] = -1
        weights = self.weights(found, positions)
        # VTK takes a cell for that of a point up to 1/1000 beside it.
        locator, near = vtkStaticCellLocator(), vtkIdList()
        locator.SetDataSet(mesh)
        locator.BuildLocator()
        reach = 1e-9 * numpy.ptp(self.points, axis=0).max()
        for i in numpy.flatnonzero((weights.min(axis=1) < -1e-9) & (found >= 0)):
            locator.FindCellsWithinBounds(numpy.stack([positions[i] - reach, positions[i] + reach], axis=1).ravel(), near)
            cells = numpy.array([near.GetId(n) for n in range(near.GetNumberOfIds())] + [found[i]])
            tried = self.weights(cells, numpy.repeat(positions[i:i + 1], len(cells), axis=0))
            best = tried.min(axis=1).argmax()
            found[i], weights[i] = cells[best], tried[best]
        return found, weights

    def weights(self, cells, positions):
        """Barycentric coordinates of each point in its cell."""
        corners = self.points[self.cells[cells]]
        edges = (corners[:, 1:] - corners[:, :1]).transpose(0, 2, 1)
        rest = numpy.linalg.solve(edges, positions - corners[:, 0])
        return numpy.concatenate([1.0 - rest.sum(axis=1, keepdims=True), rest], axis=1)

    def gradients(self, cells):
        corners = self.points[self.cells[cells]]
        rest = numpy.linalg.inv(corners[:, 1:] - corners[:, :1]).transpose(0, 2, 1)
        return numpy.concatenate([-rest.sum(axis=1, keepdims=True), rest], axis=1)


def field_error(mesh, run, materials, field):
    """Largest error at native samples; samples that VTK finds in no cell are left out."""
    if not leaves(run.data)[0].GetCellData().HasArray(field) and not any(
            leaves(run.data)[0].GetCellData().HasArray(f"{field}_{name}") for name in materials):
        return {}
    positions, parts, values = native_samples(run, materials, field)
    largest = parts.argmax(axis=0)
    found, weights = mesh.locate(positions)
    worst = 0.0
    for m, name in enumerate(materials):
        represented = mesh.array(f"{field}_{name}")
        counts = ((parts[m] >= MINIMUM_VOLUME_FRACTION) | (largest == m)) & (found >= 0)
        if represented is None or not counts.any():
            continue
        corners = represented.reshape(len(represented), -1)[mesh.cells[found[counts]]]
        weighed = numpy.where(weights[counts][..., None] > 1e-7, weights[counts][..., None] * corners, 0.0).sum(axis=1)
        worst = max(worst, numpy.linalg.norm(weighed - values(name)[counts], axis=1).max())
    return {"sampled field": worst}


def surfaces(data):
    """(pair of materials) -> triangles of a surface or collection of surfaces."""
    result = {}
    for leaf in leaves(data):
        if leaf and leaf.GetNumberOfCells():
            cut = vtkTriangleFilter()
            cut.SetInputData(leaf)
            cut.Update()
            surface = cut.GetOutput()
            sides = [vtk_to_numpy(surface.GetCellData().GetArray(side + "_material"))
                     for side in ("positive", "negative")]
            pairs = numpy.sort(numpy.stack(sides, axis=1), axis=1)
            corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
            triangles = as_numpy(surface.GetPoints().GetData())[corners]
            for pair in numpy.unique(pairs, axis=0):
                result.setdefault(tuple(pair), []).append(triangles[(pairs == pair).all(axis=1)])
    return {pair: numpy.concatenate(parts) for pair, parts in result.items()}


def strewn(triangles, random):
    """Points evenly over triangles."""
    edges = triangles[:, 1:] - triangles[:, :1]
    areas = numpy.linalg.norm(numpy.cross(edges[:, 0], edges[:, 1]), axis=1)
    if areas.sum() == 0.0:
        return triangles[:, 0]
    chosen = triangles[random.choice(len(triangles), STREWN, p=areas / areas.sum())]
    weights = random.dirichlet((1.0, 1.0, 1.0), STREWN)
    return numpy.einsum("ni,nij->nj", weights, chosen)


def farthest(points, triangles):
    """The largest distance from points to triangles."""
    surface, places = vtkPolyData(), vtkPoints()
    places.SetData(numpy_to_vtk(triangles.reshape(-1, 3), deep=True))
    surface.SetPoints(places)
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(3 * numpy.arange(len(triangles) + 1), deep=True),
                  numpy_to_vtkIdTypeArray(numpy.arange(3 * len(triangles)), deep=True))
    surface.SetPolys(cells)
    locator = vtkStaticCellLocator()
    locator.SetDataSet(surface)
    locator.BuildLocator()
    closest, cell, part, squared, worst = [0.0] * 3, reference(0), reference(0), reference(0.0), 0.0
    for point in points:
        locator.FindClosestPoint(point, closest, cell, part, squared)
        worst = max(worst, squared.get())
    return worst ** 0.5


def interface_errors(mesh, run, materials):
    from real_data import configured
    original = configured(strata.vtkStrataMaterialInterfaces(), run.settings, False)
    original.SetInputDataObject(run.data)
    represented = strata.vtkStrataRepresentedInterfaces()
    represented.SetInputDataObject(mesh.grid)
    for algorithm in (original, represented):
        algorithm.Update()
    native, own = surfaces(original.GetOutputDataObject(0)), surfaces(represented.GetOutputDataObject(0))
    random = numpy.random.default_rng(1)
    worst, apart, lost = 0.0, 0.0, 0
    for pair, triangles in native.items():
        worst = max(worst, vertex_error(mesh, materials, pair, numpy.unique(triangles.reshape(-1, 3), axis=0)))
        if pair in own:
            apart = max(apart, farthest(strewn(triangles, random), own[pair]),
                        farthest(strewn(own[pair], random), triangles))
        else:
            lost += 1
    return {"sampled interface": worst, "sampled Hausdorff": apart, "pairs lost": lost}


def vertex_error(mesh, materials, pair, vertices):
    """Largest distance from vertices to the plane of their cell on which both materials are as far."""
    difference = mesh.array("distance_" + materials[pair[1]]) - mesh.array("distance_" + materials[pair[0]])
    cells, weights = mesh.locate(vertices)
    cells, weights = cells[cells >= 0], weights[cells >= 0]
    corners = difference[mesh.cells[cells]]
    slope = numpy.linalg.norm(numpy.einsum("ni,nij->nj", corners, mesh.gradients(cells)), axis=1)
    value = numpy.abs(numpy.where(weights > 1e-7, weights * corners, 0.0).sum(axis=1))
    known = numpy.isfinite(slope) & (slope > 0.0)
    return (value[known] / slope[known]).max() if known.any() else 0.0


def sample(grid, run):
    """What sampling finds of a representation, as entries of a row."""
    from real_data import texts
    mesh = Mesh(grid)
    materials = texts(grid, "material_names")
    result = interface_errors(mesh, run, materials)
    for field in texts(grid, "field_names")[:1]:
        result.update(field_error(mesh, run, materials, field))
    return {name: float(value) for name, value in result.items()}
