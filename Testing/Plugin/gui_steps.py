"""The steps of the tour of gui_tour.py, as events of ParaView's test player; each ends with a rest of the window."""
from xml.sax.saxutils import quoteattr

MAIN = "pqClientMainWindow"
PROPERTIES = f"{MAIN}/propertiesDock/propertiesPanel"
PANEL = f"{PROPERTIES}/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/PropertiesFrame/ProxyPanel"
PLANE = f"{PANEL}/SliceType/ProxySelectionWidget/frame/ChosenProxyWidget/InteractivePlane"
INPUTS = f"{MAIN}/SelectInputDialog"
# Places in the pipeline browser: the data, its representation.
DATA, REPRESENTATION = (0, 0), (0, 0, 0)


def event(widget, command, arguments=""):
    return f"  <pqevent object={quoteattr(widget)} command={quoteattr(command)} arguments={quoteattr(arguments)} />\n"


def pause(seconds=4.0):
    return event(MAIN, "pause", str(int(1000 * seconds)))


def press_apply():
    return event(f"{PROPERTIES}/Accept", "activate")


def apply():
    return press_apply() + pause()


def delete():
    return event(f"{PROPERTIES}/Delete", "activate")


def open_file(path):
    return (event(f"{MAIN}/menubar/menu_File", "activate", "actionFileOpen")
            + event(f"{MAIN}/FileOpenDialog", "filesSelected", str(path)) + pause(1.0))


def add_filter(name):
    return event(f"{MAIN}/menubar/menuFilters/Strata", "activate", name) + pause(2.5)


def set_number(name, value):
    return event(f"{PANEL}/{name}/LineEdit", "set_string", str(value))


def slide(name, step):
    return event(f"{PANEL}/{name}/Slider", "set_int", str(step))


def choose(name, text):
    """An entry of a combo box."""
    return event(f"{PANEL}/{name}/ComboBox", "set_string", text) + pause(1.5)


def limit_cells(yes):
    return event(f"{PANEL}/LimitCells/CheckBox", "set_boolean", "true" if yes else "false")


def show_advanced():
    return event(f"{PROPERTIES}/SearchBox/AdvancedButton", "set_boolean", "true") + pause(1.5)


def search(text):
    """Shows only the properties whose name has the text."""
    return event(f"{PROPERTIES}/SearchBox/SearchLineEdit", "set_string", text) + pause(1.5)


def select(*path):
    """Makes a source of the pipeline browser active, by its place in the tree."""
    return event(f"{MAIN}/pipelineBrowserDock/pipelineBrowser", "currentChanged", "/".join(map(str, path)) + "|0")


def look_along_y():
    return event(f"{MAIN}/cameraToolbar/actionPositiveY", "activate") + pause(1.0)


def add_filter_of_two(name, port, place):
    """A filter whose second input is chosen in ParaView's dialog, by its place in the tree."""
    path = "".join(f"/{row}:0" for row in place)
    click = "1,{},0,60,6," + path
    return (event(f"{MAIN}/menubar/menuFilters/Strata", "activate", name)
            + event(f"{INPUTS}/buttonFrame/{port}", "set_boolean", "true")
            + event(f"{INPUTS}/pipelineView", "mousePress", click.format(1))
            + event(f"{INPUTS}/pipelineView", "mouseRelease", click.format(0)) + pause(2.0)
            + event(f"{INPUTS}/buttonBox/1QPushButton0", "activate") + pause(2.0))


def companions(height):
    """Every filter that takes a representation; a slice across y at this height stays, seen from its front."""
    steps = ""
    for name in ("MaterialContour", "ExtractMaterials", "RepresentedInterfaces"):
        steps += select(*REPRESENTATION) + add_filter(name) + apply() + delete()
    return (steps + select(*REPRESENTATION) + add_filter("MaterialSlice") + event(f"{PLANE}/useYNormal", "activate")
            + event(f"{PLANE}/originY", "set_string", str(height)) + apply() + look_along_y() + pause()
            + select(*REPRESENTATION) + add_filter_of_two("SampleRepresentation", "Points", (*REPRESENTATION, 0))
            + apply() + delete())


def read_levels(count):
    """For an AMR file, of which ParaView's reader takes one level by default."""
    return event(f"{PANEL}/DefaultNumberOfLevels/IntRangeWidget/LineEdit", "set_string", str(count)) + pause(1.0)


def refined(path, bound):
    return (open_file(path) + apply() + add_filter("MultiresolutionTetrahedra")
            + set_number("InterfaceErrorBound", bound) + apply())


def all_filters(path, bound, height, reader=""):
    """Opens data, the reader's properties set by further events, then every filter in turn; a slice at a height y."""
    return (open_file(path) + reader + apply() + add_filter("MaterialInterfaces") + apply() + delete() + select(*DATA)
            + add_filter("MultiresolutionTetrahedra") + set_number("InterfaceErrorBound", bound) + apply()
            + companions(height))


def error_table(path, bound):
    return (refined(path, bound) + add_filter_of_two("RepresentationError", "Original", DATA) + apply() + pause())


def sliders(path, bound):
    """Bound and budget by their sliders, materials from the list, a box and a ball of interest."""
    materials = f"{PANEL}/FocusMaterials/ArraySelectionWidget/1QHeaderView0"
    tick_all = event(materials, "mousePress", "1,1,0,0,0,0") + event(materials, "mouseRelease", "1,0,0,0,0,0")
    return (refined(path, bound) + slide("InterfaceErrorBound", 220) + slide("FieldErrorBound", 250) + apply()
            + limit_cells(True) + slide("MaximumNumberOfCells", 180) + apply() + limit_cells(False) + show_advanced()
            + search("region") + choose("RegionOfInterest", "Sphere") + apply()
            + choose("RegionOfInterest", "Box") + apply() + choose("RegionOfInterest", "None")
            + search("focus") + tick_all + pause(1.5) + apply() + search(""))


def save_state(path):
    return (event(f"{MAIN}/menubar/menu_File", "activate", "actionFileSaveServerState")
            + event(f"{MAIN}/FileSaveServerStateDialog", "filesSelected", str(path)) + pause(2.0))


def sliced(path, bound, before, after):
    """A slice across the longest side; then the hand drags its plane. States are saved before and after."""
    return (refined(path, bound) + add_filter("MaterialSlice") + event(f"{PLANE}/useYNormal", "activate") + apply()
            + save_state(before) + 8 * pause(4.0) + apply() + save_state(after) + look_along_y() + pause())


def long_run(path):
    """A bound that takes minutes; then the hand presses the abort button."""
    return (open_file(path) + apply() + add_filter("MultiresolutionTetrahedra") + set_number("InterfaceErrorBound", 0.002)
            + set_number("FieldErrorBound", 0.0001) + press_apply() + pause()
            + set_number("InterfaceErrorBound", 0.3) + set_number("FieldErrorBound", 0.1) + apply() + pause())


def saved(path, bound, state):
    return (refined(path, bound) + add_filter("MaterialSlice") + event(f"{PLANE}/useYNormal", "activate") + apply()
            + look_along_y() + save_state(state))


def loaded(state):
    return (event(f"{MAIN}/menubar/menu_File", "activate", "actionFileLoadServerState")
            + event(f"{MAIN}/FileLoadServerStateDialog", "filesSelected", str(state)) + 8 * pause(3.0))
