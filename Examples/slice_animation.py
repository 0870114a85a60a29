"""Moves a slice through the block, a picture per position: slice_00.png, slice_01.png, ...

    pvpython slice_animation.py [NUMBER_OF_PICTURES]
"""
import sys

from paraview import simple
from strata_example import load_plugin, output, read_impact

count = int(sys.argv[1]) if len(sys.argv) > 1 else 24
load_plugin()
case = read_impact()
tetrahedra = simple.MultiresolutionTetrahedra(
    Input=case, FieldArrays=["density"], InterfaceErrorBound=0.1, AbsoluteFieldErrorBounds=["density", "0.5"])
section = simple.MaterialSlice(Input=tetrahedra)
section.SliceType.Normal = [0.0, 1.0, 0.0]
section.SliceType.Origin = [0.0, 0.0, 0.0]

view = simple.CreateView("RenderView")
view.ViewSize = [800, 900]
simple.Show(tetrahedra, view).Representation = "Outline"
display = simple.Show(section, view)
simple.ColorBy(display, ("POINTS", "density"))
colors = simple.GetColorTransferFunction("density")
colors.RescaleTransferFunction(7.0, 18.0)
display.Ambient, display.Diffuse = 1.0, 0.0
display.SetScalarBarVisibility(view, True)
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [20, -45, 6], [6, 6, -5.6], [0, 0, 1]
simple.ResetCamera(view)
for picture in range(count):
    # Only the polygons are cut anew: the mesh and its search structure stay.
    section.SliceType.Origin = [0.0, 12.0 * picture / count, 0.0]
    simple.SaveScreenshot(output(f"slice_{picture:02d}.png"), view, ImageResolution=view.ViewSize)
print("wrote", count, "pictures")
