"""The way of a user in pvpython: read the case, refine, slide the bounds, slice, take pieces out, measure, save, reload."""
import os
import tempfile

from paraview import servermanager
from paraview.simple import *

TIME = 15.0


def updated(proxy):
    proxy.UpdatePipeline(TIME)
    proxy.UpdatePropertyInformation()
    return proxy


def cell_count(proxy):
    return updated(proxy).GetDataInformation().GetNumberOfCells()


def expect(condition, text):
    if not condition:
        raise AssertionError(text)


def refine(case):
    tetrahedra = MultiresolutionTetrahedra(Input=case)
    expect(len(tetrahedra.FieldArrays) == 0, "no field is chosen at first")
    tetrahedra.InterfaceErrorBound = 0.15
    tetrahedra.AbsoluteFieldErrorBounds = ["density", "0.3"]
    fine = cell_count(tetrahedra)
    expect(tetrahedra.AchievedInterfaceError <= 0.15, "the interface bound holds")
    expect(tetrahedra.BoundMet == 1 and tetrahedra.NumberOfCells == fine, "results are shown")
    tetrahedra.InterfaceErrorBound = 0.3
    tetrahedra.AbsoluteFieldErrorBounds = ["density", "3"]
    coarse = cell_count(tetrahedra)
    expect(coarse < fine, "looser bounds need fewer cells")
    expect(tetrahedra.NumberOfBuilds == 1, "a change of bounds keeps the hierarchy")
    return tetrahedra


def cut(source):
    section = MaterialSlice(Input=source)
    section.SliceType.Origin = [6.0, 0.01, -5.0]
    section.SliceType.Normal = [0.0, 1.0, 0.0]
    expect(cell_count(section) > 0, "the slice has polygons")
    return section


def area(section):
    integral = updated(IntegrateVariables(Input=section))
    return servermanager.Fetch(integral).GetCellData().GetArray("Area").GetTuple1(0)


def check_companions(case, tetrahedra, section):
    one = cell_count(ExtractMaterials(Input=tetrahedra, Materials=["projectile"]))
    all_materials = cell_count(ExtractMaterials(Input=tetrahedra))
    expect(0 < one < all_materials, "materials can be chosen")
    expect(cell_count(RepresentedInterfaces(Input=tetrahedra)) > 0, "there are interfaces")
    sampled = updated(SampleRepresentation(Input=tetrahedra, Points=section))
    expect({"material", "density", "outside"} <= set(sampled.PointData.keys()), "samples carry their arrays")
    errors = servermanager.Fetch(updated(RepresentationError(Input=tetrahedra, Original=case)))
    kinds = {str(errors.GetValue(row, 0)).strip('"') for row in range(errors.GetNumberOfRows())}
    expect(kinds == {"field", "interface", "region", "volume", "misclassified"}, f"rows of all kinds, not {kinds}")


def main():
    LoadPlugin(os.environ["STRATA_PLUGIN"], remote=False, ns=globals())
    case = OpenDataFile(os.path.join(os.environ["STRATA_DATA"], "impact", "impact.strata"))
    expect(len(updated(case).TimestepValues) == 6, "six time steps")
    tetrahedra = refine(case)
    section = cut(tetrahedra)
    section.Materials = ["projectile", "block", "empty"]
    expect(abs(area(section) - 12.0 * 20.8) < 1e-6 * 12.0 * 20.8, "the slice fills the section of the box")
    check_companions(case, tetrahedra, section)
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "impact.vtu")
        SaveData(name, proxy=tetrahedra, DataMode="Binary")
        again = cut(XMLUnstructuredGridReader(FileName=[name]))
        again.Materials = section.Materials
        expect(cell_count(again) == cell_count(section), "a saved representation slices the same")


main()
