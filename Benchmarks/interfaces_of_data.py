"""Interfaces of real data in a table and in pictures: triangles, volumes, cells that are wrong, open edges, time.

    export PYTHONPATH=build/lib/python3/dist-packages
    scripts/with-display pvpython Benchmarks/interfaces_of_data.py FOLDER PICTURES [PART_OF_A_NAME]

FOLDER holds the data sets (impact, openfoam, cth, ...), PICTURES gets a picture of each. Volumes are corrected.
"""
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import numpy
import real_data
import strata
from paraview import simple
from real_data_sets import load
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter

NAMES = ("impact 32", "impact 128", "cth", "dam break cells", "charge 0.17", "sloshing 8", "drop", "spcth leaves",
         "triple point", "frog")
COLORS = [(0.90, 0.42, 0.18), (0.35, 0.60, 0.83), (0.45, 0.70, 0.45), (0.80, 0.70, 0.30), (0.60, 0.45, 0.70)]
WRONG = 0.01  # error of a cell's volume, as a part of it


def parts_of(collection):
    """The surfaces between materials, and the grids with the volumes' errors."""
    surfaces, grids = [], []
    iterator = collection.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        part = iterator.GetCurrentDataObject()
        name = iterator.GetCurrentMetaData().Get(vtkCompositeDataSet.NAME()) or ""
        (surfaces if part.GetCellData().HasArray("positive_material") else grids).append((name, part))
        iterator.GoToNextItem()
    return [part for _, part in surfaces if part.GetNumberOfCells()], [part for _, part in grids]


def wrong_cells(grids):
    """How many cells have a material whose volume is wrong."""
    count = 0
    for grid in grids:
        sizes = vtkCellSizeFilter()
        sizes.SetInputDataObject(grid)
        sizes.Update()
        cells = sizes.GetOutput().GetCellData()
        names = [cells.GetArrayName(i) for i in range(cells.GetNumberOfArrays())]
        errors = [numpy.abs(vtk_to_numpy(cells.GetArray(n))) for n in names if n.startswith("volume_error_")]
        if errors:
            count += (numpy.max(errors, axis=0) > WRONG * vtk_to_numpy(cells.GetArray("Volume"))).sum()
    return count


def open_edges(surfaces, bounds):
    """Edges off the sides of the box round which the materials' triangles leave a material open: for each material
    and edge the triangles that bound it are to be even in number."""
    points = numpy.concatenate([vtk_to_numpy(s.GetPoints().GetData()) for s in surfaces])
    numbers = numpy.unique(points, axis=0, return_inverse=True)[1].reshape(-1)
    first, edges = 0, {}
    for surface in surfaces:
        corners = numbers[first + vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
        first += surface.GetNumberOfPoints()
        sides = numpy.sort(corners[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        sides = sides[sides[:, 0] != sides[:, 1]]  # single precision lets the shortest ones collapse
        for side in ("positive_material", "negative_material"):
            material = int(surface.GetCellData().GetArray(side).GetValue(0))
            edges.setdefault(material, []).append(sides)
    places = numpy.zeros((numbers.max() + 1, 3))
    places[numbers] = points
    lower, upper = numpy.array(bounds)[::2], numpy.array(bounds)[1::2]
    near = 1e-5 * (upper - lower).max()
    count = 0
    for material in edges:
        sides, uses = numpy.unique(numpy.concatenate(edges[material]), axis=0, return_counts=True)
        ends = places[sides[uses % 2 == 1]]
        inside = ~((numpy.abs(ends - lower) < near) | (numpy.abs(ends - upper) < near)).all(axis=1).any(axis=1)
        count += inside.sum()
    return count


def draw(surfaces, path):
    """The interfaces, coloured by their lower material, seen from a corner."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [1000, 800]
    view.OrientationAxesVisibility = 0
    for surface in surfaces:
        source = simple.TrivialProducer()
        source.GetClientSideObject().SetOutput(surface)
        shown = simple.Show(source, view)
        materials = [surface.GetCellData().GetArray(side).GetValue(0)
                     for side in ("positive_material", "negative_material")]
        shown.ColorArrayName = [None, ""]
        shown.DiffuseColor = shown.AmbientColor = COLORS[int(min(materials)) % len(COLORS)]
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [1.0, -1.6, 1.1], [0.0] * 3, [0.0, 0.0, 1.0]
    simple.ResetCamera(view)
    simple.SaveScreenshot(str(path), view)
    simple.Delete(view)


def run(name, folder, pictures):
    """A line of the table."""
    data, settings = load(folder, name)
    algorithm = real_data.configured(strata.vtkStrataMaterialInterfaces(), settings, False)
    algorithm.SetVolumeErrors(True)
    algorithm.SetInputDataObject(0, data)
    start = time.process_time()
    algorithm.Update()
    seconds = time.process_time() - start
    result = algorithm.GetOutputDataObject(0)
    surfaces, grids = parts_of(result)
    bounds = [0.0] * 6
    data.GetBounds(bounds)
    given, found = [vtk_to_numpy(array) if array else numpy.zeros(1) for array in (
        result.GetFieldData().GetArray("volume_given"), result.GetFieldData().GetArray("volume_reconstructed"))]
    total = numpy.abs(found - given).max() / (given.sum() or 1.0)
    triangles = sum(surface.GetNumberOfCells() for surface in surfaces)
    draw(surfaces, pictures / (name.replace(" ", "_") + ".png"))
    print(f"| {name} | {data.GetNumberOfElements(1)} | {triangles} | {total:.1e} | {wrong_cells(grids)} | "
          f"{open_edges(surfaces, bounds)} | {seconds:.1f} s |", flush=True)


def main():
    folder, pictures = Path(sys.argv[1]), Path(sys.argv[2])
    pictures.mkdir(parents=True, exist_ok=True)
    print("| data | cells | triangles | largest error of a total | cells above 0.01 | open edges | CPU |")
    print("|---|---|---|---|---|---|---|")
    for name in NAMES:
        if len(sys.argv) < 4 or sys.argv[3] in name:
            run(name, folder, pictures)


if __name__ == "__main__":
    main()
