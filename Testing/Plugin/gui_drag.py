"""Drags the bound, the budget and the plane in a real ParaView window: gui_drag.py PARAVIEW DATA FOLDER

DATA holds the further data sets; the CTH run is used. The panel's slider for the interface bound, the number of cells and
the plane's origin are moved step by step, each followed by Apply, as a user would. FOLDER receives a picture of the window
whenever it rests and ParaView's timer log, of which the filters' and the view's times are printed. Run it under
scripts/with-display, with the plugin installed, or with STRATA_PLUGIN naming its library.
"""
import os
import re
import statistics
import subprocess
import sys
import time
from pathlib import Path

import gui_tour
from gui_steps import (PLANE, add_filter, apply, event, limit_cells, look_along_y, open_file, pause, set_number, slide)
from gui_tour import Film
from test_gui import WINDOW

STEPS = 6
# Runs in the window before the first event; the log is written when the window closes.
START = """
import atexit
from vtkmodules.vtkCommonSystem import vtkTimerLog
vtkTimerLog.SetMaxEntries(100000)
vtkTimerLog.LoggingOn()

def write():
    log = vtkTimerLog
    with open({log!r}, "w") as file:
        for i in range(log.GetNumberOfEvents()):
            file.write(f"{{log.GetEventWallTime(i):.6f}} {{int(log.GetEventType(i))}} {{log.GetEventString(i)}}\\n")

atexit.register(write)
"""
STARTED, ENDED = 1, 2  # types of events


def drag_bound():
    return "".join(slide("InterfaceErrorBound", 240 - 10 * step) + apply() for step in range(STEPS))


def drag_budget():
    return limit_cells(True) + "".join(
        set_number("MaximumNumberOfCells", 10000 * (step + 1)) + apply() for step in range(STEPS))


def drag_plane(first, last):
    line = f"{PLANE}/originY"
    places = [first + (last - first) * step / (STEPS - 1) for step in range(STEPS)]
    return "".join(event(line, "set_string", f"{place:.3f}") + apply() for place in places)


def session(data):
    return (open_file(data / "cth/cth.vtr") + apply() + add_filter("MultiresolutionTetrahedra")
            + set_number("InterfaceErrorBound", 0.3) + apply() + drag_bound() + drag_budget()
            + add_filter("MaterialSlice") + event(f"{PLANE}/useYNormal", "activate") + pause(1.0) + apply()
            + look_along_y() + drag_plane(-0.6, 0.6))


def play(paraview, events, folder):
    script, start = folder / "session.xml", folder / "start.py"
    script.write_text(f'<?xml version="1.0" ?>\n<pqevents>\n{events}</pqevents>\n')
    start.write_text(START.format(log=str(folder / "timer.log")))
    command = [paraview, "--dr", "-qwindowgeometry", f"{WINDOW[0]}x{WINDOW[1]}+0+0", f"--script={start}"]
    if "STRATA_PLUGIN" in os.environ:
        command += [f"--plugin-search-paths={os.path.dirname(os.environ['STRATA_PLUGIN'])}", "--plugins=Strata"]
    process = subprocess.Popen(command + [f"--test-script={script}", "--exit"])
    film = Film(folder, "drag")
    while process.poll() is None:
        film.look()
        time.sleep(0.25)
    print(f"{film.count} pictures, ParaView ended with {process.returncode}")
    return process.returncode


def print_times(lines):
    """Milliseconds of each run of Strata's filters and of the view, in their order."""
    begun, found = {}, {}
    for line in lines:
        seconds, kind, name = line.split(" ", 2)
        label = re.sub(r" \(.*| id: .*", "", name)
        if int(kind) == STARTED:
            begun[name] = float(seconds)
        elif int(kind) == ENDED and name in begun and re.search("Tetrahedra|Slice|^Render|Still Render", label):
            found.setdefault(label, []).append(1000.0 * (float(seconds) - begun.pop(name)))
    for name, times in found.items():
        print(f"{name}: median {statistics.median(times):.0f} ms of " + " ".join(f"{t:.0f}" for t in times))


def record(paraview, events, folder, rest):
    """Plays a session and prints its times; the window rests so many seconds before a picture is taken."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    gui_tour.REST = rest
    result = play(paraview, events, folder)
    print_times((folder / "timer.log").read_text().splitlines())
    return result


def main(paraview, data, folder):
    return record(paraview, session(Path(data)), folder, 0.5)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
