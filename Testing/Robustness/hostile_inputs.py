"""Hostile inputs: each ends in an error or a warning that names the thing, or in a result; never in a crash.

VTK prints what filters say; the messages are caught here, so that only what is not expected fails the test.
"""
import sys

import numpy
import strata
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkOutputWindow, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON, VTK_LAGRANGE_HEXAHEDRON, VTK_POLYHEDRON, VTK_QUADRATIC_TETRA, VTK_TETRA, vtkCellArray, vtkImageData,
    vtkMultiBlockDataSet, vtkRectilinearGrid, vtkStructuredGrid, vtkUnstructuredGrid)

CUBE = numpy.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)], float)


class Outcome:
    """What the refinement of a data object ended in."""

    def __init__(self, data, **settings):
        self.said = []
        filter_ = strata.vtkStrataTetrahedra()
        filter_.SetMaximumLevel(9)
        for name, value in settings.items():
            getattr(filter_, name)(value)

        def note(_, event, text="?"):
            self.said.append(text)

        note.CallDataType = "string0"
        for observed in (filter_, filter_.GetExecutive()):
            observed.AddObserver("ErrorEvent", note)
            observed.AddObserver("WarningEvent", note)
        filter_.SetInputDataObject(0, data)
        filter_.Update()
        self.output = filter_.GetOutputDataObject(0)
        self.cells = self.output.GetNumberOfCells()
        names = self.output.GetFieldData().GetAbstractArray("material_names")
        self.materials = [names.GetValue(m) for m in range(names.GetNumberOfValues())] if names else []


def add(data, name, values):
    array = numpy_to_vtk(numpy.asarray(values), deep=True)
    array.SetName(name)
    data.GetCellData().AddArray(array)


def image(count=4, origin=0.0, ids=None, density=None):
    """Cubes of count^3 cells; material 1 below, 2 above."""
    data = vtkImageData()
    data.SetDimensions([count + 1] * 3)
    data.SetSpacing([1.0 / count] * 3)
    data.SetOrigin(origin, 0.0, 0.0)
    upper = numpy.arange(count ** 3) * 2 >= count ** 3
    add(data, "material", upper + 1 if ids is None else ids)
    add(data, "density", numpy.where(upper, 2.0, 1.0) if density is None else density)
    return data


def grid(points, cells, cell_type):
    data = vtkUnstructuredGrid()
    holder = vtkPoints()
    holder.SetData(numpy_to_vtk(numpy.asarray(points, float), deep=True))
    data.SetPoints(holder)
    array = vtkCellArray()
    offsets = numpy.cumsum([0] + [len(c) for c in cells])
    array.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_to_vtkIdTypeArray(numpy.concatenate(cells).astype(numpy.int64), deep=True))
    types = vtkUnsignedCharArray()
    for _ in cells:
        types.InsertNextValue(cell_type)
    data.SetCells(types, array)
    return data


def collection(blocks):
    data = vtkMultiBlockDataSet()
    data.SetNumberOfBlocks(len(blocks))
    for number, block in enumerate(blocks):
        data.SetBlock(number, block)
    return data


def two_cubes(change=lambda points: None, second=(1, 8, 9, 2, 5, 10, 11, 6), cell_type=VTK_HEXAHEDRON):
    """Two cubes side by side, points 0 to 11; `change` spoils the points."""
    points = numpy.concatenate([CUBE, CUBE[[1, 2, 5, 6]] + [1, 0, 0]])
    change(points)
    return grid(points, [numpy.arange(8), numpy.array(second)], cell_type)


def spoil(row, value):
    def change(points):
        points[row] = value
    return change


def bent_tetrahedron(bend):
    """Ten nodes, the one between the last two corners moved towards the first."""
    corners = CUBE[[0, 1, 3, 4]]
    middles = [corners[[a, b]].mean(axis=0) for a, b in ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))]
    return numpy.vstack([corners, middles - numpy.eye(6)[:, 5:] * bend])


def fractions(values, kind=numpy.float64):
    data = image()
    for name, array in zip("ab", values):
        add(data, "vf_" + name, numpy.asarray(array, kind))
    return data


def stretched(spacing):
    data = image()
    data.SetSpacing(1.0, spacing, 1.0)
    return data


def without(data, name):
    data.GetCellData().RemoveArray(name)
    return data


def bare(origin):
    data = image(4, origin)
    data.GetCellData().Initialize()
    return data


def with_fractions(origin):
    upper = numpy.arange(64) >= 32
    data = without(image(4, origin), "material")
    add(data, "vf_a", 1.0 - upper)
    add(data, "vf_b", 1.0 * upper)
    return data


def rectilinear(y):
    data = vtkRectilinearGrid()
    data.SetDimensions(5, 5, 5)
    data.SetXCoordinates(numpy_to_vtk(numpy.arange(5.0), deep=True))
    data.SetYCoordinates(numpy_to_vtk(numpy.array(y, float), deep=True))
    data.SetZCoordinates(numpy_to_vtk(numpy.arange(5.0), deep=True))
    return data


def degenerate_curvilinear():
    """Two cells side by side, the first without extent along x."""
    data = vtkStructuredGrid()
    data.SetDimensions(3, 2, 2)
    points = vtkPoints()
    for z in (0, 1):
        for y in (0, 1):
            for x in (1, 1, 2):
                points.InsertNextPoint(x, y, z)
    data.SetPoints(points)
    return data


def polyhedron(last_face):
    """A cube as a polyhedron with a face to choose."""
    data = vtkUnstructuredGrid()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(CUBE, deep=True))
    data.SetPoints(points)
    faces = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), last_face]
    stream = vtkIdList()
    for number in [len(faces)] + [entry for face in faces for entry in (len(face), *face)]:
        stream.InsertNextId(number)
    data.InsertNextCell(VTK_POLYHEDRON, stream)
    return data


def one(position, value, others):
    values = numpy.full(64, others, float)
    values[position] = value
    return values


NAN, INFINITY = float("nan"), float("inf")
# What it is: data, and texts that must be said.
REFUSED = {
    "point is NaN": (lambda: two_cubes(spoil(9, NAN)), ["cell 1", "not finite"]),
    "point is infinite": (lambda: two_cubes(spoil(9, INFINITY)), ["cell 1", "not finite"]),
    "corner beyond the points": (lambda: two_cubes(second=(1, 8, 9, 2, 5, 10, 12, 6)), ["Cell 1", "point 12"]),
    "corner below the points": (lambda: two_cubes(second=(1, 8, 9, 2, 5, 10, -3, 6)), ["Cell 1", "point -3"]),
    "corner of 2^40": (lambda: two_cubes(second=(1, 8, 9, 2, 5, 10, 2 ** 40, 6)), ["Cell 1", str(2 ** 40)]),
    "unknown type of cell": (lambda: two_cubes(cell_type=250), ["Cell 0", "type 250"]),
    "too few corners": (lambda: grid(CUBE, [numpy.arange(7)], VTK_HEXAHEDRON), ["Cell 0", "7 points"]),
    "node beyond the points": (
        lambda: grid(numpy.vstack([CUBE] * 2), [[0, 1, 3, 4, 5, 6, 7, 8, 9, 99]], VTK_QUADRATIC_TETRA),
        ["Cell 0", "point 99"]),
    "quadratic cell that is turned inside out": (
        lambda: grid(bent_tetrahedron(3.0), [numpy.arange(10)], VTK_QUADRATIC_TETRA), ["cell 0", "volume"]),
    "spacing 0": (lambda: stretched(0.0), ["along y", "spacing"]),
    "spacing below normal numbers": (lambda: stretched(1e-320), ["along y", "spacing", "e-321"]),
    "spacing NaN": (lambda: stretched(NAN), ["along y", "nan"]),
    "spacing infinite": (lambda: stretched(INFINITY), ["along y", "nan"]),
    "coordinates that repeat": (lambda: rectilinear([0, 1, 1, 3, 4]), ["along y", "number 2 is 1 after 1"]),
    "coordinates that descend": (lambda: rectilinear([0, 1, 0.5, 3, 4]), ["along y", "number 2 is 0.5 after 1"]),
    "coordinate NaN": (lambda: rectilinear([0, 1, NAN, 3, 4]), ["along y", "number 2 is nan after 1"]),
    "face beyond the points": (lambda: polyhedron((3, 0, 4, 99)), ["Cell 0", "point 99"]),
    "face below the points": (lambda: polyhedron((3, 0, 4, -5)), ["Cell 0", "point -5"]),
    "face of two points": (lambda: polyhedron((3, 0)), ["Polyhedron 0", "faces"]),
    "cell without points": (lambda: grid(numpy.zeros((0, 3)), [numpy.arange(8)], VTK_HEXAHEDRON),
                            ["Cell 0", "point 0"]),
    "id beyond 64-bit integers": (
        lambda: image(ids=numpy.array([1] * 5 + [2 ** 64 - 3] + [1] * 58, numpy.uint64)),
        ["cell 5", str(2 ** 64 - 3)]),
    "block whose ids are no integers": (
        lambda: collection([image(), image(4, 1.0, one(5, NAN, 1.0))]), ["material", "block '2'", "double"]),
    "block with three ids per cell": (
        lambda: collection([image(), image(4, 1.0, numpy.ones((64, 3), int))]), ["material", "block '2'", "holds 3"]),
    "negative id": (lambda: image(ids=numpy.arange(64) - 7), ["cell 0", "-7"]),
    "density NaN": (lambda: image(density=one(17, NAN, 1.0)), ["density", "cell 17", "nan"]),
    "density infinite": (lambda: image(density=one(17, INFINITY, 1.0)), ["density", "cell 17", "inf"]),
    "65 materials": (lambda: image(5, ids=numpy.arange(125)), ["64 materials"]),
    "fraction of 3": (lambda: fractions([one(5, 3.0, 0.5), one(5, -2.0, 0.5)]), ["cell 5", "3"]),
    "fraction NaN": (lambda: fractions([one(5, NAN, 0.5), one(5, 0.5, 0.5)]), ["cell 5", "nan"]),
    "negative fraction": (lambda: fractions([one(5, -0.4, 0.5), one(5, 1.4, 0.5)]), ["cell 5", "-0.4"]),
    "fraction infinite": (lambda: fractions([one(5, INFINITY, 0.5), one(5, 0.5, 0.5)]), ["cell 5", "inf"]),
    "block without arrays": (lambda: collection([image(), bare(1.0)]), ["material", "block '2'", "missing"]),
    "block without fractions": (
        lambda: collection([with_fractions(0.0), bare(1.0)]), ["vf_a", "block '2'", "missing"]),
    "block without ids": (lambda: collection([image(), without(image(4, 1.0), "material")]),
                          ["material", "block '2'", "missing"]),
    "no blocks": (lambda: collection([]), ["no visible cells"]),
    "empty blocks alone": (lambda: collection([vtkUnstructuredGrid(), None, vtkImageData()]), ["no visible cells"]),
}
USED = {
    "inverted cell": (lambda: two_cubes(second=(5, 10, 11, 6, 1, 8, 9, 2)), ["cell 1", "inverted", "left out"],
                      ["material"]),
    "degenerate cell": (lambda: two_cubes(second=(1, 8, 9, 2, 1, 8, 9, 2)), ["cell 1", "degenerate", "left out"],
                        ["material"]),
    "duplicate cells": (lambda: two_cubes(second=range(8)), ["cell 1 has the corners of cell 0", "left out"],
                        ["material"]),
    "degenerate curvilinear cell": (degenerate_curvilinear, ["cell 0", "volume", "degenerate", "without volume: 1"], ["material"]),
    "open polyhedron": (lambda: polyhedron((3, 0, 4)), ["Cell 0", "no closed polyhedron"], ["material"]),
    "ids that are no integers": (
        lambda: image(ids=one(5, 1.5, 1.0)), ["material", "integer per cell"], ["material"]),
    "64-bit ids": (lambda: image(ids=numpy.where(numpy.arange(64) < 32, 2 ** 40, 2 ** 62)), [],
                   [f"Material {2 ** 40}", f"Material {2 ** 62}"]),
    "empty blocks": (lambda: collection([vtkUnstructuredGrid(), image(), None, vtkImageData()]), [],
                     ["Material 1", "Material 2"]),
    "fractions a little off": (lambda: fractions([one(5, 0.55, 0.5), one(5, 0.5, 0.5)]), ["cell 5", "1.05"],
                               ["a", "b"]),
    "fractions as bytes": (lambda: fractions([one(5, 255, 0), one(5, 0, 255)], numpy.uint8), [], ["a", "b"]),
    "points that no cell uses are NaN": (
        lambda: grid(numpy.vstack([CUBE, [NAN] * 3]), [numpy.arange(8)], VTK_HEXAHEDRON), [], ["material"]),
    "a huge and a tiny cell": (
        lambda: grid(numpy.vstack([CUBE * 1e12, CUBE * 1e-3 - [1e6, 0, 0]]),
                     [numpy.arange(8), numpy.arange(8, 16)], VTK_HEXAHEDRON), [], ["material", "outside"]),
    "Lagrange cell of 26 nodes": (
        lambda: grid(numpy.vstack([CUBE, CUBE, CUBE, CUBE[:2]]), [numpy.arange(26)], VTK_LAGRANGE_HEXAHEDRON),
        ["1 curved cells are taken as straight"], ["material"]),
    "a quadratic cell that bends": (
        lambda: grid(bent_tetrahedron(0.1), [numpy.arange(10)], VTK_QUADRATIC_TETRA),
        ["1 curved cells are taken as linear ones"], ["material", "outside"]),
    "one tetrahedron": (lambda: grid(CUBE[[0, 1, 3, 4]], [numpy.arange(4)], VTK_TETRA), [], ["material", "outside"]),
}


def block_without_own_field():
    """The second block holds material 2 alone, and has no array of material 1's density."""
    ids = numpy.ones(64, int)
    blocks = [image(4, 0.0, ids), image(4, 1.0, 2 * ids)]
    for block, name in zip(blocks, ("density_Material 1", "density_Material 2")):
        block.GetCellData().RemoveArray("density")
        add(block, name, numpy.full(64, 3.0))
    return collection(blocks)


def check_blocks_lacking_fields():
    outcome = Outcome(block_without_own_field(), AddFieldArray="density")
    said = "".join(outcome.said)
    faults = [f"'{text}' isn't said: {said}" for text in ("block '2'", "density_Material 1") if text not in said]
    if outcome.cells == 0:
        return faults + ["no output"]
    values = vtk_to_numpy(outcome.output.GetPointData().GetArray("density"))
    return faults + ([] if numpy.allclose(values, 3.0) else ["density isn't 3 everywhere"])


def check_many_blocks():
    """10 000 blocks of one cell each; the thousandth layer from below is where the materials part."""
    blocks = []
    for number in range(10000):
        block = vtkImageData()
        block.SetDimensions(2, 2, 2)
        block.SetOrigin(number % 25, number // 25 % 20, number // 500)
        add(block, "material", [1 + (number >= 5000)])
        blocks.append(block)
    outcome = Outcome(collection(blocks))
    return [] if outcome.cells and outcome.materials == ["Material 1", "Material 2"] else [str(outcome.said)]


def check_refused(build, texts):
    outcome = Outcome(build())
    said = "".join(outcome.said)
    faults = [f"'{text}' isn't said: {said}" for text in texts if text not in said]
    if texts and outcome.cells:
        faults.append(f"{outcome.cells} cells")
    return faults


def check_used(build, texts, materials):
    outcome = Outcome(build())
    said = "".join(outcome.said)
    faults = [f"'{text}' isn't said: {said}" for text in texts if text not in said]
    if outcome.cells == 0 or outcome.materials != materials:
        faults.append(f"{outcome.cells} cells, materials {outcome.materials}: {said}")
    return faults


def main():
    vtkOutputWindow.SetInstance(vtkOutputWindow())
    checks = {name: (check_refused, *rest) for name, rest in REFUSED.items()}
    checks.update({name: (check_used, *rest) for name, rest in USED.items()})
    checks["blocks lacking fields"] = (check_blocks_lacking_fields,)
    checks["many blocks"] = (check_many_blocks,)
    faults = 0
    for name, (check, *arguments) in checks.items():
        found = check(*arguments)
        faults += len(found)
        for fault in found:
            print(f"FAULT {name}: {fault}", flush=True)
    print(f"{len(checks)} inputs, {faults} faults")
    sys.exit(faults > 0)


main()
