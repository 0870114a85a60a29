"""Checks the promises of the representation on all steps of the impact, with numpy and none of Strata's code
(check_mesh.py), and that the checks themselves notice what they should: see `perturbations`.
"""
import copy
import json
import os
import sys
from pathlib import Path

import check_mesh
import numpy
from check_mesh import Representation
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import reference, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkStaticCellLocator, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkProbeFilter, vtkTriangleFilter
from vtkmodules.vtkIOXML import vtkXMLRectilinearGridReader

CASE = Path(os.environ["STRATA_DATA"]) / "impact/impact.strata"
INTERFACE_BOUND, DENSITY_BOUND = 0.15, 0.3
MINIMUM_VOLUME_FRACTION = 0.1
WITH_FIELDS = (0, 1)
DIAGONAL = 0.5 ** 0.5


class Native:
    """A step as the simulation wrote it."""

    def __init__(self, name):
        reader = vtkXMLRectilinearGridReader()
        reader.SetFileName(str(CASE.parent / name))
        reader.Update()
        grid = reader.GetOutput()
        axes = [vtk_to_numpy(a) for a in (grid.GetXCoordinates(), grid.GetYCoordinates(), grid.GetZCoordinates())]
        axes = [axis.astype(float) for axis in axes]
        self.lower, self.upper = (numpy.array([axis[end] for axis in axes]) for end in (0, -1))
        z, y, x = numpy.meshgrid(*[0.5 * (axis[1:] + axis[:-1]) for axis in reversed(axes)], indexing="ij")
        self.samples = numpy.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
        self.cells = grid.GetCellData()

    def array(self, name):
        return vtk_to_numpy(self.cells.GetArray(name)).astype(float)

    def densities(self, materials):
        """Material -> (density, which samples count): at least a tenth of the cell, or the most of it."""
        fractions = numpy.stack([self.array("volume_fraction_" + name) for name in materials])
        largest = fractions.argmax(axis=0)
        return {m: (self.array("density_" + materials[m]),
                    (fractions[m] >= MINIMUM_VOLUME_FRACTION) | (largest == m)) for m in WITH_FIELDS}


def output(proxy, time):
    proxy.UpdatePipeline(time)
    return proxy.GetClientSideObject().GetOutputDataObject(0)


def surfaces_of(collection):
    """(positive, negative, vertices, triangles) of each original interface."""
    result = []
    for block in range(collection.GetNumberOfPartitionedDataSets()):
        surface = collection.GetPartition(block, 0)
        if surface and surface.GetNumberOfCells():
            cells = surface.GetCellData()
            sides = [cells.GetArray(side + "_material").GetValue(0) for side in ("positive", "negative")]
            vertices = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
            corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
            result.append((*sides, vertices, vertices[corners]))
    return result


def check_location(grid, representation, points):
    """VTK's own cell locator finds every point in a cell that holds it by check_mesh's reckoning."""
    probe = vtkProbeFilter()
    cloud, mesh = vtkPolyData(), vtkUnstructuredGrid()
    positions = vtkPoints()
    positions.SetData(numpy_to_vtk(points, deep=True))
    cloud.SetPoints(positions)
    mesh.CopyStructure(grid)
    ids = numpy_to_vtk(numpy.arange(grid.GetNumberOfCells()), deep=True)
    ids.SetName("cell")
    mesh.GetCellData().AddArray(ids)
    probe.SetInputData(cloud)
    probe.SetSourceData(mesh)
    probe.SetCellLocatorPrototype(vtkStaticCellLocator())
    probe.Update()
    found = vtk_to_numpy(probe.GetOutput().GetPointData().GetArray("cell"))
    cells, members, _ = check_mesh.locate(representation, points)
    pairs = members * len(representation.cells) + cells
    unknown = ~numpy.isin(numpy.arange(len(points)) * len(representation.cells) + found, pairs)
    return [f"location: VTK finds {unknown.sum()} points in other cells"] if unknown.any() else []


def slice_areas(section, materials):
    """Area of each material in a slice."""
    polygons = section.GetPolys()
    offsets, corners = (vtk_to_numpy(a) for a in (polygons.GetOffsetsArray(), polygons.GetConnectivityArray()))
    areas = check_mesh.polygon_areas(vtk_to_numpy(section.GetPoints().GetData()).astype(float), offsets, corners)
    return numpy.bincount(vtk_to_numpy(section.GetCellData().GetArray("material")), areas, len(materials))


def check_slices(section, time, native, materials):
    """Areas over all materials sum to the section of the box: on a wall, between, and askew."""
    size = native.upper - native.lower
    center = 0.5 * (native.lower + native.upper)
    planes = [((0.0, 0.0, 0.0), (0.0, 1.0, 0.0), size[0] * size[2]),
              ((3.3, 0.0, 0.0), (1.0, 0.0, 0.0), size[1] * size[2]),
              (center, (DIAGONAL, DIAGONAL, 0.0), numpy.hypot(size[0], size[1]) * size[2])]
    section.Materials = materials
    faults = []
    for origin, normal, expected in planes:
        section.SliceType.Origin, section.SliceType.Normal = list(origin), list(normal)
        area = slice_areas(output(section, time), materials).sum()
        if abs(area - expected) > 1e-6 * expected:
            faults.append(f"slice: areas on the plane of normal {normal} sum to {area:.9g}, not {expected:.9g}")
    return faults


def check_all(representation, native, surfaces, margin=1e-4, distances=check_mesh.plane_distances):
    """`margin`: how far vertices may lie on the wrong side of an interface; `distances`: see check_interfaces."""
    densities = native.densities(representation.materials)
    triangles = numpy.concatenate([surface[3] for surface in surfaces])
    sides = [numpy.concatenate([numpy.full(len(surface[3]), surface[side]) for surface in surfaces])
             for side in range(2)]
    return (check_mesh.check_mesh(representation, native.lower, native.upper)
            + check_mesh.check_field(representation, native.samples, densities, DENSITY_BOUND)
            + check_mesh.check_interfaces(representation, surfaces, INTERFACE_BOUND, distances)
            + check_mesh.check_vertices(representation, triangles, *sides, margin))


def perturbations(representation, native, surfaces):
    """Copies of a representation with one defect each, and what must be noticed."""
    densities = native.densities(representation.materials)
    m = WITH_FIELDS[-1]
    members = numpy.flatnonzero(densities[m][1])
    cells, _, weights = check_mesh.locate(representation, native.samples[members])
    row, corner = numpy.unravel_index(weights.argmax(), weights.shape)
    sample_vertex = representation.cells[cells[row], corner]
    positive, negative, vertices, _ = surfaces[-1]
    cells, _, weights = check_mesh.locate(representation, vertices)
    row, corner = numpy.unravel_index(weights.argmax(), weights.shape)
    interface_vertex = representation.cells[cells[row], corner]

    def changed(change):
        result = copy.deepcopy(representation)
        change(result)
        return result

    def split_vertex(r):
        r.points = numpy.vstack([r.points, r.points[r.cells[0, 0]]])
        for arrays in (r.values, r.distances):
            for name, array in arrays.items():
                arrays[name] = numpy.append(array, array[r.cells[0, 0]])
        r.cells[0, 0] = len(r.points) - 1

    def exchange_materials(r):
        vertex = numpy.flatnonzero((r.distances[positive] == 0) & (r.distances[negative] > 0.01))[0]
        r.distances[positive][vertex] = r.distances[negative][vertex]
        r.distances[negative][vertex] = 0.0

    yield "field", changed(lambda r: numpy.add.at(r.values[m], sample_vertex, 3.0 * DENSITY_BOUND))
    yield "field", changed(lambda r: numpy.put(r.values[m], sample_vertex, numpy.nan))
    yield "field", changed(lambda r: numpy.multiply(r.field_errors, 0.99, out=r.field_errors))
    yield "interface", changed(lambda r: numpy.add.at(r.distances[positive], interface_vertex, 3.0 * INTERFACE_BOUND))
    yield "interface", changed(lambda r: numpy.multiply(r.interface_errors, 0.99, out=r.interface_errors))
    yield "vertices", changed(exchange_materials)
    yield "mesh", changed(split_vertex)
    yield "mesh", changed(lambda r: numpy.put(r.cells[0], [0, 1], r.cells[0, [1, 0]]))
    yield "mesh", changed(lambda r: numpy.put(r.cells, range(4), r.cells[1]))


def check_perturbations(representation, native, surfaces):
    """Every defect must turn something red."""
    faults = []
    for number, (kind, damaged) in enumerate(perturbations(representation, native, surfaces)):
        noticed = [fault for fault in check_all(damaged, native, surfaces) if fault.startswith(kind)]
        if not noticed:
            faults.append(f"defect {number} ({kind}) goes unnoticed")
    return faults


def spread(triangles, count):
    """Points spread over triangles, as many on each area."""
    random = numpy.random.default_rng(1)
    edges = triangles[:, 1:] - triangles[:, :1]
    areas = numpy.linalg.norm(numpy.cross(edges[:, 0], edges[:, 1]), axis=1)
    chosen = triangles[random.choice(len(triangles), count, p=areas / areas.sum())]
    weights = random.dirichlet((1.0, 1.0, 1.0), count)
    return (weights[:, :, None] * chosen).sum(axis=1)


def nearest(points, triangles):
    """The distances of points to triangles, by VTK's locator."""
    corners = vtkPoints()
    corners.SetData(numpy_to_vtk(triangles.reshape(-1, 3), deep=True))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(numpy.arange(3 * len(triangles)), deep=True))
    surface = vtkPolyData()
    surface.SetPoints(corners)
    surface.SetPolys(cells)
    locator = vtkStaticCellLocator()
    locator.SetDataSet(surface)
    locator.BuildLocator()
    closest, cell, sub, squared = [0.0] * 3, reference(0), reference(0), reference(0.0)
    result = numpy.empty(len(points))
    for i, point in enumerate(points):
        locator.FindClosestPoint(point, closest, cell, sub, squared)
        result[i] = squared.get() ** 0.5
    return result


def triangles_of(represented):
    """(positive, negative) -> triangles of the represented interface."""
    triangulate = vtkTriangleFilter()
    triangulate.SetInputData(represented)
    triangulate.Update()
    represented = triangulate.GetOutput()
    sides = [vtk_to_numpy(represented.GetCellData().GetArray(side + "_material")) for side in ("positive", "negative")]
    points = vtk_to_numpy(represented.GetPoints().GetData()).astype(float)
    triangles = points[vtk_to_numpy(represented.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
    pairs = set(zip(*sides))
    return {(p, n): triangles[(numpy.isin(sides[0], (p, n))) & (numpy.isin(sides[1], (p, n)))]
            for a, b in pairs for p, n in ((a, b), (b, a))}


def check_distances(represented, surfaces, bound, count=20000):
    """Between each pair of materials, the original and the represented interface are near to each other, both ways."""
    faults = []
    for positive, negative, _, original in surfaces:
        own = represented[positive, negative]
        found = max(nearest(spread(original, count), own).max(), nearest(spread(own, count), original).max())
        print(f"  {positive}|{negative}: {found:.4f} between original and represented interface")
        if found > bound:
            faults.append(f"interfaces: {positive}|{negative} are {found} apart, not {bound}")
    return faults


def check_certified(tetrahedra, time, native, surfaces):
    """Whole cells: what holds at points, and the distances between interfaces."""
    tetrahedra.NativeElements = "Cells (certified)"
    represented = RepresentedInterfaces(Input=tetrahedra)
    faults = []
    for method in ("Direct", "Fitted"):
        tetrahedra.ErrorMethod = method
        grid = output(tetrahedra, time)
        representation = Representation(grid, "density")
        own = triangles_of(output(represented, time))
        vertices = {surface[:2]: surface[2] for surface in surfaces}

        def distances(_, positive, negative, located):
            return nearest(vertices[positive, negative], own[positive, negative])[located[1]]

        # Claims are about all points: the samples alone need not reach them.
        found = check_all(representation, native, surfaces, numpy.inf, distances)
        faults += [fault for fault in found if ": claimed" not in fault]
        claimed = grid.GetFieldData().GetArray("achieved_interface_error").GetValue(0)
        # The step has a disc without thickness that no cell shows.
        if claimed > 1.001 * INTERFACE_BOUND:
            faults.append(f"interfaces: {claimed} achieved")
        faults += check_distances(own, surfaces, claimed)
        print(f"t = {time}, certified, {method}: {len(representation.cells)} cells, {len(faults)} faults")
    tetrahedra.NativeElements = "Points"
    tetrahedra.ErrorMethod = "Direct"
    if not check_distances(triangles_of(output(represented, time)), surfaces, INTERFACE_BOUND):
        faults.append("interfaces: a mesh with errors at points passes the check of distances")
    return faults


def main():
    simple.LoadPlugin(os.environ["STRATA_PLUGIN"], remote=False, ns=globals())
    steps = json.loads(CASE.read_text())["steps"]
    case = StrataCaseReader(FileName=str(CASE))
    interfaces = MaterialInterfaces(Input=case)
    tetrahedra = MultiresolutionTetrahedra(
        Input=case, Interfaces=interfaces, FieldArrays=["density"], InterfaceErrorBound=INTERFACE_BOUND,
        AbsoluteFieldErrorBounds=["density", str(DENSITY_BOUND)])
    section = MaterialSlice(Input=tetrahedra)
    faults = []
    for step in steps:
        time = step["time"]
        native = Native(step["grid"])
        surfaces = surfaces_of(output(interfaces, time))
        methods = ("Direct", "Saturated", "Fitted", "Accumulated") if step is steps[4] else ("Direct",)
        for method in methods:
            tetrahedra.ErrorMethod = method
            grid = output(tetrahedra, time)
            representation = Representation(grid, "density")
            # Fitting moves the represented interface past vertices: what they lie in is no promise then.
            margin = {"Fitted": numpy.inf}.get(method, 1e-4)
            found = check_all(representation, native, surfaces, margin)
            found += check_slices(section, time, native, representation.materials)
            if step is steps[4] and method == "Direct":
                found += check_location(grid, representation, native.samples)
                found += check_perturbations(representation, native, surfaces)
            print(f"t = {time}, {method}: {len(representation.cells)} cells, {len(found)} faults")
            faults += [f"t = {time}, {method}: {fault}" for fault in found]
        if step is steps[4]:
            faults += check_certified(tetrahedra, time, native, surfaces)
        tetrahedra.ErrorMethod = "Direct"
    if faults:
        sys.exit("\n".join(faults))


if __name__ == "__main__":
    main()
