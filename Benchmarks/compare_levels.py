"""Levels of detail beside the alternatives: build, change of level, slice, memory; and cells at equal true error.

Everything of a table is measured in one run. ParaView's package in Debian is compiled without optimization, which makes
VTK's own filters slower than they need be; cells and errors don't depend on it.
"""
import ctypes
import time
from pathlib import Path

import compare_levels_error as errors
import compare_levels_plot as plots
import strata_example
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import (
    vtk3DLinearGridPlaneCutter,
    vtkCutter,
    vtkPlaneCutter,
    vtkUnstructuredGridQuadricDecimation,
)

# Name, file in the data folder, the field, and bounds of the interface and the field in their own units.
CASES = [
    ("impact 32", "impact/impact_32_04.vtr", "density", 0.05, 0.3),
    ("impact 64", "impact/impact_64_04.vtr", "density", 0.03, 0.15),
    ("impact 128", "impact/impact_128_04.vtr", "density", 0.015, 0.08),
    ("CTH", "cth/cth.vtr", "Pressure", 0.05, 1e8),
]
REPETITIONS = 7
# Quadric decimation takes time in proportion to a high power of the cells: larger meshes are left out.
MOST_CELLS_TO_DECIMATE = 150000


def median_seconds(action, repetitions=REPETITIONS, before=lambda: None):
    """The median wall time of an action, each time after `before`."""
    times = []
    for _ in range(repetitions):
        before()
        start = time.perf_counter()
        action()
        times.append(time.perf_counter() - start)
    return sorted(times)[repetitions // 2]


def output_of(proxy):
    return proxy.GetClientSideObject().GetOutputDataObject(0)


class Levels:
    """A multiresolution mesh whose bounds can be moved."""

    def __init__(self, source, field, interface_bound, field_bound):
        self.bounds = (interface_bound, field_bound)
        self.proxy = simple.MultiresolutionTetrahedra(Input=source)
        self.proxy.FieldArrays = [field]
        self.field = field

    def move(self, scale):
        self.proxy.InterfaceErrorBound = scale * self.bounds[0]
        self.proxy.AbsoluteFieldErrorBounds = [self.field, str(scale * self.bounds[1])]
        self.proxy.UpdateVTKObjects()

    def update(self, scale=None):
        if scale:
            self.move(scale)
        self.proxy.UpdatePipeline()


def return_memory():
    """Gives memory that is not in use back to the system.

    A mesh of some MiB that has just been freed leaves pages that the next one takes over at once; a larger one is mapped
    anew, page by page, which takes several times as long. Without this the times depend on what was freed before.
    """
    ctypes.CDLL(None).malloc_trim(0)


def copy_seconds(mesh, before):
    def copy():
        vtkUnstructuredGrid().DeepCopy(mesh)

    return median_seconds(copy, before=before)


def change_seconds(levels):
    """From bounds a fifth looser to those of the level, into fresh memory as the copy."""

    def prepare():
        levels.update(1.2)
        levels.move(1.0)
        return_memory()

    return median_seconds(levels.update, before=prepare)


def slice_seconds(levels, mesh):
    """Dragging a plane through the middle: Strata's slice, and VTK's cutters on the same tetrahedra."""
    bounds = mesh.GetBounds()
    center = [0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]) for axis in range(3)]
    step = 1e-4 * mesh.GetLength()
    normal = (0.4, 0.9, 0.15)
    places = iter(range(1000))
    result = {}
    cut = simple.MaterialSlice(Input=levels.proxy)
    cut.SliceType.Normal = normal

    def move():
        cut.SliceType.Origin = [center[0] + step * next(places), center[1], center[2]]
        cut.UpdateVTKObjects()

    for _ in range(2):  # the second slice of a mesh makes the search structure
        move()
        cut.UpdatePipeline()
    result["Material Slice"] = median_seconds(cut.UpdatePipeline, before=move)
    simple.Delete(cut)
    for cutter_class in (vtkPlaneCutter, vtk3DLinearGridPlaneCutter, vtkCutter):
        plane = vtkPlane()
        plane.SetNormal(normal)
        cutter = cutter_class()
        cutter.SetInputData(mesh)
        (cutter.SetCutFunction if cutter_class is vtkCutter else cutter.SetPlane)(plane)

        def move_plane(moved=plane):
            moved.SetOrigin(center[0] + step * next(places), center[1], center[2])

        move_plane()
        cutter.Update()
        result[cutter_class.__name__] = median_seconds(cutter.Update, before=move_plane)
    return result


def decimation_seconds(mesh, field):
    """To half the tetrahedra; None for meshes that it would take minutes."""
    if mesh.GetNumberOfCells() > MOST_CELLS_TO_DECIMATE:
        return None
    decimation = vtkUnstructuredGridQuadricDecimation()
    decimation.SetInputData(mesh)
    decimation.SetScalarsName(field)
    decimation.SetTargetReduction(0.5)
    return median_seconds(decimation.Update, 1)


def resample_seconds(source, mesh):
    """Resample To Image with as many points as the mesh has cells."""
    size = max(2, round(mesh.GetNumberOfCells() ** (1.0 / 3.0)))
    image = simple.ResampleToImage(Input=source)
    image.SamplingDimensions = [size, size, size]
    seconds = median_seconds(image.UpdatePipeline, 1)
    simple.Delete(image)
    return seconds


def milliseconds(seconds):
    return "-" if seconds is None else f"{1000.0 * seconds:.1f}"


def measure(name, path, field, interface_bound, field_bound):
    reader = simple.OpenDataFile(str(path))
    reader.UpdatePipeline()
    cells = output_of(reader).GetNumberOfCells()
    levels = Levels(reader, field, interface_bound, field_bound)
    build = median_seconds(lambda: levels.update(1.0), 1)
    change = change_seconds(levels)
    mesh = output_of(levels.proxy)
    copy = copy_seconds(mesh, return_memory)
    cuts = slice_seconds(levels, mesh)
    quickest = min(seconds for cutter, seconds in cuts.items() if cutter != "Material Slice")
    row = {
        "native cells": cells,
        "cells": mesh.GetNumberOfCells(),
        "build = rebuild": milliseconds(build),
        "change of level": milliseconds(change),
        "to build": f"1/{build / change:.1f}",
        "deep copy": milliseconds(copy),
        "to copy": f"{change / copy:.1f}",
        "deep copy, memory reused": milliseconds(copy_seconds(mesh, lambda: None)),
        "Material Slice": milliseconds(cuts["Material Slice"]),
        "Plane Cutter": milliseconds(cuts["vtkPlaneCutter"]),
        "3D Linear Grid Plane Cutter": milliseconds(cuts["vtk3DLinearGridPlaneCutter"]),
        "Cutter (Slice)": milliseconds(cuts["vtkCutter"]),
        "slice to quickest": f"1/{quickest / cuts['Material Slice']:.0f}",
        "Resample To Image": milliseconds(resample_seconds(reader, mesh)),
        "decimation to half": milliseconds(decimation_seconds(mesh, field)),
        "output bytes a cell": round(1024 * mesh.GetActualMemorySize() / mesh.GetNumberOfCells()),
    }
    simple.Delete(levels.proxy)
    simple.Delete(reader)
    return name, row


def print_table(columns):
    """A Markdown table with a row for each measure and a column for each data set."""
    print("| | " + " | ".join(name for name, _ in columns) + " |")
    print("|---" * (len(columns) + 1) + "|")
    for measured in columns[0][1]:
        print(f"| {measured} | " + " | ".join(str(row[measured]) for _, row in columns) + " |")
    print()


def run(data_folder, output_folder):
    strata_example.load_plugin()
    columns = [measure(name, data_folder / file, *rest) for name, file, *rest in CASES if (data_folder / file).exists()]
    print("Milliseconds, medians of seven (builds, resampling and decimation: once)\n")
    print_table(columns)
    curves = errors.run()
    scale = plots.scale_points(Path(__file__).resolve().parent.parent / "build" / "Benchmarks" / "BenchmarkScale")
    output_folder.mkdir(parents=True, exist_ok=True)
    plots.plot(columns, curves, scale, output_folder / "levels.png")
