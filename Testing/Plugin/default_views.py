"""What a user sees first: views coloured by material or by pair, with names; and results that are current.

The colours come with the filters, in the window and here alike: vtkSMStrataCategories, vtkSMStrataResults.
"""
import os

import strata
from paraview import simple

TIME = 15.0
MATERIALS = {"0": "projectile", "1": "block", "2": "empty"}
PAIRS = {"0": "projectile / block", "1": "projectile / empty", "2": "block / empty"}


def expect(condition, text):
    if not condition:
        raise AssertionError(text)


def shown(source, view):
    """The display of a source and its colour map's names by number."""
    display = simple.Show(source, view)
    texts = list(display.LookupTable.Annotations) if display.LookupTable else []
    return display, dict(zip(texts[::2], texts[1::2]))


def color_of(display, number):
    texts = list(display.LookupTable.Annotations)
    at = texts[::2].index(number)
    return list(display.LookupTable.IndexedColors)[3 * at: 3 * at + 3]


def check_categories(source, view, array, names):
    display, found = shown(source, view)
    expect(list(display.ColorArrayName) == ["CELLS", array], f"{array}: coloured by {display.ColorArrayName}")
    expect(display.LookupTable.InterpretValuesAsCategories == 1, f"{array}: not categorical")
    expect({**names, **found} == found, f"{array}: {found} instead of {names}")
    return display


def check_empty_contour(contour, view):
    """An output without cells is not coloured by an array that it lacks (ParaView would warn); the next one is."""
    values = list(contour.Isosurfaces)
    contour.Isosurfaces = [1e6]
    display, _ = shown(contour, view)
    expect(display.ColorArrayName[1] != "material", "an empty contour is coloured by its material")
    contour.Isosurfaces = values
    contour.UpdatePipeline(TIME)
    check_categories(contour, view, "material", MATERIALS)


def check_fields(source, view):
    display = strata.show(source, view)
    legend = simple.GetScalarBar(display.LookupTable, view)
    expect(legend.Visibility == 1 and legend.Title == "density", "no legend")
    expect(list(display.ColorArrayName) == ["POINTS", "density"], f"coloured by {display.ColorArrayName}")


def check_results(tetrahedra):
    """The panel's results are those of the run before no more: they are read again after each run."""
    proxy = tetrahedra.SMProxy
    for bound in (0.6, 0.3):
        tetrahedra.InterfaceErrorBound = bound
        tetrahedra.UpdatePipeline(TIME)
        cells = tetrahedra.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells()
        found = simple.servermanager.vtkSMPropertyHelper(proxy, "NumberOfCells").GetAsInt()
        expect(found == cells, f"the panel says {found} cells instead of {cells}")
        achieved = simple.servermanager.vtkSMPropertyHelper(proxy, "AchievedInterfaceError").GetAsDouble()
        expect(0.0 < achieved <= bound, f"the panel says {achieved}, at a bound of {bound}")
    names = simple.servermanager.vtkSMPropertyHelper(proxy, "MaterialNames").GetAsString()
    expect(names == "projectile, block, empty", f"materials {names}")
    expect(tetrahedra.Seconds > 0.0, "no time")


def two_fluids():
    """Other materials under the same numbers."""
    source = simple.Wavelet(WholeExtent=[0, 8, 0, 8, 0, 8])
    cells = simple.PointDatatoCellData(Input=source)
    water = simple.Calculator(Input=cells, AttributeType="Cell Data", ResultArrayName="alpha.water",
                              Function="if(RTData > 200, 1, 0)")
    return simple.MultiresolutionTetrahedra(Input=water, FieldArrays=["RTData"], InterfaceErrorBound=1.0,
                                            FieldErrorBound=0.5)


def check_state(tetrahedra, view):
    """A view that a state brings along keeps what the user made of it."""
    display = simple.GetDisplayProperties(tetrahedra, view)
    simple.ColorBy(display, ("CELLS", "level"))
    simple.RenameSource("tetrahedra", tetrahedra)
    state = os.path.join(os.environ["STRATA_TEST_OUTPUT"], "default_views.pvsm")
    simple.SaveState(state)
    simple.ResetSession()
    simple.LoadState(state)
    source = simple.FindSource("tetrahedra")
    display = simple.GetDisplayProperties(source, simple.GetViews()[0])
    expect(list(display.ColorArrayName) == ["CELLS", "level"], f"the state came back as {display.ColorArrayName}")


def main():
    simple.LoadPlugin(os.environ["STRATA_PLUGIN"], remote=False, ns=vars(simple))
    case = simple.OpenDataFile(os.path.join(os.environ["STRATA_DATA"], "impact", "impact.strata"))
    case.UpdatePipeline(TIME)
    view = simple.CreateRenderView()
    view.ViewTime = TIME
    tetrahedra = simple.MultiresolutionTetrahedra(Input=case, FieldArrays=["density"], FieldErrorBound=0.2)
    check_results(tetrahedra)
    display = check_categories(tetrahedra, view, "material", {"-1": "several", **MATERIALS})
    check_categories(simple.MaterialInterfaces(Input=case), view, "pair", PAIRS)
    check_categories(simple.RepresentedInterfaces(Input=tetrahedra), view, "pair", PAIRS)
    contour = simple.MaterialContour(Input=tetrahedra, ContourBy=["POINTS", "density"], Isosurfaces=[9.0])
    check_empty_contour(contour, view)
    check_fields(simple.MaterialSlice(Input=tetrahedra), view)
    check_fields(simple.ExtractMaterials(Input=tetrahedra), view)

    before = color_of(display, "1")
    other = check_categories(two_fluids(), view, "material", {"0": "water", "1": "empty"})
    expect(other.UseSeparateColorMap == 1, "two data sets share a colour map with different names")
    expect(color_of(display, "1") == before, "another data set changed the colours")
    simple.Render(view)
    check_state(tetrahedra, view)
    print("the views are as they should be")


main()
