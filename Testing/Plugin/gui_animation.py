"""Plays the impact's time steps in a real ParaView window: gui_animation.py PARAVIEW DATA FOLDER [field]

DATA is the project's folder Data. The case is opened, refined and sliced; then the frames are stepped through from the
first to the last and to the first again, as the player's buttons do. Each frame is shown by the field, then by material;
with "field", by the field alone, and its range must stay. (Whenever colours are chosen anew, ParaView extends the range
by what is shown.)
FOLDER receives a picture of the window whenever it rests, to be looked at (the materials' colours and names must stay),
and ParaView's timer log, of which the times of the filters are printed: one a frame. Run it under scripts/with-display,
with STRATA_PLUGIN naming the plugin's library.
"""
import sys
from pathlib import Path

from gui_drag import record
from gui_steps import MAIN, PLANE, add_filter, apply, event, look_along_y, open_file, pause, set_number

FRAMES = 6
FIELD = "density"


def color_by(array):
    return event(f"{MAIN}/variableToolbar/displayColor/Variables", "set_string", array) + pause(2.0)


def step(button):
    return event(f"{MAIN}/VCRToolbar/{button}", "activate") + pause(3.0)


def shown_twice(button):
    """A step in the colours of the field, then in those of the materials; the next begins with the field again."""
    return step(button) + color_by("material") + color_by(FIELD)


def session(data, shown):
    return (open_file(data / "impact/impact.strata") + apply() + step("actionVCRLastFrame")
            + add_filter("MultiresolutionTetrahedra") + set_number("InterfaceErrorBound", 0.15) + apply()
            + add_filter("MaterialSlice") + event(f"{PLANE}/useYNormal", "activate") + pause(1.0)
            + event(f"{PLANE}/originY", "set_string", "0.5")
            + event(f"{PLANE}/show3DWidget", "set_boolean", "false") + apply() + look_along_y()
            + shown("actionVCRFirstFrame") + (FRAMES - 1) * shown("actionVCRNextFrame") + shown("actionVCRFirstFrame"))


def main(paraview, data, folder, shown="both"):
    return record(paraview, session(Path(data).resolve(), step if shown == "field" else shown_twice), folder, 1.0)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
