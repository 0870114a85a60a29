"""For a batch job, without a window or display: every step's slice as a file, and a table of cells and errors.

    pvbatch batch_series.py
"""
import csv

from paraview import simple
from strata_example import data, field_value, load_plugin, output, read_impact

load_plugin()
case = read_impact()
tetrahedra = simple.MultiresolutionTetrahedra(
    Input=case, FieldArrays=["density"], InterfaceErrorBound=0.3, AbsoluteFieldErrorBounds=["density", "1"])
section = simple.MaterialSlice(Input=tetrahedra)
section.SliceType.Origin = [0.0, 0.0, 0.0]
section.SliceType.Normal = [0.0, 1.0, 0.0]

with open(output("batch_series.csv"), "w", newline="") as file:
    table = csv.writer(file)
    table.writerow(["time", "cells", "interface error", "density error", "stopped by"])
    for step, time in enumerate(case.TimestepValues):
        simple.GetTimeKeeper().Time = time
        mesh = data(tetrahedra)
        table.writerow([time, mesh.GetNumberOfCells(), field_value(mesh, "achieved_interface_error"),
                        field_value(mesh, "achieved_field_error_density"), field_value(mesh, "stopped_by")])
        data(section)
        simple.SaveData(output(f"batch_slice_{step:02d}.vtp"), proxy=section, DataMode="Binary")
print("wrote", step + 1, "slices and batch_series.csv")
