"""Cuts the solid pieces of each material out and integrates over them: volume and mass, beside the simulation's own.

    pvpython material_volumes.py
"""
from paraview import simple
from strata_example import data, load_plugin, read_impact
from vtkmodules.numpy_interface import dataset_adapter


def represented(tetrahedra, material):
    """Volume and mass of a material in the representation."""
    pieces = simple.ExtractMaterials(Input=tetrahedra, Materials=[material])
    total = dataset_adapter.WrapDataObject(data(simple.IntegrateVariables(Input=pieces)))
    return total.CellData["Volume"][0], total.PointData["density"][0]


def simulated(grid, material):
    """The same from the volume fractions and densities of the simulation's cells."""
    sized = simple.CellSize(Input=grid, ComputeVertexCount=0, ComputeLength=0, ComputeArea=0, ComputeVolume=1)
    cells = dataset_adapter.WrapDataObject(data(simple.MergeBlocks(Input=sized))).CellData
    volumes = cells["Volume"] * cells["volume_fraction_" + material]
    return volumes.sum(), (volumes * cells["density_" + material]).sum()


load_plugin()
case = read_impact()
grid = simple.ExtractBlock(Input=case, Selectors=["/Root/grid"])
tetrahedra = simple.MultiresolutionTetrahedra(
    Input=case, FieldArrays=["density"], InterfaceErrorBound=0.05, AbsoluteFieldErrorBounds=["density", "0.3"])
print(f"{'material':12}{'volume':>12}{'simulated':>12}{'mass':>12}{'simulated':>12}")
for material in ("projectile", "block"):
    volume, mass = represented(tetrahedra, material)
    true_volume, true_mass = simulated(grid, material)
    print(f"{material:12}{volume:12.2f}{true_volume:12.2f}{mass:12.2f}{true_mass:12.2f}")
