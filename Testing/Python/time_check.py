"""Materials keep their numbers and names over time where one appears or vanishes, in a case and in a series of grids.

Three slabs of a unit cube along x: the middle one is as thick as the time says; at time 0 it isn't there.
"""
import json
import os
import sys
from pathlib import Path

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

FOLDER = Path(os.environ["STRATA_TEST_OUTPUT"]) / "Time"
SIDE = 8
TIMES = (0.0, 0.25, 0.5)
NAMES = ("left", "middle", "right")
DENSITIES = (1.0, 2.0, 3.0)


def write_step(number, time):
    data = vtkImageData()
    data.SetDimensions([SIDE + 1] * 3)
    data.SetSpacing([1.0 / SIDE] * 3)
    x = (numpy.arange(SIDE ** 3) % SIDE + 0.5) / SIDE
    material = numpy.where(x < 0.25, 0, numpy.where(x < 0.25 + time, 1, 2))
    arrays = {"vf_" + name: (material == m).astype(numpy.float32) for m, name in enumerate(NAMES)}
    arrays.update(material=material.astype(numpy.int32) + 1, density=numpy.array(DENSITIES)[material] + time)
    for name, values in arrays.items():
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        data.GetCellData().AddArray(array)
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(str(FOLDER / f"step_{number}.vti"))
    writer.SetDataModeToBinary()
    writer.SetInputData(data)
    writer.Write()


def write_series():
    FOLDER.mkdir(parents=True, exist_ok=True)
    for number, time in enumerate(TIMES):
        write_step(number, time)
    case = {"strata": 1, "materials": NAMES, "volume_fractions": {name: "vf_" + name for name in NAMES},
            "fields": {"density": "density"},
            "steps": [{"time": time, "grid": f"step_{number}.vti"} for number, time in enumerate(TIMES)]}
    (FOLDER / "slabs.strata").write_text(json.dumps(case))
    sets = "".join(f'<DataSet timestep="{time}" file="step_{number}.vti"/>' for number, time in enumerate(TIMES))
    (FOLDER / "slabs.pvd").write_text(f'<VTKFile type="Collection" version="0.1"><Collection>{sets}</Collection></VTKFile>')
    series = {"file-series-version": "1.0",
              "files": [{"name": f"step_{number}.vti", "time": time} for number, time in enumerate(TIMES)]}
    (FOLDER / "slabs.vti.series").write_text(json.dumps(series))


def check(source, settings, names):
    """At every time: names, and which number is where."""
    faults = []
    tetrahedra = MultiresolutionTetrahedra(Input=source, InterfaceErrorBound=0.02, FieldArrays=["density"], **settings)
    for time in TIMES + TIMES[:1]:
        tetrahedra.UpdatePipeline(time)
        mesh = tetrahedra.GetClientSideObject().GetOutputDataObject(0)
        array = mesh.GetFieldData().GetAbstractArray("material_names")
        found = [array.GetValue(m) for m in range(array.GetNumberOfValues())]
        if found != list(names):
            faults.append(f"at {time} materials are {found}")
        x = vtk_to_numpy(mesh.GetPoints().GetData())[:, 0]
        values = vtk_to_numpy(mesh.GetPointData().GetArray("density"))
        numbers = vtk_to_numpy(mesh.GetPointData().GetArray("material"))
        for m, (lower, upper) in enumerate([(0.0, 0.25), (0.25, 0.25 + time), (0.25 + time, 1.0)]):
            within = (x > lower + 1e-3) & (x < upper - 1e-3)
            if (numbers[within] != m).any() or not numpy.allclose(values[within], DENSITIES[m] + time, atol=1e-5):
                faults.append(f"at {time} {names[m]} isn't where it should be, or not as dense")
    simple.Delete(tetrahedra)
    return faults


def main():
    simple.LoadPlugin(os.environ["STRATA_PLUGIN"], remote=False, ns=globals())
    write_series()
    ids = [f"Material {m}" for m in (1, 2, 3)]
    by_ids = {"VolumeFractionArrays": [], "MaterialIdArray": "material"}
    runs = [("case", "slabs.strata", {}, NAMES), ("collection", "slabs.pvd", {}, NAMES),
            ("series", "slabs.vti.series", {}, NAMES), ("ids", "slabs.pvd", by_ids, ids)]
    faults = 0
    for name, file, settings, names in runs:
        source = simple.OpenDataFile(str(FOLDER / file))
        found = check(source, settings, names)
        faults += len(found)
        print(f"{name}: {'; '.join(found) or 'right'}", flush=True)
    sys.exit(faults > 0)


main()
