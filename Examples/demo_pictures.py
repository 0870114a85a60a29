"""The demo's pictures: sections of the mesh on the plane y = 0, and the original interfaces."""
from paraview import simple
from strata_example import data

SIZE = [1300, 1800]
WHITE = [1.0, 1.0, 1.0]
BLACK = [0.0, 0.0, 0.0]
GREEN = [0.0, 0.60, 0.25]
# Density in g/cm^3 and colour: nickel (8.9) in blues, tantalum (16.7) in oranges; what no material has in others.
DENSITY_COLORS = [0.0, 1.00, 1.00, 1.00, 1.5, 0.98, 0.92, 0.70, 5.0, 0.74, 0.85, 0.55, 7.0, 0.55, 0.80, 0.74,
                  8.2, 0.52, 0.74, 0.90, 8.9, 0.35, 0.60, 0.83, 10.0, 0.14, 0.40, 0.66, 12.0, 0.12, 0.20, 0.42,
                  14.0, 0.55, 0.16, 0.38, 16.0, 0.90, 0.42, 0.18, 19.0, 0.99, 0.86, 0.40]
# VTK's cutter makes nothing of cells that only touch the plane: a little inside of the box's wall.
INSIDE = 1e-5
PAIRS = {"projectile / block": [0.80, 0.25, 0.20], "projectile / empty": [0.95, 0.70, 0.20],
         "block / empty": [0.45, 0.60, 0.75]}


def new_view(size):
    view = simple.CreateView("RenderView")
    view.ViewSize = size
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = WHITE
    return view


def look_at_section(view):
    """Along +y on the plane y = 0: x to the right, z upwards. Call it last: the first Show of all moves the camera."""
    view.InteractionMode = "2D"
    view.CameraPosition = [7.2, -60.0, -5.6]
    view.CameraFocalPoint = [7.2, 0.0, -5.6]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 10.8


def cut(source, y=INSIDE):
    result = simple.Slice(Input=source)
    result.SliceType.Origin = [0.0, y, 0.0]
    result.SliceType.Normal = [0.0, 1.0, 0.0]
    return result


def towards_viewer(source, distance):
    """Lines in front of what they are drawn on."""
    moved = simple.Transform(Input=source)
    moved.Transform.Translate = [0.0, -distance, 0.0]
    return moved


def show_lines(source, view, color, width, opacity, distance):
    display = simple.Show(towards_viewer(source, distance), view)
    display.Representation = "Wireframe"
    display.ColorArrayName = [None, ""]
    display.AmbientColor = display.DiffuseColor = color
    display.LineWidth = width
    display.Opacity = opacity
    display.Ambient, display.Diffuse = 1.0, 0.0


def show_density(source, view):
    """Without light, so that equal densities have equal colours; returns the display and its colours."""
    display = simple.Show(source, view)
    display.Representation = "Surface"
    simple.ColorBy(display, ("POINTS", "density"))
    display.Ambient, display.Diffuse = 1.0, 0.0
    display.InterpolateScalarsBeforeMapping = 1
    colors = simple.GetColorTransferFunction("density")
    colors.ColorSpace = "RGB"
    colors.RGBPoints = DENSITY_COLORS
    colors.NumberOfTableValues = 1024
    return display, colors


def show_legend(colors, view, title, position, length):
    bar = simple.GetScalarBar(colors, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.HorizontalTitle = 1
    bar.TitleColor = bar.LabelColor = BLACK
    bar.TitleFontSize, bar.LabelFontSize = 24, 24
    bar.WindowLocation = "Any Location"
    bar.Position, bar.ScalarBarLength = position, length
    bar.RangeLabelFormat = bar.LabelFormat = "%.0f"
    bar.AutomaticLabelFormat = 0
    bar.Visibility = 1


def show_mesh_and_interfaces(tetrahedra, interfaces, view):
    show_lines(cut(tetrahedra), view, BLACK, 1.0, 0.35, 0.01)
    show_lines(cut(simple.RepresentedInterfaces(Input=tetrahedra)), view, GREEN, 2.0, 1.0, 0.02)
    show_lines(cut(interfaces), view, BLACK, 3.0, 1.0, 0.03)


def save(view, name):
    simple.SaveScreenshot(name, view, ImageResolution=view.ViewSize, CompressionLevel=9)
    simple.Delete(view)


def draw_slice(tetrahedra, interfaces, name):
    """Every material's own density up to the represented interfaces; the original ones as thick lines."""
    view = new_view(SIZE)
    section = simple.MaterialSlice(Input=tetrahedra)
    section.SliceType.Origin = [0.0, 0.0, 0.0]
    section.SliceType.Normal = [0.0, 1.0, 0.0]
    _, colors = show_density(section, view)
    show_legend(colors, view, "density, g/cm\u00b3", [0.88, 0.30], 0.4)
    show_mesh_and_interfaces(tetrahedra, interfaces, view)
    look_at_section(view)
    save(view, name)


def draw_mixed(tetrahedra, interfaces, case, name):
    """The usual way: one density for all materials, sampled at the vertices and interpolated between them."""
    view = new_view(SIZE)
    grid = simple.ExtractBlock(Input=case, Selectors=["/Root/grid"])
    smooth = simple.CellDatatoPointData(Input=grid)
    sampled = simple.ResampleWithDataset(SourceDataArrays=smooth, DestinationMesh=tetrahedra)
    _, colors = show_density(cut(sampled), view)
    show_legend(colors, view, "density, g/cm\u00b3", [0.88, 0.30], 0.4)
    show_mesh_and_interfaces(tetrahedra, interfaces, view)
    look_at_section(view)
    save(view, name)


def draw_interfaces(interfaces, name):
    """The original surfaces, a colour for each pair of materials, from above the crater."""
    view = new_view([1500, 1400])
    merged = simple.MergeBlocks(Input=interfaces, OutputDataSetType="Polygonal Mesh")
    pairs = simple.Calculator(Input=merged, AttributeType="Cell Data", ResultArrayName="pair",
                              Function="10*positive_material+negative_material")
    display = simple.Show(pairs, view)
    simple.ColorBy(display, ("CELLS", "pair"))
    display.Specular = 0.2
    colors = simple.GetColorTransferFunction("pair")
    colors.InterpretValuesAsCategories = 1
    names = pair_names(interfaces)
    colors.Annotations = [text for value, pair in names.items() for text in (str(value), pair)]
    colors.IndexedColors = [part for pair in names.values() for part in PAIRS[pair]]
    show_legend(colors, view, "original interfaces", [0.17, 0.05], 0.2)
    view.CameraPosition = [30.0, -34.0, 22.0]
    view.CameraFocalPoint = [5.5, 6.0, -5.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    simple.ResetCamera(view)
    save(view, name)


def pair_names(interfaces):
    """What the calculator makes of each pair, and the pair's name."""
    surfaces = data(interfaces)
    names = {}
    for block in range(surfaces.GetNumberOfPartitionedDataSets()):
        surface = surfaces.GetPartition(block, 0)
        if surface and surface.GetNumberOfCells():
            cells = surface.GetCellData()
            value = 10 * cells.GetArray("positive_material").GetValue(0)
            value += cells.GetArray("negative_material").GetValue(0)
            name = surfaces.GetMetaData(block).Get(surfaces.NAME())
            names[value] = " / ".join(name.split("|"))
    return names
