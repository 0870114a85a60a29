"""Refines every step of a simulation to the same bounds: the mesh follows the interfaces.

    pvpython time_series.py
"""
from paraview import simple
from strata_example import data, field_value, load_plugin, read_impact

load_plugin()
case = read_impact()
tetrahedra = simple.MultiresolutionTetrahedra(
    Input=case, FieldArrays=["density"], InterfaceErrorBound=0.15, AbsoluteFieldErrorBounds=["density", "0.5"])
print(f"{'time':>7}{'cells':>9}{'interface':>11}{'density':>9}")
for time in case.TimestepValues:
    simple.GetTimeKeeper().Time = time
    mesh = data(tetrahedra)
    print(f"{time:7.1f}{mesh.GetNumberOfCells():9}{field_value(mesh, 'achieved_interface_error'):11.4f}"
          f"{field_value(mesh, 'achieved_field_error_density'):9.3f}")
