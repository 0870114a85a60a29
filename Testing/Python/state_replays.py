"""States, traces and saved representations replay to the same output."""
import json
import os
import subprocess
import sys
from pathlib import Path

from paraview import simple, smtrace
from vtkmodules.numpy_interface import dataset_adapter
import numpy

TIME = 15.0
FOLDER = Path(os.environ["STRATA_TEST_OUTPUT"]) / "state"
FILTERS = ("interfaces", "tetrahedra", "slice", "contour", "pieces", "surfaces", "samples", "errors")


def load_plugin():
    simple.LoadPlugin(os.environ["STRATA_PLUGIN"], remote=False, ns=vars(simple))


def build():
    """Every filter, none with its defaults alone, registered by a name."""
    case = simple.OpenDataFile(os.path.join(os.environ["STRATA_DATA"], "impact", "impact.strata"))
    simple.RenameSource("case", case)
    case.UpdatePipeline(TIME)
    # A trace records what a filter is made with.
    simple.MaterialInterfaces(registrationName="interfaces", Input=case, MinimumVolumeFraction=0.2)
    tetrahedra = simple.MultiresolutionTetrahedra(
        registrationName="tetrahedra", Input=case, FieldArrays=["density"], InterfaceErrorBound=0.3,
        AbsoluteFieldErrorBounds=["density", "2"], FocusMaterials=["projectile"], RegionOfInterest="Sphere",
        RegionCenter=[6.0, 0.5, -5.0], RegionRadius=4.0, RegionCoarsening=3.0)
    section = simple.MaterialSlice(
        registrationName="slice", Input=tetrahedra, SliceOffsetValues=[0.01],
        Materials=["projectile", "block", "empty"])
    simple.MaterialContour(registrationName="contour", Input=tetrahedra, ContourBy=["POINTS", "density"],
                           Isosurfaces=[9.0, 17.0])
    simple.ExtractMaterials(registrationName="pieces", Input=tetrahedra, Materials=["projectile"])
    simple.RepresentedInterfaces(registrationName="surfaces", Input=tetrahedra)
    simple.SampleRepresentation(registrationName="samples", Input=tetrahedra, Points=section)
    simple.RepresentationError(registrationName="errors", Input=tetrahedra, Original=case)


def sums(attributes):
    """Array name -> sum of its finite values."""
    result = {}
    for name in attributes.keys():
        values = numpy.asarray(attributes[name], dtype=float)
        result[name] = float(values[numpy.isfinite(values)].sum())
    return result


def leaves(data):
    if not data.IsA("vtkCompositeDataSet"):
        return [data]
    iterator = data.NewIterator()
    found = []
    while not iterator.IsDoneWithTraversal():
        found.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return found


def summary(data):
    """What two outputs must share: counts, bounds and the sums of all numbers."""
    result = []
    for leaf in leaves(data):
        if leaf.IsA("vtkTable"):
            columns = [leaf.GetColumn(i) for i in range(leaf.GetNumberOfColumns())]
            result.append([[str(column.GetVariantValue(row)) for row in range(leaf.GetNumberOfRows())]
                           for column in columns])
        else:
            view = dataset_adapter.WrapDataObject(leaf)
            result.append([leaf.GetNumberOfPoints(), leaf.GetNumberOfCells(), list(leaf.GetBounds()),
                           sums(view.PointData), sums(view.CellData)])
    return result


def outputs():
    result = {}
    for name in FILTERS:
        proxy = simple.FindSource(name)
        proxy.UpdatePipeline(TIME)
        result[name] = summary(proxy.GetClientSideObject().GetOutputDataObject(0))
    return json.loads(json.dumps(result))


def expect_same(found, wanted, what):
    for name in FILTERS:
        if not wanted[name] or found[name] != wanted[name]:
            raise AssertionError(f"{what}: {name} differs: {found[name]}\ninstead of {wanted[name]}")
    print(f"{what}: {len(FILTERS)} outputs are the same")


def check_state(wanted):
    state = str(FOLDER / "strata.pvsm")
    simple.SaveState(state)
    simple.ResetSession()
    if simple.FindSource("tetrahedra"):
        raise AssertionError("the session is still there")
    simple.LoadState(state)
    expect_same(outputs(), wanted, "state")


def check_trace(trace, wanted):
    """Runs the trace in a process of its own."""
    script = FOLDER / "trace.py"
    script.write_text(trace)
    result = FOLDER / "trace.json"
    result.unlink(missing_ok=True)
    subprocess.run(["pvpython", __file__, "replay", str(script), str(result)], check=True)
    expect_same(json.loads(result.read_text()), wanted, "trace")


def replay(script, result):
    load_plugin()
    exec(compile(Path(script).read_text(), script, "exec"), {"__name__": "__main__"})
    Path(result).write_text(json.dumps(outputs()))


def companions(representation, case):
    """Every filter that takes a representation."""
    section = simple.MaterialSlice(Input=representation)
    section.SliceType.Origin = [6.0, 0.01, -5.0]
    section.SliceType.Normal = [0.3, 1.0, 0.1]
    return {
        "slice": section,
        "contour": simple.MaterialContour(Input=representation, ContourBy=["POINTS", "density"], Isosurfaces=[9.0]),
        "pieces": simple.ExtractMaterials(Input=representation),
        "surfaces": simple.RepresentedInterfaces(Input=representation),
        "samples": simple.SampleRepresentation(Input=representation, Points=section),
        "errors": simple.RepresentationError(Input=representation, Original=case),
    }


def check_saved():
    """Filters make of a saved representation what they make of the one in memory."""
    name = str(FOLDER / "tetrahedra.vtu")
    tetrahedra, case = simple.FindSource("tetrahedra"), simple.FindSource("case")
    simple.SaveData(name, proxy=tetrahedra, DataMode="Binary")
    found = []
    for source in (tetrahedra, simple.XMLUnstructuredGridReader(FileName=[name])):
        results = {}
        for filter_name, proxy in companions(source, case).items():
            proxy.UpdatePipeline(TIME)
            results[filter_name] = summary(proxy.GetClientSideObject().GetOutputDataObject(0))
        found.append(results)
    for filter_name, wanted in found[0].items():
        if not wanted or found[1][filter_name] != wanted:
            raise AssertionError(f"saved: {filter_name} differs: {found[1][filter_name]}\ninstead of {wanted}")
    if found[0]["slice"][0][1] == 0:
        raise AssertionError("saved: the slice is empty")
    print(f"saved: {len(found[0])} outputs are the same")


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    load_plugin()
    smtrace.start_trace()
    build()
    trace = smtrace.stop_trace()
    wanted = outputs()
    check_saved()
    check_trace(trace, wanted)
    check_state(wanted)


if len(sys.argv) > 1 and sys.argv[1] == "replay":
    replay(*sys.argv[2:])
else:
    main()
