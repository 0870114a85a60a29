"""Measures a representation against its simulation and prints what was found beside what was claimed.

    pvpython error_table.py
"""
from paraview import simple
from strata_example import data, load_plugin, read_impact

load_plugin()
case = read_impact()
interfaces = simple.MaterialInterfaces(Input=case)
tetrahedra = simple.MultiresolutionTetrahedra(
    Input=case, Interfaces=interfaces, FieldArrays=["density", "pressure"], InterfaceErrorBound=0.15,
    FieldErrorBound=0.02)
errors = data(simple.RepresentationError(Input=tetrahedra, Original=case, Interfaces=interfaces))


def rows(kind):
    """The rows of a kind, each as a dictionary."""
    names = [errors.GetColumnName(column) for column in range(errors.GetNumberOfColumns())]
    for row in range(errors.GetNumberOfRows()):
        values = {name: errors.GetValueByName(row, name) for name in names}
        values = {name: value.ToString() if name in texts else value.ToDouble() for name, value in values.items()}
        if values["kind"] == kind:
            yield values


texts = ("kind", "material", "other_material", "field")
print(f"{'field':10}{'material':12}{'samples':>9}{'largest':>11}{'mean':>11}{'claimed':>11}")
for row in rows("field"):
    print(f"{row['field']:10}{row['material']:12}{row['samples']:9.0f}{row['largest']:11.4g}{row['mean']:11.4g}"
          f"{row['claimed']:11.4g}")
print(f"\n{'interface':24}{'vertices':>9}{'largest':>11}{'claimed':>11}   Hausdorff there, back")
for row in rows("interface"):
    pair = f"{row['material']} / {row['other_material']}"
    print(f"{pair:24}{row['samples']:9.0f}{row['largest']:11.4g}{row['claimed']:11.4g}"
          f"   {row['original_to_represented_upper']:.3f}, {row['represented_to_original_upper']:.3f}")
for row in rows("misclassified"):
    print(f"\nmisclassified volume {row['misclassified_volume']:.3f} +- {row['misclassified_volume_error']:.3f}")
