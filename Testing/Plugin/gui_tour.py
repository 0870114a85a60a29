"""A tour of the plugin in a real ParaView window: gui_tour.py PARAVIEW DATA PICTURES

DATA holds the further data sets (cth, openfoam). Filters are applied from the menu, bounds and budget are changed, the
plane is turned, a state is saved and loaded. Each time the window comes to rest, its picture goes
into the folder PICTURES, to be looked at. Run it under scripts/with-display, with the plugin installed, or with
STRATA_PLUGIN naming its library. xdotool presses the button that events can't.
"""
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from xml.sax.saxutils import quoteattr

from test_gui import WINDOW, screen, write_png

MAIN = "pqClientMainWindow"
PANEL = (f"{MAIN}/propertiesDock/propertiesPanel/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/"
         "PropertiesFrame/ProxyPanel")
PLANE = f"{PANEL}/SliceType/ProxySelectionWidget/frame/ChosenProxyWidget/InteractivePlane"
REST = 1.5  # seconds without a change
PATIENCE = 300  # seconds for a tour
# What no event can do: the default button of a dialog that asks while a state is loaded. Pressed once, when the
# window has rested.
BY_HAND = {"reloaded": ("key", "Return")}


def event(widget, command, arguments=""):
    return f"  <pqevent object={quoteattr(widget)} command={quoteattr(command)} arguments={quoteattr(arguments)} />\n"


def pause(seconds=4.0):
    return event(MAIN, "pause", str(int(1000 * seconds)))


def apply():
    return event(f"{MAIN}/propertiesDock/propertiesPanel/Accept", "activate") + pause()


def open_file(path):
    return (event(f"{MAIN}/menubar/menu_File", "activate", "actionFileOpen")
            + event(f"{MAIN}/FileOpenDialog", "filesSelected", str(path)) + pause(1.0))


def add_filter(name):
    return event(f"{MAIN}/menubar/menuFilters/Strata", "activate", name) + pause(2.5)


def set_number(name, value):
    return event(f"{PANEL}/{name}/DoubleRangeWidget/DoubleLineEdit", "set_string", str(value))


def select(*path):
    """Makes a source of the pipeline browser active, by its place in the tree."""
    return event(f"{MAIN}/pipelineBrowserDock/pipelineBrowser", "currentChanged", "/".join(map(str, path)) + "|0")


def look_along_y():
    return event(f"{MAIN}/cameraToolbar/actionPositiveY", "activate") + pause(1.0)


def companions(representation):
    """Every filter that takes a representation alone; the last, a slice, stays."""
    steps = ""
    for name in ("MaterialContour", "ExtractMaterials", "RepresentedInterfaces"):
        steps += select(*representation) + add_filter(name) + apply()
        steps += event(f"{MAIN}/propertiesDock/propertiesPanel/Delete", "activate")
    return steps + select(*representation) + add_filter("MaterialSlice") + apply()


def cth(data, state):
    """The armor plate: bounds by line and by slider, a budget, a plane that is moved, a state."""
    budget = event(f"{PANEL}/LimitCells/CheckBox", "set_boolean", "true") + event(
        f"{PANEL}/MaximumNumberOfCells/IntRangeWidget/LineEdit", "set_string", "20000")
    return {
        "cth": open_file(data / "cth/cth.vtr") + apply() + add_filter("MaterialInterfaces") + apply()
        + event(f"{MAIN}/propertiesDock/propertiesPanel/Delete", "activate") + select(0, 0) + add_filter("MultiresolutionTetrahedra") + set_number("InterfaceErrorBound", 0.5) + apply()
        + event(f"{PANEL}/InterfaceErrorBound/DoubleRangeWidget/Slider", "set_int", "40") + budget + apply()
        + companions((0, 0, 0))
        + event(f"{PLANE}/useYNormal", "activate") + pause(1.5) + apply() + look_along_y()
        + event(f"{MAIN}/menubar/menu_File", "activate", "actionFileSaveServerState")
        + event(f"{MAIN}/FileSaveServerStateDialog", "filesSelected", str(state)) + pause(2.0),
        "reloaded": event(f"{MAIN}/menubar/menu_File", "activate", "actionFileLoadServerState")
        + event(f"{MAIN}/FileLoadServerStateDialog", "filesSelected", str(state)) + pause(2.0)
        + 10 * pause(3.0),
    }


def dam_break(data):
    return {"openfoam": open_file(data) + apply() + add_filter("MultiresolutionTetrahedra") + apply()
            + companions((0, 0, 0))}


class Film:
    """Pictures of the window whenever it rests."""

    def __init__(self, folder, name):
        self.folder, self.name, self.count = folder, name, 0
        self.last, self.saved, self.since = None, None, time.monotonic()

    def look(self):
        """Takes a picture; returns how long the window has not changed."""
        picture = screen()
        now = time.monotonic()
        if self.last is None or (picture != self.last).any():
            self.last, self.since = picture, now
        elif now - self.since > REST and (picture.max(axis=2) > 0).mean() > 0.5:
            if self.saved is None or (picture != self.saved).any(axis=2).mean() > 2e-4:
                self.count += 1
                write_png(picture, str(self.folder / f"{self.name}-{self.count:02d}.png"))
                self.saved = picture
        return now - self.since


def start(paraview, script):
    command = [paraview, "--dr", "-qwindowgeometry", f"{WINDOW[0]}x{WINDOW[1]}+0+0"]
    if "STRATA_PLUGIN" in os.environ:
        command += [f"--plugin-search-paths={os.path.dirname(os.environ['STRATA_PLUGIN'])}", "--plugins=Strata"]
    return subprocess.Popen(command + [f"--test-script={script}", "--exit"])


def play(paraview, name, events, folder):
    """Plays events in a window of their own; presses the button that cancels in the tour that asks for it."""
    with tempfile.NamedTemporaryFile("w", suffix=".xml", delete=False) as file:
        file.write(f'<?xml version="1.0" ?>\n<pqevents>\n{events}</pqevents>\n')
    process = start(paraview, file.name)
    film, pressed, end = Film(folder, name), name not in BY_HAND, time.monotonic() + PATIENCE
    while process.poll() is None:
        rested = film.look()
        if not pressed and film.count > 0 and rested > 6.0:
            subprocess.run(["xdotool", *BY_HAND[name]], check=True)
            pressed = True
        if time.monotonic() > end:
            print(f"ERROR: the tour {name} doesn't end")
            process.kill()
        time.sleep(0.25)
    os.unlink(file.name)
    print(f"{name}: {film.count} pictures, ParaView ended with {process.returncode}")
    return process.returncode


def main(paraview, data, folder):
    data, folder = Path(data), Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    tours = {**cth(data, folder / "cth.pvsm"),
             **dam_break(sorted(data.glob("openfoam/damBreak4phase_*.vtu"))[-1])}
    chosen = os.environ.get("STRATA_TOURS", " ".join(tours)).split()
    return max(play(paraview, name, tours[name], folder) for name in chosen)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
