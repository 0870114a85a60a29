"""A tour of the plugin in a real ParaView window: gui_tour.py PARAVIEW DATA PICTURES [TOUR...]

DATA holds the further data sets (cth, spcth, openfoam), which ParaView's own readers open. Each filter is applied from
the menu; sliders are moved, regions and materials chosen, a plane is dragged with the mouse, a long run is aborted with
the window's button, an error table is shown, a state is saved and loaded. Each time the window comes to rest, its picture
goes into the folder PICTURES, to be looked at. Run it under scripts/with-display, with the plugin installed, or with
STRATA_PLUGIN naming its library. xdotool is the hand that moves the mouse.
"""
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from xml.etree import ElementTree

import gui_steps as steps
from test_gui import WINDOW, screen, write_png

REST = 1.5  # seconds without a change
PATIENCE = 400  # seconds for a tour
STATUS_BAR = 25  # rows at the window's lower end
VIEW = (slice(200, -STATUS_BAR), slice(310, 1100))  # rows and columns of the render view, without its legend


def hand(*actions):
    subprocess.run(["xdotool", *map(str, actions)], check=True)


def close_dialog(film):
    """The default button of the dialog that asks while a state is loaded."""
    if film.rested() < 6.0 or film.count == 0:
        return False
    hand("key", "Return")
    return True


def drag(x, y, down):
    """Presses the button, moves the mouse down (or up, if negative) in small steps, and lets go."""
    hand("mousemove", x, y)
    time.sleep(1.0)
    hand("mousedown", 1)
    for step in range(1, 21):
        hand("mousemove", x, y + down * step // 20)
        time.sleep(0.1)
    hand("mouseup", 1)
    time.sleep(2.0)


def drag_plane(film):
    """Turns the red plane by the tip of its normal, then pushes it, taken left of its middle.

    A drag turns the normal about the axis in the screen normal to the drag: one sideways would spin it about itself.
    """
    red = is_red(film.last[VIEW]) if film.rested() > 6.0 else None
    if red is None or red.sum() < 300:
        return False
    rows, columns = red.nonzero()
    top, left = VIEW[0].start + rows.min(), VIEW[1].start
    tip = left + int(columns[rows < rows.min() + 12].mean())
    drag(tip, top + 12, 60)
    film.look()
    film.save()
    drag(tip - 60, VIEW[0].start + (rows.min() + rows.max()) // 2, -60)
    return True


def plane_of(state):
    """Origin and normal of the slice's plane in a saved state."""
    tree = ElementTree.parse(state)
    place = tree.find(".//Proxy[@type='MaterialSlice']/Property[@name='SliceType']/Proxy").get("value")
    plane = tree.find(f".//Proxy[@type='Plane'][@id='{place}']")
    return [[float(element.get("value")) for element in plane.iterfind(f"Property[@name='{name}']/Element")]
            for name in ("Origin", "Normal")]


def plane_has_moved(before, after):
    """Whether the hand has changed the plane's origin and its normal."""
    pairs = list(zip(("origin", "normal"), plane_of(before), plane_of(after)))
    for name, old, new in pairs:
        print(f"{name} before and after the drag: {old} {new}")
    return all(max(abs(a - b) for a, b in zip(old, new)) > 0.01 for _, old, new in pairs)


def is_red(picture):
    return (picture[..., 0] > 150) & (picture[..., 1:].max(axis=2) < 90)


def abort_button(picture):
    """Where the abort button is, if it can be pressed: the only red thing in the status bar."""
    rows, columns = is_red(picture[-STATUS_BAR:]).nonzero()
    if len(rows) < 10:
        return None
    return int(columns.mean()), len(picture) - STATUS_BAR + int(rows.mean())


def press_abort(film):
    """Waits until the button can be pressed, presses it, and tells how long the run went on."""
    place = abort_button(film.last) if film.last is not None else None
    if place is None:
        film.busy = time.monotonic()
        return False
    if time.monotonic() - film.busy < 4.0:  # well into the run
        return False
    film.save()
    hand("mousemove", *place, "click", 1)
    pressed = time.monotonic()
    while abort_button(screen()) is not None and time.monotonic() - pressed < 60.0:
        time.sleep(0.02)
    print(f"the run went on for {time.monotonic() - pressed:.2f} s after the button was pressed")
    return True


def tours(data, folder):
    """Name -> events, what the hand does when it is time (called until it returns true), what must hold at the end."""
    cth, state, before, after = data / "cth/cth.vtr", *(folder / f"{name}.pvsm" for name in ("cth", "before", "after"))
    return {
        "cth": (steps.all_filters(cth, 0.5, 0.0),),
        "amr": (steps.all_filters(data / "spcth/spcth_t4.vth", 0.2, 32.0, steps.read_levels(3)),),
        "openfoam": (steps.all_filters(data / "openfoam/damBreakWithObstacle_t0.30.vtu", 0.02, 0.2),),
        "errors": (steps.error_table(cth, 0.5),),
        "sliders": (steps.sliders(cth, 0.5),),
        "plane": (steps.sliced(cth, 0.5, before, after), drag_plane, lambda: plane_has_moved(before, after)),
        "abort": (steps.long_run(cth), press_abort),
        "saved": (steps.saved(cth, 0.5, state),),
        "loaded": (steps.loaded(state), close_dialog),
    }


class Film:
    """Pictures of the window whenever it rests."""

    def __init__(self, folder, name):
        self.folder, self.name, self.count = folder, name, 0
        self.last, self.saved, self.since = None, None, time.monotonic()

    def look(self):
        """Takes a picture, and keeps it if the window rests and has changed since the last one kept."""
        picture = screen()
        if self.last is None or (picture != self.last).any():
            self.last, self.since = picture, time.monotonic()
        elif self.rested() > REST and (picture.max(axis=2) > 0).mean() > 0.5:
            if self.saved is None or (picture != self.saved).any(axis=2).mean() > 2e-4:
                self.save()

    def rested(self):
        """For how many seconds the window has not changed."""
        return time.monotonic() - self.since

    def save(self):
        self.count += 1
        write_png(self.last, str(self.folder / f"{self.name}-{self.count:02d}.png"))
        self.saved = self.last


def start(paraview, script):
    command = [paraview, "--dr", "-qwindowgeometry", f"{WINDOW[0]}x{WINDOW[1]}+0+0"]
    if "STRATA_PLUGIN" in os.environ:
        command += [f"--plugin-search-paths={os.path.dirname(os.environ['STRATA_PLUGIN'])}", "--plugins=Strata"]
    return subprocess.Popen(command + [f"--test-script={script}", "--exit"])


def play(paraview, folder, name, events, act=None, holds=lambda: True):
    """Plays events in a window of their own, the hand acting once; false if ParaView fails or what must hold does not."""
    with tempfile.NamedTemporaryFile("w", suffix=".xml", delete=False) as file:
        file.write(f'<?xml version="1.0" ?>\n<pqevents>\n{events}</pqevents>\n')
    process = start(paraview, file.name)
    film, done, end = Film(folder, name), act is None, time.monotonic() + PATIENCE
    while process.poll() is None:
        film.look()
        done = done or act(film)
        if time.monotonic() > end:
            print(f"ERROR: the tour {name} doesn't end")
            process.kill()
        time.sleep(0.25)
    os.unlink(file.name)
    if not done:
        print(f"ERROR: in the tour {name} there was nothing for the hand to do")
    print(f"{name}: {film.count} pictures, ParaView ended with {process.returncode}")
    if process.returncode != 0 or not done:
        return False
    if not holds():
        print(f"ERROR: the tour {name} did not do what it should")
        return False
    return True


def main(paraview, data, folder, *chosen):
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    known = tours(Path(data), folder)
    results = [play(paraview, folder, name, *known[name]) for name in chosen or known]
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
