"""What the guide's pictures share: the view, the colours, and where pictures go.

STRATA_GUIDE_QUICK=1 makes tiny pictures from coarse meshes, to test that every script still runs.
"""
import os
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[2] / "Examples"))
os.environ.setdefault("STRATA_OUTPUT", str(HERE.parent))

import demo_pictures
import numpy
from paraview import simple
from strata_example import data, output
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

QUICK = os.environ.get("STRATA_GUIDE_QUICK") == "1"
BLACK = [0.0, 0.0, 0.0]
MATERIAL_COLORS = [0.90, 0.42, 0.18, 0.35, 0.60, 0.83, 0.93, 0.93, 0.93, 0.45, 0.70, 0.45]
CRATER = dict(position=[22.0, -30.0, 17.0], focus=[5.0, 5.0, -5.0], up=[0.0, 0.0, 1.0])


def refine(case, interface_bound, density_bound, **choices):
    """The impact's representation; coarser in quick mode."""
    scale = 4.0 if QUICK else 1.0
    return simple.MultiresolutionTetrahedra(
        Input=case, FieldArrays=["density"], InterfaceErrorBound=scale * interface_bound,
        AbsoluteFieldErrorBounds=["density", str(scale * density_bound)], **choices)


def new_view(width, height):
    view = simple.CreateView("RenderView")
    view.ViewSize = [width // 8, height // 8] if QUICK else [width, height]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    return view


def look(view, position, focus, up, zoom=1.0):
    """From outside; call it last, since the first Show moves the camera."""
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = position, focus, up
    view.CameraParallelProjection = 0
    simple.ResetCamera(view)
    camera = simple.GetActiveCamera() if view == simple.GetActiveView() else view.GetActiveCamera()
    camera.Dolly(0.95 * zoom)
    camera.SetWindowCenter(0.22, 0.0)  # the legend is on the right


def look_at_plane(view, x, z, half_height):
    """Along +y: x to the right, z upwards."""
    view.InteractionMode = "2D"
    view.CameraPosition, view.CameraFocalPoint = [x, -60.0, z], [x, 0.0, z]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.CameraParallelProjection = 1
    view.CameraParallelScale = half_height


def plane_of(filter_proxy, y):
    filter_proxy.SliceType.Origin = [0.0, y, 0.0]
    filter_proxy.SliceType.Normal = [0.0, 1.0, 0.0]
    return filter_proxy


def material_slice(tetrahedra, y=0.0, **choices):
    return plane_of(simple.MaterialSlice(Input=tetrahedra, **choices), y)


def cut(source, y=1e-5):
    """ParaView's own slice; a little inside of the wall, where VTK's cutter makes nothing."""
    return plane_of(simple.Slice(Input=source), y)


def show_density(source, view, bar=True):
    display, colors = demo_pictures.show_density(source, view)
    if bar:
        legend(colors, view, "density, g/cm\u00b3", "%.0f")
    else:
        display.SetScalarBarVisibility(view, False)
    return display


def show_categories(source, view, array, names, palette=MATERIAL_COLORS):
    """Cells coloured by the integers of an array, each with a name."""
    display = simple.Show(source, view)
    display.Representation = "Surface"
    simple.ColorBy(display, ("CELLS", array))
    colors = simple.GetColorTransferFunction(array)
    colors.InterpretValuesAsCategories = 1
    colors.Annotations = [text for value, name in names.items() for text in (str(value), name)]
    colors.IndexedColors = palette[:3 * len(names)]
    legend(colors, view, array, "%.0f")
    bar = simple.GetScalarBar(colors, view)
    bar.TextPosition, bar.Position = "Ticks left/bottom, annotations right/top", [0.70, 0.30]
    return display


def legend(colors, view, title, labels):
    bar = simple.GetScalarBar(colors, view)
    bar.Title, bar.ComponentTitle, bar.HorizontalTitle = title, "", 1
    bar.TitleColor = bar.LabelColor = BLACK
    bar.TitleFontSize = bar.LabelFontSize = 16
    bar.WindowLocation, bar.Position, bar.ScalarBarLength = "Any Location", [0.84, 0.30], 0.45
    bar.RangeLabelFormat = bar.LabelFormat = labels
    bar.AutomaticLabelFormat = 0
    bar.Visibility = 1


def show_lines(source, view, color=BLACK, width=1.0, opacity=1.0, towards_viewer=0.01):
    moved = simple.Transform(Input=source)
    moved.Transform.Translate = [0.0, -towards_viewer, 0.0]
    display = simple.Show(moved, view)
    display.Representation = "Wireframe"
    display.ColorArrayName = [None, ""]
    display.AmbientColor = display.DiffuseColor = color
    display.LineWidth, display.Opacity = width, opacity
    display.Ambient, display.Diffuse = 1.0, 0.0


def caption(view, text):
    display = simple.Show(simple.Text(Text=text), view)
    display.Color, display.FontSize = BLACK, 15
    display.WindowLocation = "Lower Center"


def save(view, name):
    simple.SaveScreenshot(output(name), view, ImageResolution=view.ViewSize, CompressionLevel=9)
    simple.Delete(view)


def save_row(views, name):
    """Pictures of several views, side by side in one file."""
    parts = []
    for number, view in enumerate(views):
        part = output(f"part_{number}_{name}")
        simple.SaveScreenshot(part, view, ImageResolution=view.ViewSize)
        reader = vtkPNGReader()
        reader.SetFileName(part)
        reader.Update()
        width, height, _ = reader.GetOutput().GetDimensions()
        parts.append(vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1))
        Path(part).unlink()
        simple.Delete(view)
    row = numpy.hstack(parts)
    image = vtkImageData()
    image.SetDimensions(row.shape[1], row.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(row.reshape(-1, row.shape[2]), deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(output(name))
    writer.SetCompressionLevel(9)
    writer.SetInputData(image)
    writer.Write()
