"""Levels of detail beside the alternatives: build, change of level, slice, memory; and cells at equal true error.

Everything of a table is measured in one run. ParaView's package in Debian is compiled without optimization: see
compare_levels_others.py for what is done about that. Cells and errors don't depend on it.
"""
import itertools
from pathlib import Path

import compare_levels_error as errors
import compare_levels_others as others
import compare_levels_plot as plots
import strata_example
from compare_levels_time import REPETITIONS, Duration, median, resident_mebibytes, return_memory
from paraview import simple
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

# Name, file in the data folder, the field, and bounds of the interface and the field in their own units.
CASES = [
    ("impact 32", "impact/impact_32_04.vtr", "density", 0.05, 0.3),
    ("impact 64", "impact/impact_64_04.vtr", "density", 0.03, 0.15),
    ("impact 128", "impact/impact_128_04.vtr", "density", 0.015, 0.08),
    ("CTH", "cth/cth.vtr", "Pressure", 0.1, 2e8),
]
NORMAL = (0.4, 0.9, 0.15)


def output_of(proxy):
    return proxy.GetClientSideObject().GetOutputDataObject(0)


class Levels:
    """A multiresolution mesh whose bounds can be moved."""

    def __init__(self, source, field, interface_bound, field_bound, materials=True):
        self.bounds = (interface_bound, field_bound)
        self.proxy = simple.MultiresolutionTetrahedra(Input=source)
        self.proxy.FieldArrays = [field]
        self.field = field
        if not materials:
            self.proxy.VolumeFractionArrays = []
            self.proxy.MaterialIdArray = "all"

    def move(self, scale):
        self.proxy.InterfaceErrorBound = scale * self.bounds[0]
        self.proxy.AbsoluteFieldErrorBounds = [self.field, str(scale * self.bounds[1])]
        self.proxy.UpdateVTKObjects()

    def update(self, scale=None):
        if scale:
            self.move(scale)
        self.proxy.UpdatePipeline()


def copying(mesh, before):
    return median(lambda: vtkUnstructuredGrid().DeepCopy(mesh), before=before)


def changing(levels):
    """From bounds a fifth looser to those of the level, into fresh memory as the copy."""

    def prepare():
        levels.update(1.2)
        levels.move(1.0)
        return_memory()

    return median(levels.update, before=prepare)


def dragged_places(mesh):
    """Origins of a plane that is dragged through the middle of a mesh."""
    bounds = mesh.GetBounds()
    x, y, z = (0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]) for axis in range(3))
    step = 1e-4 * mesh.GetLength()
    return ([x + step * count, y, z] for count in itertools.count())


def slicing(levels, places):
    """Dragging a plane: the median of slices of a mesh that has been sliced before."""
    cut = simple.MaterialSlice(Input=levels.proxy)
    cut.SliceType.Normal = NORMAL

    def move():
        cut.SliceType.Origin = next(places)
        cut.UpdateVTKObjects()

    for _ in range(2):  # the second slice of a mesh makes the search structure
        move()
        cut.UpdatePipeline()
    result = median(cut.UpdatePipeline, before=move)
    simple.Delete(cut)
    return result


def ratio(first, second):
    """Of processor times, then of wall times."""
    of_processor, of_wall = first.processor / second.processor, first.wall / second.wall
    return f"{of_wall:.1f} ({of_processor:.1f})" if of_wall > 0.5 else f"1/{1 / of_wall:.0f} (1/{1 / of_processor:.0f})"


def measure(source, field, interface_bound, field_bound, materials=True):
    """The column of a data set: a row for each measure."""
    before = resident_mebibytes()
    levels = Levels(source, field, interface_bound, field_bound, materials)
    build = Duration.of(lambda: levels.update(1.0))
    held = resident_mebibytes() - before
    change = changing(levels)
    mesh = output_of(levels.proxy)
    copy = copying(mesh, return_memory)
    reused = copying(mesh, lambda: None)
    slice_ = slicing(levels, dragged_places(mesh))
    cuts = others.cutters(mesh, NORMAL, dragged_places(mesh))
    tree, leaves = others.hyper_tree(source, field, field_bound) if others.load_hyper_trees() else (None, None)
    row = {
        "native cells": output_of(source).GetNumberOfCells(),
        "cells": mesh.GetNumberOfCells(),
        "build = rebuild from scratch": build,
        "change of level": change,
        "change to build": ratio(change, build),
        "deep copy of the mesh": copy,
        "change to copy": ratio(change, copy),
        "deep copy, memory reused": reused,
        "Material Slice, dragged": slice_,
        "Plane Cutter": cuts["vtkPlaneCutter"],
        "3D Linear Grid Plane Cutter": cuts["vtk3DLinearGridPlaneCutter"],
        "Cutter (Slice)": cuts["vtkCutter"],
        "slice to the quickest of them": ratio(slice_, min(cuts.values(), key=lambda cut: cut.wall)),
        "Resample To Hyper Tree Grid": tree,
        "its leaves": leaves,
        "Resample To Image, as many points": others.image(source, mesh),
        "quadric decimation to half": others.decimation(mesh, field),
        "MiB that the filter holds": round(held),
        "bytes a cell of the mesh": round(1024 * mesh.GetActualMemorySize() / mesh.GetNumberOfCells()),
    }
    simple.Delete(levels.proxy)
    return row


def columns(data_folder):
    """(name, rows) of the data sets that are at hand, and of the analytic fields."""
    for name, file, *rest in CASES:
        if (data_folder / file).exists():
            reader = simple.OpenDataFile(str(data_folder / file))
            reader.UpdatePipeline()
            yield name, measure(reader, *rest)
            simple.Delete(reader)
    for name, field, bound, jump in (("jump", errors.jumping, 0.05, True), ("smooth field", errors.smooth, 0.002, False)):
        source = errors.producer(errors.grid(field))
        yield name, measure(source, "f", 0.1 * errors.LAYER, bound, materials=jump)
        simple.Delete(source)


def print_table(table):
    """A Markdown table with a row for each measure and a column for each data set."""
    print("| | " + " | ".join(name for name, _ in table) + " |")
    print("|---" * (len(table) + 1) + "|")
    for measured in table[0][1]:
        values = (row[measured] for _, row in table)
        print(f"| {measured} | " + " | ".join("-" if value is None else str(value) for value in values) + " |")
    print(flush=True)


def run(data_folder, output_folder):
    strata_example.load_plugin()
    # The alternatives get threads, too: by default VTK's run one after the other.
    vtkSMPTools.SetBackend("STDThread")
    vtkSMPTools.Initialize(0)
    table = list(columns(data_folder))
    print(f"Milliseconds: wall time (processor time), medians of {REPETITIONS}; builds, resampling, decimation: once.")
    print("VTK's plane cutters and decimation are " + ("optimized" if others.optimized() else "as packaged") + "; left out: "
          f"decimation of more than {others.MOST_CELLS_TO_DECIMATE} cells, resampling at more than "
          f"{others.MOST_POINTS_TO_RESAMPLE} points (both take minutes)\n")
    print_table(table)
    output_folder.mkdir(parents=True, exist_ok=True)
    plots.plot("times", table, output_folder)
    plots.plot("errors", errors.run(others.load_hyper_trees()), output_folder)
    program = Path(__file__).resolve().parent.parent / "build" / "Benchmarks" / "BenchmarkScale"
    plots.plot("scale", plots.scale_points(program), output_folder)
