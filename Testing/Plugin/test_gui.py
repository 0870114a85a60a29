"""Plays events in a real ParaView window and looks at the screen: test_gui.py PARAVIEW EVENTS.xml PICTURE.png

Needs the display of scripts/with-display, whose pixels it reads. The test fails if ParaView does, or if the picture
of the render view, left in PICTURE.png with the window round it, shows nothing but a background.
"""
import os
import subprocess
import sys
import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

WINDOW = (1280, 1000)
PATIENCE = 200  # seconds: a dialog that nobody expected waits for ever
# The part of the window in which the render view lies, without its legend, as fractions: left, right, top, bottom.
VIEW = (0.27, 0.88, 0.24, 0.94)
# Less than the data cover; more than axes and outline do, or a slice from whose edge the camera has not turned.
SMALLEST_COVERED_PART = 0.15
SMALLEST_NUMBER_OF_COLOURS = 8


def screen():
    """The pixels of the display, [row, column, rgb], from its XWD file."""
    with open(os.environ["STRATA_FRAMEBUFFER"], "rb") as file:
        data = file.read()
    header = numpy.frombuffer(data[:100], ">u4").astype(int)
    header_size, width, height, bytes_per_line, colours = header[[0, 4, 5, 12, 19]]
    pixels = numpy.frombuffer(data, numpy.uint8, bytes_per_line * height, header_size + 12 * colours)
    return pixels.reshape(height, bytes_per_line)[:, : 4 * width].reshape(height, width, 4)[..., 2::-1].copy()


def write_png(pixels, name):
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    flat = numpy.ascontiguousarray(pixels[::-1].reshape(-1, 3))
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=1))
    writer = vtkPNGWriter()
    writer.SetFileName(name)
    writer.SetInputData(image)
    writer.Write()


def play(paraview, events):
    """Runs ParaView and returns its exit code and the last picture of its window."""
    folder = os.path.dirname(os.environ["STRATA_PLUGIN"])
    window = f"{WINDOW[0]}x{WINDOW[1]}+0+0"
    process = subprocess.Popen([paraview, "--dr", "-qwindowgeometry", window, f"--plugin-search-paths={folder}",
                                "--plugins=Strata", f"--test-script={events}", "--exit"])
    last = None
    deadline = time.monotonic() + PATIENCE
    while process.poll() is None:
        if time.monotonic() > deadline:
            print("ERROR: ParaView doesn't end")
            process.kill()
        picture = screen()
        if (picture.max(axis=2) > 0).mean() > 0.5:  # the window is up
            last = picture
        time.sleep(0.5)
    return process.returncode, last


def faults(picture):
    """What is wrong with the render view in a picture of the window."""
    height, width = picture.shape[:2]
    left, right, top, bottom = VIEW
    view = picture[int(top * height): int(bottom * height), int(left * width): int(right * width)]
    colours, counts = numpy.unique((view // 16).reshape(-1, 3), axis=0, return_counts=True)
    covered = 1 - counts.max() / counts.sum()
    several = int((counts > 20).sum())
    print(f"data cover {covered:.3f} of the view, in {several} colours")
    if covered < SMALLEST_COVERED_PART:
        yield "the render view is empty"
    if several < SMALLEST_NUMBER_OF_COLOURS:
        yield "the render view has too few colours"


def main(paraview, events, name):
    code, picture = play(paraview, events)
    if picture is None:
        print("ERROR: no window appeared")
        return 1
    write_png(picture, name)
    found = list(faults(picture))
    for fault in found:
        print(f"ERROR: {fault}; see {name}")
    return 1 if code != 0 or found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
