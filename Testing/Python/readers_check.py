"""Files of other formats, written here and read by ParaView's own readers, become representations without further ado.

The same problem in each: a unit cube of 6^3 cells, water below x = 1/2 and air above, a density linear in each; two
time steps, in the second of which the water's is one more.
"""
import os
import subprocess
import sys
from pathlib import Path

import numpy
import strata
from paraview.modules.vtkPVVTKExtensionsIOCGNSWriter import vtkCGNSWriter
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkCellArray, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIOCGNSReader import vtkCGNSReader
from vtkmodules.vtkIOEnSight import vtkGenericEnSightReader
from vtkmodules.vtkIOExodus import vtkExodusIIReader, vtkExodusIIWriter
from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader
from vtkmodules.vtkIOHDF import vtkHDFReader
from vtkmodules.vtkIOXdmf2 import vtkXdmfReader, vtkXdmfWriter

FOLDER = Path(os.environ["STRATA_TEST_OUTPUT"]) / "Readers"
SIDE = 6
CORNERS = numpy.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)])
DENSITY_BOUND = 0.01
# Run by the system's Python: in ParaView's, h5py would meet another HDF5 library.
PYTHON = "/usr/bin/python3"
WRITE_VTKHDF = """
import sys, h5py, numpy
arrays = numpy.load(sys.argv[1])
with h5py.File(sys.argv[2], "w") as file:
    root = file.create_group("VTKHDF")
    root.attrs["Version"] = (1, 0)
    root.attrs.create("Type", b"UnstructuredGrid", dtype=h5py.string_dtype("ascii", 16))
    for name in arrays.files:
        root.create_dataset(name, data=arrays[name])
"""


def cells():
    """Lower corners of the cells, i fastest."""
    k, j, i = numpy.meshgrid(*[numpy.arange(SIDE)] * 3, indexing="ij")
    return numpy.stack([i.ravel(), j.ravel(), k.ravel()], axis=1)


def point_id(ijk):
    return ijk[..., 0] + (SIDE + 1) * (ijk[..., 1] + (SIDE + 1) * ijk[..., 2])


def density(x, y, time=0.0):
    return numpy.where(x < 0.5, 5.0 + y + time, 1.0 + x)


def centers():
    return (cells() + 0.5) / SIDE


def add(grid, name, values):
    array = numpy_to_vtk(numpy.asarray(values), deep=True)
    array.SetName(name)
    grid.GetCellData().AddArray(array)


def grid():
    """The cube as hexahedra, with material ids and densities."""
    result, points, array = vtkUnstructuredGrid(), vtkPoints(), vtkCellArray()
    k, j, i = numpy.meshgrid(*[numpy.arange(SIDE + 1) / SIDE] * 3, indexing="ij")
    points.SetData(numpy_to_vtk(numpy.stack([i.ravel(), j.ravel(), k.ravel()], axis=1), deep=True))
    result.SetPoints(points)
    corners = point_id(cells()[:, None] + CORNERS)
    array.SetData(numpy_to_vtkIdTypeArray(8 * numpy.arange(SIDE ** 3 + 1), deep=True),
                  numpy_to_vtkIdTypeArray(corners.ravel(), deep=True))
    result.SetCells(VTK_HEXAHEDRON, array)
    x, y, _ = centers().T
    add(result, "material", (1 + (x >= 0.5)).astype(numpy.int32))
    add(result, "density", density(x, y))
    return result


def exodus():
    """Element blocks are the materials: the reader numbers them in `ObjectId`."""
    data = grid()
    writer = vtkExodusIIWriter()
    writer.SetFileName(str(FOLDER / "blocks.exo"))
    writer.SetInputData(data)
    writer.SetBlockIdArrayName("material")
    writer.WriteOutGlobalElementIdArrayOff()
    writer.Write()
    reader = vtkExodusIIReader()
    reader.SetFileName(str(FOLDER / "blocks.exo"))
    reader.UpdateInformation()
    reader.SetAllArrayStatus(vtkExodusIIReader.ELEM_BLOCK, 1)
    reader.GenerateObjectIdCellArrayOn()
    return reader, {"ids": "ObjectId"}


def ensight():
    """EnSight Gold in ASCII. Its values are floats, so the materials are fractions."""
    k, j, i = numpy.meshgrid(*[numpy.arange(SIDE + 1) / SIDE] * 3, indexing="ij")
    x, y, _ = centers().T

    def column(values):
        return "".join(f"{value:12.5e}\n" for value in values)

    corners = point_id(cells()[:, None] + CORNERS) + 1
    (FOLDER / "cube.geo").write_text(
        "cube\n-\nnode id assign\nelement id assign\npart\n         1\ncube\ncoordinates\n"
        + f"{(SIDE + 1) ** 3:10d}\n" + "".join(column(axis.ravel()) for axis in (i, j, k))
        + f"hexa8\n{SIDE ** 3:10d}\n" + "".join("".join(f"{p:10d}" for p in cell) + "\n" for cell in corners))
    for name, values in (("water_vf", (x < 0.5) * 1.0), ("density", density(x, y))):
        (FOLDER / f"cube.{name}").write_text(f"{name}\npart\n         1\nhexa8\n" + column(values))
    (FOLDER / "cube.case").write_text(
        "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: cube.geo\nVARIABLE\n"
        "scalar per element: water_vf cube.water_vf\nscalar per element: density cube.density\n")
    reader = vtkGenericEnSightReader()
    reader.SetCaseFileName(str(FOLDER / "cube.case"))
    reader.UpdateInformation()
    reader.ReadAllVariablesOn()
    return reader, {"remainder": "air"}


def xdmf():
    writer = vtkXdmfWriter()
    writer.SetFileName(str(FOLDER / "cube.xmf"))
    writer.SetInputData(grid())
    writer.Write()
    reader = vtkXdmfReader()
    reader.SetFileName(str(FOLDER / "cube.xmf"))
    return reader, {"ids": "material"}


def cgns():
    data = grid()
    data.GetCellData().RemoveArray("material")
    add(data, "water_vf", (centers()[:, 0] < 0.5) * 1.0)
    writer = vtkCGNSWriter()
    writer.SetFileName(str(FOLDER / "cube.cgns"))
    writer.SetInputData(data)
    writer.Write()
    reader = vtkCGNSReader()
    reader.SetFileName(str(FOLDER / "cube.cgns"))
    reader.UpdateInformation()
    reader.EnableAllBases()
    reader.EnableAllCellArrays()
    return reader, {"remainder": "air"}


def vtkhdf():
    data, count = grid(), SIDE ** 3
    arrays = {"Points": data.GetPoints().GetData(), "Connectivity": data.GetCells().GetConnectivityArray(),
              "Offsets": data.GetCells().GetOffsetsArray(), "CellData/material": data.GetCellData().GetArray("material"),
              "CellData/density": data.GetCellData().GetArray("density")}
    arrays = {name: vtk_to_numpy(array) for name, array in arrays.items()}
    numpy.savez(FOLDER / "cube.npz", Types=numpy.full(count, VTK_HEXAHEDRON, numpy.uint8), NumberOfCells=[count],
                NumberOfPoints=[data.GetNumberOfPoints()], NumberOfConnectivityIds=[8 * count], **arrays)
    subprocess.run([PYTHON, "-c", WRITE_VTKHDF, str(FOLDER / "cube.npz"), str(FOLDER / "cube.hdf")], check=True)
    reader = vtkHDFReader()
    reader.SetFileName(str(FOLDER / "cube.hdf"))
    return reader, {"ids": "material"}


def foam_file(path, kind, body):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("FoamFile\n{\n    version 2.0;\n    format ascii;\n"
                    f"    class {kind};\n    object {path.name};\n}}\n{body}\n")


def foam_list(values, form="{}"):
    return f"{len(values)}\n(\n" + "\n".join(form.format(value) for value in values) + "\n)\n"


def foam_faces():
    """Faces as OpenFOAM orders them: inner ones by their owner, then the boundary; owner and neighbour of each."""
    inner, outer = [], []
    number = {tuple(c): n for n, c in enumerate(cells())}
    for cell, n in sorted(number.items(), key=lambda item: item[1]):
        for axis, face in enumerate([(1, 2, 6, 5), (3, 7, 6, 2), (4, 5, 6, 7)]):
            points = point_id(numpy.array(cell) + CORNERS[list(face)])
            other = number.get(tuple(numpy.array(cell) + numpy.eye(3, dtype=int)[axis]))
            (outer if other is None else inner).append((points, n, other))
        for axis, face in enumerate([(0, 4, 7, 3), (0, 1, 5, 4), (0, 3, 2, 1)]):
            if cell[axis] == 0:
                outer.append((point_id(numpy.array(cell) + CORNERS[list(face)]), n, None))
    return inner, outer


def openfoam():
    """A two-phase case with one fraction, alpha.water; the rest is air."""
    case = FOLDER / "foam"
    mesh = case / "constant/polyMesh"
    k, j, i = numpy.meshgrid(*[numpy.arange(SIDE + 1) / SIDE] * 3, indexing="ij")
    inner, outer = foam_faces()
    foam_file(mesh / "points", "vectorField", foam_list([f"({x:.17g} {y:.17g} {z:.17g})" for x, y, z in zip(
        i.ravel(), j.ravel(), k.ravel())]))
    foam_file(mesh / "faces", "faceList", foam_list(["4(" + " ".join(map(str, f[0])) + ")" for f in inner + outer]))
    foam_file(mesh / "owner", "labelList", foam_list([f[1] for f in inner + outer]))
    foam_file(mesh / "neighbour", "labelList", foam_list([f[2] for f in inner]))
    foam_file(mesh / "boundary", "polyBoundaryMesh",
              f"1\n(\nwalls\n{{\n type wall;\n nFaces {len(outer)};\n startFace {len(inner)};\n}}\n)\n")
    foam_file(case / "system/controlDict", "dictionary",
              "application interFoam;\nstartTime 0;\nendTime 1;\ndeltaT 1;\nwriteControl timeStep;\nwriteInterval 1;")
    x, y, _ = centers().T
    for time in (0, 1):
        for name, values in (("alpha.water", (x < 0.5) * 1.0), ("p", density(x, y, time))):
            foam_file(case / str(time) / name, "volScalarField",
                      "dimensions [0 0 0 0 0 0 0];\ninternalField nonuniform List<scalar>\n" + foam_list(values)
                      + ";\nboundaryField\n{\n walls\n {\n type zeroGradient;\n }\n}\n")
    (case / "case.foam").write_text("")
    reader = vtkOpenFOAMReader()
    reader.SetFileName(str(case / "case.foam"))
    reader.UpdateInformation()
    reader.SetCellArrayStatus("alpha.water", 1)
    reader.SetCellArrayStatus("p", 1)
    reader.SetCreateCellToPoint(0)
    reader.DecomposePolyhedraOff()
    return reader, {"remainder": "air", "field": "p", "times": (0.0, 1.0)}


def refined(reader, settings, time):
    filter_ = strata.vtkStrataTetrahedra()
    filter_.SetInputConnection(reader.GetOutputPort())
    filter_.SetMaterialIdArray(settings.get("ids", ""))
    filter_.SetRemainderMaterial(settings.get("remainder", "empty"))
    filter_.AddAbsoluteFieldErrorBound(settings.get("field", "density"), DENSITY_BOUND)
    filter_.UpdateInformation()
    filter_.GetOutputInformation(0).Set(vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP(), time)
    filter_.Update()
    return filter_, filter_.GetOutput()


def check(reader, settings):
    faults = []
    field = settings.get("field", "density")
    for time in settings.get("times", (0.0,)):
        filter_, mesh = refined(reader, settings, time)
        if not mesh.GetNumberOfCells():
            return ["no cells"]
        names = mesh.GetFieldData().GetAbstractArray("material_names")
        names = [names.GetValue(m) for m in range(names.GetNumberOfValues())]
        chosen = [mesh.GetFieldData().GetAbstractArray("field_names").GetValue(0)]
        if len(names) != 2 or chosen != [field] or not filter_.GetBoundMet():
            faults.append(f"materials {names}, fields {chosen}, {filter_.GetStoppedBy()}")
        points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
        material = vtk_to_numpy(mesh.GetPointData().GetArray("material"))
        off = numpy.abs(points[:, 0] - 0.5) > 1e-3
        if (material != (points[:, 0] > 0.5))[off].any():
            faults.append("vertices lie in the wrong material")
        # Linear in each material: exact within its samples, continued by a line to its borders.
        found = vtk_to_numpy(mesh.GetPointData().GetArray(field))
        worst = numpy.abs(found - density(points[:, 0], points[:, 1], time))[off].max()
        if worst > 2.0 * DENSITY_BOUND:
            faults.append(f"at time {time} {field} is off by {worst:.3g}")
    return faults


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    faults = 0
    for make in (exodus, openfoam, xdmf, ensight, cgns, vtkhdf):
        try:
            found = check(*make())
        except (RuntimeError, AttributeError, subprocess.CalledProcessError) as problem:
            found = [repr(problem)]
        faults += len(found)
        print(f"{make.__name__}: {'; '.join(found) or 'right'}", flush=True)
    sys.exit(faults > 0)


main()
