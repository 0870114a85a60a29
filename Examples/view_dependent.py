"""Refines for the picture: the mesh is as fine as the camera of the active view can see.

    pvpython view_dependent.py
"""
from paraview import simple
from strata_example import data, load_plugin, output, read_impact


def refine_for_view(tetrahedra, view=None, pixels=1.0):
    """Copies the camera of a view (the active one by default) into a MultiresolutionTetrahedra proxy.

    Interface errors of up to so many pixels are allowed on the screen. Call it again when the camera has moved.
    """
    view = view or simple.GetActiveViewOrCreate("RenderView")
    width, height = view.ViewSize
    tetrahedra.CameraPosition = list(view.CameraPosition)
    tetrahedra.CameraFocalPoint = list(view.CameraFocalPoint)
    tetrahedra.CameraViewUp = list(view.CameraViewUp)
    tetrahedra.CameraViewAngle = view.CameraViewAngle
    tetrahedra.ImageHeight = height
    tetrahedra.ImageAspect = width / height
    tetrahedra.PixelErrorBound = pixels
    tetrahedra.ViewDependent = 1


def main():
    load_plugin()
    tetrahedra = simple.MultiresolutionTetrahedra(
        Input=read_impact(), FieldArrays=["density"], InterfaceErrorBound=0.05,
        AbsoluteFieldErrorBounds=["density", "0.5"])
    print(f"the whole: {data(tetrahedra).GetNumberOfCells()} cells")
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = [800, 600]
    simple.Show(simple.RepresentedInterfaces(Input=tetrahedra), view)
    simple.ResetCamera(view)
    camera = view.GetActiveCamera()
    for step in range(4):
        refine_for_view(tetrahedra, view)
        print(f"zoom {2 ** step}: {data(tetrahedra).GetNumberOfCells()} cells")
        simple.SaveScreenshot(output(f"view_dependent_{step}.png"), view)
        camera.Dolly(2.0)


if __name__ == "__main__":
    main()
