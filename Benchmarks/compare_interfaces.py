"""Interfaces beside those of Youngs' filter, Contour and Extract CTH Parts.

Volumes per cell do not come from Strata: compare_measure.py takes them from the triangles, and from the planes
that Youngs' filter makes. The other filters get their fractions the way a user would hand them over.
"""
import time

import compare_data
import compare_measure
import numpy
import strata_example
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataObject, vtkMultiBlockDataSet
from vtkmodules.vtkFiltersCore import vtkCellDataToPointData, vtkContourFilter, vtkPointDataToCellData
from vtkmodules.vtkFiltersGeneral import vtkGradientFilter, vtkYoungsMaterialInterface

CONTOUR_VALUE = 0.5


class Result:
    """What a method makes of a case: for each material the triangles that bound it, corners ordered by normals that
    point out of it; for Youngs' filter also (cells, planes), a plane that bounds it in each cell; and the time."""

    def __init__(self, seconds, surfaces, planes=None):
        self.seconds, self.surfaces, self.planes = seconds, surfaces, planes


def triangles_of(surface):
    """The corners of a vtkPolyData's triangles, [triangle, corner, axis]; polygons become fans."""
    if surface.GetNumberOfPoints() == 0:
        return numpy.zeros((0, 3, 3))
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    offsets = vtk_to_numpy(surface.GetPolys().GetOffsetsArray())
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray())
    sizes = numpy.diff(offsets)
    pieces = [numpy.stack([corners[offsets[:-1][sizes > k + 1]], corners[offsets[:-1][sizes > k + 1] + k],
                         corners[offsets[:-1][sizes > k + 1] + k + 1]], axis=1)
            for k in range(1, sizes.max(initial=0) - 1)]
    return points[numpy.concatenate(pieces)] if pieces else numpy.zeros((0, 3, 3))


def timed(algorithm):
    """The processor time of a filter, over all its threads."""
    start = time.process_time()
    algorithm.Update()
    return time.process_time() - start


def strata(case, corrected, gathered=True):
    """MaterialInterfaces."""
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(case.grid)
    proxy = simple.MaterialInterfaces(Input=source, VolumeFractionArrays=case.names, VolumeCorrection=int(corrected),
                                      GatherSmearedFractions=int(gathered))
    proxy.UpdateVTKObjects()
    source.UpdatePipeline()
    algorithm = proxy.GetClientSideObject()
    start = time.process_time()
    proxy.UpdatePipeline()
    seconds = time.process_time() - start
    collection = algorithm.GetOutputDataObject(0)
    surfaces = [[] for _ in case.names]
    for block in range(collection.GetNumberOfPartitionedDataSets()):
        surface = collection.GetPartition(block, 0)
        if surface and surface.GetNumberOfCells():
            triangles = triangles_of(surface)
            for side, turned in (("positive_material", triangles[:, ::-1]), ("negative_material", triangles)):
                material = surface.GetCellData().GetArray(side).GetValue(0)
                if material < len(surfaces):  # not the outside of hidden cells
                    surfaces[material].append(turned)
    simple.Delete(proxy)
    simple.Delete(source)
    return Result(seconds, [numpy.concatenate(s) if s else numpy.zeros((0, 3, 3)) for s in surfaces])


def contour(case):
    """Contour at one half for each material, after Cell Data to Point Data."""
    points = vtkCellDataToPointData()
    points.SetInputData(case.grid)
    seconds = timed(points)
    surfaces = []
    for name in case.names:
        contours = vtkContourFilter()
        contours.SetInputData(points.GetOutput())
        contours.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, name)
        contours.SetValue(0, CONTOUR_VALUE)
        contours.ComputeNormalsOff()
        seconds += timed(contours)
        surfaces.append(triangles_of(contours.GetOutput()))
    return Result(seconds, surfaces)


def cth_parts(case):
    """Extract CTH Parts: a closed surface per material."""
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, case.grid)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(blocks)
    proxy = simple.ExtractCTHParts(Input=source, VolumeArrays=case.names, VolumeFractionValue=CONTOUR_VALUE,
                                   GenerateTriangles=1)
    source.UpdatePipeline()
    start = time.process_time()
    proxy.UpdatePipeline()
    seconds = time.process_time() - start
    output = proxy.GetClientSideObject().GetOutputDataObject(0)
    surfaces = [numpy.zeros((0, 3, 3)) for _ in case.names]
    for block in range(output.GetNumberOfBlocks()):
        name = output.GetMetaData(block).Get(vtkCompositeDataSet.NAME())
        material = next(m for m, array in enumerate(case.names) if array in name)
        surfaces[material] = numpy.concatenate([surfaces[material]]
                                               + [triangles_of(part) for part in leaves(output.GetBlock(block))])
    simple.Delete(proxy)
    simple.Delete(source)
    return Result(seconds, surfaces)


def leaves(data):
    """The poly data in a tree of blocks."""
    if data is None:
        return
    if not data.IsA("vtkCompositeDataSet"):
        yield data
        return
    iterator = data.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        yield iterator.GetCurrentDataObject()
        iterator.GoToNextItem()


def youngs(case):
    """Youngs' filter, once per material, with normals from Gradient.

    With several materials at once the filter of VTK 9.2 is stuck for seconds per hundred cells, and gives as much.
    """
    points = vtkCellDataToPointData()
    points.SetInputData(case.grid)
    seconds = timed(points)
    grid = case.grid.NewInstance()
    grid.ShallowCopy(case.grid)
    compare_data.add_array(grid, "cell", numpy.arange(case.mixed().size).reshape(case.mixed().shape))
    surfaces, planes = [], []
    for name in case.names:
        gradient = vtkGradientFilter()
        gradient.SetInputData(points.GetOutput())
        gradient.SetInputScalars(vtkDataObject.FIELD_ASSOCIATION_POINTS, name)
        gradient.SetResultArrayName("normal")
        seconds += timed(gradient)
        cells = vtkPointDataToCellData()
        cells.SetInputConnection(gradient.GetOutputPort())
        seconds += timed(cells)
        # The filter wants normals that point out of the material.
        outwards = numpy_to_vtk(-vtk_to_numpy(cells.GetOutput().GetCellData().GetArray("normal")), deep=1)
        outwards.SetName("normal")
        grid.GetCellData().AddArray(outwards)
        polygons, time_of_polygons = youngs_polygons(grid, name)
        seconds += time_of_polygons
        surfaces.append(numpy.concatenate([fans(polygon) for polygon, _ in polygons] + [numpy.zeros((0, 3, 3))]))
        planes.append((numpy.array([cell for _, cell in polygons], dtype=int),
                       numpy.array([plane_of(polygon) for polygon, _ in polygons])))
    return Result(seconds, surfaces, planes)


def youngs_polygons(grid, name):
    """(corners, cell) of each polygon that the filter makes, and the time."""
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, grid)
    algorithm = vtkYoungsMaterialInterface()
    algorithm.SetInputData(blocks)
    algorithm.SetFillMaterial(False)
    algorithm.UseAllBlocksOn()
    algorithm.SetNumberOfMaterials(1)
    algorithm.SetMaterialVolumeFractionArray(0, name)
    algorithm.SetMaterialNormalArray(0, "normal")
    seconds = timed(algorithm)
    result = []
    for part in leaves(algorithm.GetOutput()):
        points = vtk_to_numpy(part.GetPoints().GetData()).astype(float)
        offsets = vtk_to_numpy(part.GetCells().GetOffsetsArray())
        corners = vtk_to_numpy(part.GetCells().GetConnectivityArray())
        cells = vtk_to_numpy(part.GetCellData().GetArray("cell"))
        result += [(points[corners[begin:end]], cell) for begin, end, cell in zip(offsets, offsets[1:], cells)
                   if end - begin > 2]
    return result, seconds


def fans(polygon):
    return numpy.stack([numpy.broadcast_to(polygon[0], polygon[2:].shape), polygon[1:-1], polygon[2:]], axis=1)


def plane_of(polygon):
    """(unit normal, its product with the plane's points)."""
    normal = numpy.cross(polygon[1:-1] - polygon[0], polygon[2:] - polygon[0]).sum(axis=0)
    normal /= numpy.linalg.norm(normal) or 1.0
    return [*normal, polygon.mean(axis=0) @ normal]


METHODS = {"Strata, corrected": lambda case: strata(case, True),
           "Strata, smeared cells each for itself": lambda case: strata(case, True, False),
           "Strata, uncorrected": lambda case: strata(case, False),
           "Contour, once per material": contour, "Extract CTH Parts": cth_parts, "Youngs": youngs}


def run(data_folder, _output_folder):
    """Prints a table per case."""
    strata_example.load_plugin()
    for case in compare_data.cases(data_folder):
        measure = compare_measure.Measure(case)
        print(f"\n**{case.title}**: {case.fractions[0].size} cells, {measure.mixed.sum()} mixed, "
              f"{len(measure.points)} points in cells of three materials\n\n"
              "| method | volume error of a mixed cell: largest, mean | cells above 0.01 | points in no, in several "
              "materials | open edges | µs CPU per mixed cell |\n|---|---|---|---|---|---|", flush=True)
        for name, method in METHODS.items():
            result = method(case)
            largest, mean, above, cells = measure.volume_errors(result)
            none, several = measure.gaps(result)
            print(f"| {name} | {largest:.2g}, {mean:.2g} | {above} of {cells} | {none:.1%}, {several:.1%} "
                  f"| {measure.open_edges(result)} | {1e6 * result.seconds / measure.mixed.sum():.1f} |", flush=True)
