"""Asks for meshes of at most so many tetrahedra and prints the errors that each achieves.

    pvpython levels_by_budget.py
"""
from paraview import simple
from strata_example import data, field_value, load_plugin, read_impact

load_plugin()
case = read_impact()
# With saturated errors a larger budget gives a refinement of a smaller one's mesh.
tetrahedra = simple.MultiresolutionTetrahedra(
    Input=case, FieldArrays=["density"], InterfaceErrorBound=0.05, AbsoluteFieldErrorBounds=["density", "0.5"],
    ErrorMethod="Saturated", LimitCells=1)
print(f"{'budget':>9}{'cells':>9}{'interface':>11}{'density':>9}  stopped by")
for budget in (1000, 3000, 10000, 30000, 100000):
    tetrahedra.MaximumNumberOfCells = budget
    mesh = data(tetrahedra)
    print(f"{budget:9}{mesh.GetNumberOfCells():9}{field_value(mesh, 'achieved_interface_error'):11.4f}"
          f"{field_value(mesh, 'achieved_field_error_density'):9.3f}  {field_value(mesh, 'stopped_by')}")
