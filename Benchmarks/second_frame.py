"""What the second frame of a series costs where only fields change, and where all but the grid does.

    PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 Benchmarks/second_frame.py [FIRST.vtr SECOND.vtr]

The files are time steps of the impact (those of Data by default), on one grid. In the column "fields", the second
frame has the first one's grid and fractions and another density, which bends the first one's by a wave; in "all", it is
the second file. Each number is the processor time that a filter which has seen nothing takes for the second frame, over
that of a filter which has just made the first frame: the median of several runs.
"""
import argparse
from pathlib import Path

import numpy
import strata
from compare_levels_time import Duration
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkCellCenters
from vtkmodules.vtkIOXML import vtkXMLRectilinearGridReader

FIELD = "density"
REPETITIONS = 5
INTERFACE_BOUND, FIELD_BOUND = 0.15, 0.1
IMPACT = Path(__file__).parent.parent / "Data" / "impact"


def read(path):
    reader = vtkXMLRectilinearGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def unstructured(data):
    append = vtkAppendFilter()
    append.AddInputData(data)
    append.Update()
    return append.GetOutput()


def with_another_field(data):
    """The same grid and fractions; each density bends by a wave of one period along x."""
    centers = vtkCellCenters()
    centers.SetInputData(data)
    centers.Update()
    x = vtk_to_numpy(centers.GetOutput().GetPoints().GetData())[:, 0]
    wave = 1.0 + 0.2 * numpy.sin(2.0 * numpy.pi * x / numpy.ptp(x))
    changed = data.NewInstance()
    changed.ShallowCopy(data)
    cells = changed.GetCellData()
    for name in [cells.GetArrayName(a) for a in range(cells.GetNumberOfArrays())]:
        if name.startswith(FIELD):
            array = numpy_to_vtk(vtk_to_numpy(data.GetCellData().GetArray(name)) * wave, deep=True)
            array.SetName(name)
            cells.AddArray(array)
    return changed


def mesh(native_elements):
    made = strata.vtkStrataTetrahedra()
    made.AddFieldArray(FIELD)
    made.SetNativeElements(native_elements)
    made.SetInterfaceErrorBound(INTERFACE_BOUND)
    made.SetFieldErrorBound(FIELD_BOUND)
    return made


def frame(algorithm, data):
    """Processor time of a frame."""
    algorithm.SetInputDataObject(0, data)
    return Duration.of(algorithm.Update).processor


FILTERS = {"mesh, errors at points": lambda: mesh(0), "mesh, errors over cells": lambda: mesh(1),
           "interfaces alone": strata.vtkStrataMaterialInterfaces}


def ratio(first, second, new_filter):
    """Fresh over kept; and how often the interfaces were extracted for both frames."""
    fresh_times, kept_times = [], []
    for _ in range(REPETITIONS):
        kept, fresh = new_filter(), new_filter()
        frame(kept, first)
        kept_times.append(frame(kept, second))
        fresh_times.append(frame(fresh, second))
        cells = [algorithm.GetOutputDataObject(0).GetNumberOfCells() for algorithm in (kept, fresh)]
        assert cells[0] == cells[1]
    return numpy.median(fresh_times) / numpy.median(kept_times), kept.GetNumberOfExtractions()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", type=Path, nargs="*", default=[IMPACT / f"impact_32_0{step}.vtr" for step in (3, 4)])
    first, second = (read(path) for path in parser.parse_args().files)
    print(f"{first.GetNumberOfCells()} native cells; fresh / kept (extractions)")
    print(f"{'grid':14}{'filter':26}{'fields':>12}{'all':>12}")
    for grid, convert in (("rectilinear", lambda data: data), ("unstructured", unstructured)):
        frames = convert(first), convert(second)
        for name, new_filter in FILTERS.items():
            found = [ratio(frames[0], after, new_filter) for after in (with_another_field(frames[0]), frames[1])]
            columns = "".join(f"{value:8.2f} ({extractions})" for value, extractions in found)
            print(f"{grid:14}{name:26}{columns}", flush=True)


main()
