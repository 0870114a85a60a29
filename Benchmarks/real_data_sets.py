"""The data sets that benchmarks run on, and what else is made of them: fields at points, polyhedra."""
import numpy
from vtkmodules import vtkIOXML
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, vtkCompositeDataSet, vtkHyperTreeGrid, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkCellDataToPointData
from vtkmodules.vtkFiltersHyperTree import vtkHyperTreeGridToUnstructuredGrid

# File, and what to set where the conventions of names don't say it.
DATA_SETS = {
    "impact 32": ("impact/impact_32_04.vtr", {"field": "density", "without": ["empty"]}),
    "impact 64": ("impact/impact_64_04.vtr", {"field": "density", "without": ["empty"]}),
    "impact 128": ("impact/impact_128_04.vtr", {"field": "density", "without": ["empty"]}),
    "dam break": ("openfoam/damBreak4phase_t0.30.vtr", {"field": "p_rgh"}),
    "dam break cells": ("openfoam/damBreak4phase_t0.30.vtu", {"field": "p_rgh"}),
    "dam break polyhedra": ("openfoam/damBreak4phase_t0.30.vtu", {"field": "p_rgh", "polyhedra": True}),
    "obstacle": ("openfoam/damBreakWithObstacle_t0.30.vtu", {"field": "p_rgh"}),
    "charge 0.00": ("openfoam/depthCharge3D_t0.00.vti", {"field": "T"}),
    "charge 0.08": ("openfoam/depthCharge3D_t0.08.vti", {"field": "T"}),
    "charge 0.17": ("openfoam/depthCharge3D_t0.17.vtu", {"field": "T"}),
    "sloshing 2": ("openfoam/sloshingTank3D_t2.00.vts", {"field": "p_rgh"}),
    "sloshing 8": ("openfoam/sloshingTank3D_t8.00.vtu", {"field": "p_rgh"}),
    "triple point": ("laghos/tp_008.vtu", {"field": "density", "point field": "velocity", "ids": "region"}),
    "triple curved": ("laghos/tp_ho_008.vtu", {"field": "density", "point field": "density", "ids": "region"}),
    "sedov": ("laghos/sedov_003.vtu", {"field": "density", "point field": "velocity", "ids": "material"}),
    "drop": ("gerris/drop_0.20.vtu", {"field": "pressure", "remainder": "gas"}),
    "cth": ("cth/cth.vtr", {"field": "Pressure", "without": ["Void"]}),
    "spcth amr": ("spcth/spcth_t4.vth", {"field": "Pressure (dynes/cm^2^)", "without": ["empty"]}),
    "spcth leaves": ("spcth/spcth_leaves_t4.vtu", {"field": "Pressure (dynes/cm^2^)", "without": ["Void"]}),
    "spcth trees": ("spcth/spcth_t4.htg", {"field": "Pressure (dynes/cm^2^)", "without": ["Void"]}),
    "frog": ("frog/frog_vf_4x.vti", {}),
}
# Corners of the faces of a hexahedron, seen from outside.
HEXAHEDRON = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]


def as_numpy(array):
    return vtk_to_numpy(array).astype(float)


def read(path):
    readers = {".vth": "vtkXMLUniformGridAMRReader", ".htg": "vtkXMLHyperTreeGridReader"}
    reader = getattr(vtkIOXML, readers.get(path.suffix, "vtkXMLGenericDataObjectReader"))()
    reader.SetFileName(str(path))
    if path.suffix == ".vth":
        reader.SetMaximumLevelsToReadByDefault(0)
    reader.Update()
    return reader.GetOutputDataObject(0)


def load(folder, name):
    """A data set, and what to set for it."""
    file, settings = DATA_SETS[name]
    data = read(folder / file)
    return (as_polyhedra(data) if "polyhedra" in settings else data), settings


def leaves(data):
    """The data sets that hold cells."""
    if isinstance(data, vtkHyperTreeGrid):
        convert = vtkHyperTreeGridToUnstructuredGrid()
        convert.SetInputData(data)
        convert.Update()
        return [convert.GetOutput()]
    if not isinstance(data, vtkCompositeDataSet):
        return [data]
    iterator, result = data.NewIterator(), []
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        result.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return result


def as_polyhedra(data):
    """The same grid, its hexahedra given by their faces."""
    result = vtkUnstructuredGrid()
    result.SetPoints(data.GetPoints())
    corners = vtk_to_numpy(data.GetCells().GetConnectivityArray()).reshape(-1, 8)
    faces = vtkIdList()
    for cell in corners:
        faces.Reset()
        faces.InsertNextId(len(HEXAHEDRON))
        for face in HEXAHEDRON:
            for value in (4, *cell[list(face)]):
                faces.InsertNextId(int(value))
        result.InsertNextCell(VTK_POLYHEDRON, faces)
    result.GetCellData().ShallowCopy(data.GetCellData())
    result.GetPointData().ShallowCopy(data.GetPointData())
    return result


def visible(data):
    """Which cells are no ghosts."""
    ghosts = data.GetCellData().GetArray("vtkGhostType")
    return vtk_to_numpy(ghosts) == 0 if ghosts else numpy.ones(data.GetNumberOfCells(), bool)


def averages_at_points(data, columns):
    """The mean over the cells round each point of each row of numbers in `columns` (an array, cells first)."""
    grid = data.NewInstance()
    grid.CopyStructure(data)
    grid.GetCellData().Initialize()
    array = numpy_to_vtk(numpy.ascontiguousarray(columns), deep=True)
    array.SetName("columns")
    grid.GetCellData().AddArray(array)
    convert = vtkCellDataToPointData()
    convert.SetInputData(grid)
    convert.Update()
    return as_numpy(convert.GetOutput().GetPointData().GetArray("columns")).reshape(data.GetNumberOfPoints(), -1)


def with_field_at_points(data, field, fraction_of):
    """The data set with a field moved from the cells to the points: the mean of the cells round each, weighed with
    the fraction of the material for arrays `<field>_<material>`. None where the field is in no cells of one grid.
    `fraction_of`: a material's name -> its fractions in the cells."""
    cells = data.GetCellData() if hasattr(data, "GetCellData") and not isinstance(data, vtkHyperTreeGrid) else None
    names = [] if cells is None else [cells.GetArrayName(i) for i in range(cells.GetNumberOfArrays())]
    names = [name for name in names if name == field or name.startswith(field + "_")]
    if not names:
        return None
    result = data.NewInstance()
    result.ShallowCopy(data)
    for name in names:
        weights = visible(data).astype(float)
        if name != field:
            weights = weights * fraction_of(name[len(field) + 1:])
        values = as_numpy(cells.GetArray(name)).reshape(len(weights), -1)
        sums = averages_at_points(data, numpy.column_stack([weights, weights[:, None] * values]))
        means = sums[:, 1:] / numpy.where(sums[:, :1] > 0.0, sums[:, :1], 1.0)
        array = numpy_to_vtk(means if means.shape[1] > 1 else means[:, 0].copy(), deep=True)
        array.SetName(name)
        result.GetCellData().RemoveArray(name)
        result.GetPointData().AddArray(array)
    return result
