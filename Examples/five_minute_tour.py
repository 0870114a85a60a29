"""Five minutes with Strata: read a simulation, refine it, look inside, save it, and go on from the saved file.

    pvpython five_minute_tour.py
"""
from paraview import simple
from strata_example import data, field_value, load_plugin, output, read_impact

load_plugin()

# A case file names the grids of a simulation over time and says which arrays belong to which material.
case = read_impact(time=15.0)

# Tetrahedra as fine as two bounds ask: here interfaces to 0.1 units of length, density to 0.5 g/cm3.
tetrahedra = simple.MultiresolutionTetrahedra(
    Input=case, FieldArrays=["density"], InterfaceErrorBound=0.1, AbsoluteFieldErrorBounds=["density", "0.5"])
mesh = data(tetrahedra)
print(f"{mesh.GetNumberOfCells()} tetrahedra, interfaces within {field_value(mesh, 'achieved_interface_error'):.3f}, "
      f"density within {field_value(mesh, 'achieved_field_error_density'):.3f}")

# Looser bounds give a smaller mesh at once: the hierarchy is kept, the input isn't read again.
tetrahedra.InterfaceErrorBound = 0.3
print(f"{data(tetrahedra).GetNumberOfCells()} tetrahedra at three times the interface bound")
tetrahedra.InterfaceErrorBound = 0.1

# A slice stays sharp: every polygon lies in one material and has that material's density.
section = simple.MaterialSlice(Input=tetrahedra)
section.SliceType.Origin = [0.0, 0.0, 0.0]
section.SliceType.Normal = [0.0, 1.0, 0.0]
view = simple.CreateView("RenderView")
view.ViewSize = [800, 1000]
display = simple.Show(section, view)
simple.ColorBy(display, ("POINTS", "density"))
display.Ambient, display.Diffuse = 1.0, 0.0
display.SetScalarBarVisibility(view, True)
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [6, -60, -5.6], [6, 0, -5.6], [0, 0, 1]
simple.ResetCamera(view)
simple.SaveScreenshot(output("tour_slice.png"), view, ImageResolution=view.ViewSize)

# The file says all of itself. Binary mode: ParaView 5.11 as packaged by Debian reads no appended data.
simple.SaveData(output("tour.vtu"), proxy=tetrahedra, DataMode="Binary")
loaded = simple.OpenDataFile(output("tour.vtu"))
again = simple.MaterialSlice(Input=loaded)
again.SliceType.Origin = [0.0, 0.0, 0.0]
again.SliceType.Normal = [0.0, 1.0, 0.0]
print(f"{data(section).GetNumberOfCells()} polygons in the slice, {data(again).GetNumberOfCells()} from the saved file")
