"""A two-phase flow as OpenFOAM writes it: one fraction, alpha.water, and fields of the mixture. What the fraction leaves
is named by RemainderMaterial. The grid is made here: a drop over a wavy pool.

    pvpython two_phase.py
"""
import numpy
from paraview import simple
from strata_example import data, field_value, load_plugin, output
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

CELLS = 24


def flow():
    """The grid with alpha.water and the pressure p in cells; x runs fastest."""
    grid = vtkImageData()
    grid.SetDimensions(CELLS + 1, CELLS + 1, CELLS + 1)
    grid.SetSpacing(1.0 / CELLS, 1.0 / CELLS, 1.0 / CELLS)
    centres = (numpy.arange(CELLS) + 0.5) / CELLS
    z, y, x = numpy.meshgrid(centres, centres, centres, indexing="ij")
    surface = 0.35 + 0.05 * numpy.sin(6.0 * x) - z
    drop = 0.14 - numpy.sqrt((x - 0.5) ** 2 + (y - 0.5) ** 2 + (z - 0.7) ** 2)
    water = numpy.clip(0.5 + CELLS * numpy.maximum(surface, drop), 0.0, 1.0)
    pressure = 1e5 + 9810.0 * numpy.maximum(surface, 0.0)
    for name, values in (("alpha.water", water), ("p", pressure)):
        array = numpy_to_vtk(values.ravel(), deep=True)
        array.SetName(name)
        grid.GetCellData().AddArray(array)
    return grid


load_plugin()
source = simple.TrivialProducer()  # in your script: OpenDataFile("case.foam")
source.GetClientSideObject().SetOutput(flow())
source.UpdatePipeline()

# Without the name the rest would be called "empty", and have no fields.
tetrahedra = simple.MultiresolutionTetrahedra(
    Input=source, RemainderMaterial="air", FieldArrays=["p"], InterfaceErrorBound=0.02, FieldErrorBound=0.02)
mesh = data(tetrahedra)
names = mesh.GetFieldData().GetAbstractArray("material_names")
print("materials:", ", ".join(names.GetValue(i) for i in range(names.GetNumberOfValues())))
print(f"{mesh.GetNumberOfCells()} tetrahedra, {field_value(mesh, 'stopped_by')}")
for material in ("water", "air"):
    pieces = simple.ExtractMaterials(Input=tetrahedra, Materials=[material])
    volume = data(simple.IntegrateVariables(Input=pieces)).GetCellData().GetArray("Volume").GetValue(0)
    print(f"{material}: volume {volume:.4f}")
simple.SaveData(output("water.vtu"), proxy=simple.ExtractMaterials(Input=tetrahedra, Materials=["water"]),
                DataMode="Binary")
