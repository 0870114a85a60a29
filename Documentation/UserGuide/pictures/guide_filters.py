"""A picture for each reader and filter, of the impact at 15 microseconds."""
import strata
from guide_scene import *

AXIS = ([0.1, 0.1, -16.0], [0.1, 0.1, 4.8])


def draw_case(case):
    """The grid as the file has it: one mixed density per cell."""
    view = new_view(640, 560)
    grid = simple.ExtractBlock(Input=case, Selectors=["/Root/grid"])
    display = show_density(grid, view)
    simple.ColorBy(display, ("CELLS", "density"))
    outline = simple.Show(simple.Outline(Input=grid), view)
    outline.AmbientColor = outline.DiffuseColor = BLACK
    look(view, **CRATER)
    save(view, "case-reader.png")


def show_named(source, view):
    """A filter's first view, as it comes, with the legend moved aside."""
    display = strata.show(source, view)
    legend(display.LookupTable, view, display.ColorArrayName[1], "%.0f")
    bar = simple.GetScalarBar(display.LookupTable, view)
    bar.TextPosition, bar.Position = "Ticks left/bottom, annotations right/top", [0.70, 0.30]
    return display


def draw_interfaces(interfaces):
    view = new_view(640, 560)
    show_named(interfaces, view).Specular = 0.2
    look(view, zoom=1.1, **CRATER)
    save(view, "material-interfaces.png")


def draw_tetrahedra(tetrahedra):
    """All cells behind a plane; a cell that holds an interface has the material -1."""
    view = new_view(500, 440)
    half = simple.Clip(Input=tetrahedra, ClipType="Plane", Crinkleclip=1, Invert=0)
    half.ClipType.Origin, half.ClipType.Normal = [0.0, 3.0, 0.0], [0.0, 1.0, 0.0]
    names = {-1: "several", 0: "projectile", 1: "block", 2: "empty"}
    palette = [0.85, 0.75, 0.25] + MATERIAL_COLORS
    display = show_categories(half, view, "material", names, palette)
    display.Representation, display.EdgeColor = "Surface With Edges", BLACK
    display.Ambient, display.Diffuse = 0.7, 0.3
    look(view, **CRATER)
    save(view, "tetrahedra.png")


def draw_slice(tetrahedra, interfaces):
    view = new_view(560, 700)
    show_density(material_slice(tetrahedra), view)
    show_lines(cut(tetrahedra), view, opacity=0.3)
    show_lines(cut(interfaces), view, width=2.0, towards_viewer=0.03)
    look_at_plane(view, 7.2, -5.6, 10.8)
    save(view, "material-slice.png")


def draw_contour(tetrahedra):
    """Surfaces of equal density, within the interfaces as glass."""
    view = new_view(640, 560)
    show_density(simple.MaterialContour(Input=tetrahedra, ContourBy=["POINTS", "density"],
                                        Isosurfaces=[9.0, 9.3, 9.6, 16.0]), view).Diffuse = 0.5
    glass = simple.Show(simple.RepresentedInterfaces(Input=tetrahedra), view)
    glass.Representation, glass.ColorArrayName = "Surface", [None, ""]
    glass.AmbientColor, glass.Opacity, glass.Ambient = [0.5, 0.5, 0.5], 0.25, 0.5
    look(view, zoom=0.95, **CRATER)
    save(view, "material-contour.png")


def draw_pieces(tetrahedra):
    view = new_view(640, 560)
    show_density(simple.ExtractMaterials(Input=tetrahedra, Materials=["projectile"]), view, bar=False)
    block = simple.ExtractMaterials(Input=tetrahedra, Materials=["block"])
    half = simple.Clip(Input=block, ClipType="Plane", Invert=1)
    half.ClipType.Origin, half.ClipType.Normal = [0.0, 5.0, 0.0], [-0.35, -1.0, 0.0]
    display = show_density(half, view)
    display.Ambient, display.Diffuse = 0.45, 0.6
    look(view, zoom=1.1, **CRATER)
    save(view, "extract-materials.png")


def draw_represented(tetrahedra):
    view = new_view(640, 560)
    display = simple.Show(simple.RepresentedInterfaces(Input=tetrahedra), view)
    display.Representation = "Surface"
    simple.ColorBy(display, ("POINTS", "density_jump"))
    colors = simple.GetColorTransferFunction("density_jump")
    colors.RescaleTransferFunction(0.0, 9.0)
    colors.NanColor = [0.80, 0.80, 0.78]
    legend(colors, view, "jump of density", "%.0f")
    look(view, zoom=1.1, **CRATER)
    save(view, "represented-interfaces.png")


def draw_samples(case, tetrahedra):
    """Density along a line through the crater: the representation's, and the grid's mixed one."""
    line = simple.Line(Point1=AXIS[0], Point2=AXIS[1], Resolution=60 if QUICK else 1200)
    sampled = simple.SampleRepresentation(Input=tetrahedra, Points=line)
    grid = simple.CellDatatoPointData(Input=simple.ExtractBlock(Input=case, Selectors=["/Root/grid"]))
    mixed = simple.ResampleWithDataset(SourceDataArrays=grid, DestinationMesh=line)
    chart = simple.CreateView("XYChartView")
    chart.ViewSize = [80, 50] if QUICK else [760, 380]
    chart.LeftAxisTitle, chart.BottomAxisTitle = "density, g/cm\u00b3", "z, cm"
    chart.BottomAxisUseCustomRange, chart.BottomAxisRangeMinimum, chart.BottomAxisRangeMaximum = 1, -10.0, 0.0
    chart.LeftAxisUseCustomRange, chart.LeftAxisRangeMinimum, chart.LeftAxisRangeMaximum = 1, 0.0, 18.0
    for source, label, color in ((mixed, "mixed, interpolated", "0.6"), (sampled, "Sample Representation", "0.85")):
        display = simple.Show(source, chart, "XYChartRepresentation")
        display.UseIndexForXAxis, display.XArrayName = 0, "Points_Z"
        display.SeriesVisibility = ["density"]
        display.SeriesLabel = ["density", label]
        display.SeriesColor = ["density", color, "0.3", "0.1" if source is sampled else "0.6"]
        display.SeriesLineThickness = ["density", "2"]
    save(chart, "sample-representation.png")


def draw_errors(tetrahedra):
    """The certificate of every cell: its own largest error of density, on a section."""
    view = new_view(560, 700)
    display = simple.Show(cut(tetrahedra), view)
    display.Representation, display.EdgeColor = "Surface With Edges", BLACK
    simple.ColorBy(display, ("CELLS", "field_error_density"))
    display.Ambient, display.Diffuse = 1.0, 0.0
    colors = simple.GetColorTransferFunction("field_error_density")
    colors.ApplyPreset("Viridis (matplotlib)", True)
    colors.RescaleTransferFunction(0.0, 0.5)
    legend(colors, view, "density error", "%.2f")
    look_at_plane(view, 7.2, -5.6, 10.8)
    save(view, "cell-errors.png")


def draw(case, interfaces):
    tetrahedra = refine(case, 0.15, 0.5, Interfaces=interfaces)
    draw_case(case)
    draw_interfaces(interfaces)
    draw_tetrahedra(tetrahedra)
    draw_slice(tetrahedra, interfaces)
    draw_contour(tetrahedra)
    draw_pieces(tetrahedra)
    draw_represented(tetrahedra)
    draw_samples(case, tetrahedra)
    draw_errors(tetrahedra)
