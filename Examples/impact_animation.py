"""Plays the impact: a picture per time step of the slice y = 0, coloured by density, and what each step cost.

    pvpython impact_animation.py
"""
import time

from paraview import simple
from strata_example import load_plugin, output, read_impact

load_plugin()
case = read_impact()
tetrahedra = simple.MultiresolutionTetrahedra(
    Input=case, FieldArrays=["density"], InterfaceErrorBound=0.15, AbsoluteFieldErrorBounds=["density", "0.5"])
section = simple.MaterialSlice(Input=tetrahedra)
section.SliceType.Origin = [0.0, 0.0, 0.0]
section.SliceType.Normal = [0.0, 1.0, 0.0]

view = simple.CreateView("RenderView")
view.ViewSize = [600, 800]
display = simple.Show(section, view)
simple.ColorBy(display, ("POINTS", "density"))
# One scale for all steps, and no light: colours mean values.
simple.GetColorTransferFunction("density").RescaleTransferFunction(7.0, 24.0)
display.Ambient, display.Diffuse = 1.0, 0.0
display.SetScalarBarVisibility(view, True)
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [6, -45, 0], [6, 0, 0], [0, 0, 1]
simple.ResetCamera(view)

keeper = simple.GetTimeKeeper()
for step, value in enumerate(case.TimestepValues):
    start = time.perf_counter()
    keeper.Time = value
    tetrahedra.UpdatePipeline(value)
    simple.SaveScreenshot(output(f"impact_{step:02d}.png"), view)
    print(f"{value:6.1f} us: {tetrahedra.GetDataInformation().GetNumberOfCells():7} cells, "
          f"{time.perf_counter() - start:.2f} s")
