"""What a representation's errors are at points that are chosen here, found with VTK and numpy and none of Strata's code.

Native fields (see real_data_native.py) are compared with the linear interpolation of their material's values, vertices
of the original interfaces with the plane of their cell, and points strewn over both interfaces with the other one.
"""
import numpy
import strata
from real_data_native import Samples, between
from real_data_sets import as_numpy, leaves
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import reference, vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkStaticCellLocator, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkProbeFilter, vtkTriangleFilter

STREWN = 4000


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


class Interpolated:
    """A material's field in a mesh, at some positions; those outside are left out."""

    def __init__(self, mesh, represented, positions):
        self.cells, weights = mesh.locate(positions)
        self.inside = self.cells >= 0
        self.cells = self.cells[self.inside]
        self.weights = weights[self.inside][..., None]
        self.values = self.weighed(represented.reshape(len(represented), -1)[mesh.cells[self.cells]])

    def weighed(self, corners):
        """Corners that hardly count may lack the material."""
        parts = self.weights * corners
        return numpy.where(self.weights > 1e-7, parts, numpy.nan_to_num(parts)).sum(axis=1)

    def largest_error(self, values, chosen=slice(None)):
        errors = numpy.linalg.norm(self.values - values[self.inside], axis=1)[chosen]
        errors = errors[~numpy.isnan(errors)]
        return errors.max() if len(errors) else 0.0

    def nearest(self, mesh, distances):
        """The material at each of the positions."""
        corners = distances[:, mesh.cells[self.cells]]
        return numpy.nan_to_num((self.weights[..., 0] * corners).sum(axis=2), nan=numpy.inf).argmin(axis=0)


def field_error(mesh, run, materials, field):
    """Largest error at native samples. For certified errors between them too, in cells that hold a sample of the
    material and where the mesh shows the material: elsewhere its values serve other cells."""
    samples = Samples(run, materials, field)
    distances = numpy.stack([mesh.array("distance_" + name) for name in materials])
    at_samples, among, magnitude = 0.0, 0.0, 0.0
    for m, name in enumerate(materials):
        represented, values = mesh.array(f"{field}_{name}"), samples.values(name)
        counts = samples.counts[m]
        if represented is None or values is None or not counts.any():
            continue
        magnitude = max(magnitude, numpy.abs(values[counts]).max())
        there = Interpolated(mesh, represented, samples.positions[counts])
        at_samples = max(at_samples, there.largest_error(values[counts]))
        if run.options.certified:
            positions, values = between(samples, m, values)
            found = Interpolated(mesh, represented, positions)
            shown = numpy.isin(found.cells, there.cells) | (found.nearest(mesh, distances) == m)
            among = max(among, found.largest_error(values, shown))
    return {"sampled field": max(at_samples, among), "sampled between": among, "magnitude": magnitude}


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


def areas_of(triangles):
    edges = triangles[:, 1:] - triangles[:, :1]
    return 0.5 * numpy.linalg.norm(numpy.cross(edges[:, 0], edges[:, 1]), axis=1)


def strewn(triangles, random, count=STREWN):
    """Points evenly over triangles."""
    areas = areas_of(triangles)
    if areas.sum() == 0.0:
        return triangles[:, 0]
    chosen = triangles[random.choice(len(triangles), count, p=areas / areas.sum())]
    weights = random.dirichlet((1.0, 1.0, 1.0), count)
    return numpy.einsum("ni,nij->nj", weights, chosen)


def strewn_over(original, represented, count):
    """For each pair of materials, points over both surfaces between them: `count` over all surfaces of a side."""
    random = numpy.random.default_rng(1)
    totals = [sum(areas_of(triangles).sum() for triangles in side.values()) for side in (original, represented)]
    for pair in original.keys() & represented.keys():
        yield pair, *(strewn(side[pair], random, 1 + round(count * areas_of(side[pair]).sum() / total))
                      for side, total in zip((original, represented), totals))


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
