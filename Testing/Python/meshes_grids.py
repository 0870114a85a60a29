"""The problem of meshes_problem.py in every kind of grid, built with plain VTK.

Each builder returns a data object and the visible cells, a list of `Cells`.
"""
import itertools

import numpy
from meshes_problem import Cells, LEVELS, NORMAL, add_arrays
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkBitArray, vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON, VTK_POLYHEDRON, VTK_PYRAMID, VTK_QUADRATIC_HEXAHEDRON, VTK_TETRA, VTK_VOXEL, VTK_WEDGE, vtkAMRBox,
    vtkCellArray, vtkExplicitStructuredGrid, vtkHyperTreeGrid, vtkHyperTreeGridNonOrientedGeometryCursor, vtkImageData,
    vtkMultiBlockDataSet, vtkOverlappingAMR, vtkRectilinearGrid, vtkStructuredGrid, vtkUniformGrid, vtkUnstructuredGrid)

CELLS = 8  # along each axis
CUBE = numpy.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)])
FACES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]  # seen from outside
EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
GHOST, HIDDEN = 1, 32
SHEAR = numpy.array([[0.95, 0.2, 0.0], [-0.15, 0.9, 0.1], [0.05, 0.0, 0.85]])


def cubes(lower=(0, 0, 0), upper=(CELLS,) * 3, size=1.0 / CELLS):
    """Corners of the cells of a lattice of cubes, those along x first."""
    axes = [numpy.arange(lower[axis], upper[axis]) for axis in range(3)]
    z, y, x = numpy.meshgrid(*reversed(axes), indexing="ij")
    first = numpy.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
    return (first[:, None] + CUBE) * size


def vtk_points(points):
    result = vtkPoints()
    result.SetData(numpy_to_vtk(points, deep=True))
    return result


def ghosts(values):
    array = numpy_to_vtk(numpy.asarray(values, numpy.uint8), deep=True)
    array.SetName("vtkGhostType")
    return array


def image(lower=(0, 0, 0), upper=(CELLS,) * 3, size=1.0 / CELLS, kind=vtkImageData):
    data = kind()
    data.SetOrigin([size * i for i in lower])
    data.SetDimensions([b - a + 1 for a, b in zip(lower, upper)])
    data.SetSpacing(size, size, size)
    cells = Cells(cubes(lower, upper, size), "hexahedron")
    add_arrays(data, cells)
    return data, [cells]


def turned_image():
    data, _ = image()
    data.SetDirectionMatrix(0, 0, 1, 1, 0, 0, 0, 1, 0)
    cells = Cells(cubes()[:, :, [2, 0, 1]], "hexahedron")
    add_arrays(data, cells)
    return data, [cells]


def image_with_hole():
    data, (cells,) = image()
    hidden = (numpy.abs(cells.centers - 0.4).max(axis=1) < 0.15)
    data.GetCellData().AddArray(ghosts(hidden * HIDDEN))
    return data, [Cells(cubes()[~hidden], "hexahedron")]


def rectilinear(stretch=1.0):
    coordinates = numpy.linspace(0.0, 1.0, CELLS + 1) ** stretch
    data = vtkRectilinearGrid()
    data.SetDimensions([CELLS + 1] * 3)
    for set_coordinates in (data.SetXCoordinates, data.SetYCoordinates, data.SetZCoordinates):
        set_coordinates(numpy_to_vtk(coordinates, deep=True))
    cells = Cells(cubes() ** stretch, "hexahedron")
    add_arrays(data, cells)
    return data, [cells]


def curvilinear(matrix=numpy.eye(3)):
    data = vtkStructuredGrid()
    data.SetDimensions([CELLS + 1] * 3)
    grid = numpy.stack(numpy.meshgrid(*[numpy.arange(CELLS + 1) / CELLS] * 3, indexing="ij"), axis=-1)
    data.SetPoints(vtk_points(grid.transpose(2, 1, 0, 3).reshape(-1, 3) @ matrix))
    cells = Cells(cubes() @ matrix, "hexahedron")
    add_arrays(data, cells)
    return data, [cells]


def numbered(corners):
    """Points without repetition, and the number of each corner."""
    points, numbers = numpy.unique(corners.reshape(-1, 3).round(12), axis=0, return_inverse=True)
    return points, numbers.reshape(corners.shape[:-1])


def unstructured_of(nodes, cell_type):
    """A grid of cells of one type, without arrays, from the places of each cell's nodes."""
    points, numbers = numbered(nodes)
    offsets = numpy.arange(len(numbers) + 1) * numbers.shape[1]
    array = vtkCellArray()
    array.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(numbers.ravel(), deep=True))
    data = vtkUnstructuredGrid()
    data.SetPoints(vtk_points(points))
    data.SetCells(cell_type, array)
    return data


def unstructured(corners, shape, cell_type, listed=None):
    """`listed`: the corners in the order in which VTK lists them, if it isn't that of `shape`."""
    data = unstructured_of(corners if listed is None else listed, cell_type)
    cells = Cells(corners, shape)
    add_arrays(data, cells)
    return data, [cells]


def hexahedra():
    return unstructured(cubes(), "hexahedron", VTK_HEXAHEDRON)


def permuted_hexahedra():
    return unstructured(numpy.random.default_rng(5).permutation(cubes()), "hexahedron", VTK_HEXAHEDRON)


def voxels():
    return unstructured(cubes(), "hexahedron", VTK_VOXEL, cubes()[:, [0, 1, 3, 2, 4, 5, 7, 6]])


def quadratic_hexahedra():
    corners = cubes()
    middles = numpy.stack([corners[:, edge].mean(axis=1) for edge in numpy.array(EDGES)], axis=1)
    return unstructured(corners, "hexahedron", VTK_QUADRATIC_HEXAHEDRON, numpy.concatenate([corners, middles], axis=1))


def tetrahedra():
    six = [(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)]
    return unstructured(cubes()[:, six].reshape(-1, 4, 3), "tetrahedron", VTK_TETRA)


def wedges():
    two = [(0, 1, 2, 4, 5, 6), (0, 2, 3, 4, 6, 7)]
    return unstructured(cubes()[:, two].reshape(-1, 6, 3), "wedge", VTK_WEDGE)


def pyramids():
    corners = cubes()
    bases = corners[:, [face[::-1] for face in FACES]]
    tips = numpy.broadcast_to(corners.mean(axis=1)[:, None, None], (len(corners), 6, 1, 3))
    return unstructured(numpy.concatenate([bases, tips], axis=2).reshape(-1, 5, 3), "pyramid", VTK_PYRAMID)


def polyhedra():
    points, numbers = numbered(cubes())
    data = vtkUnstructuredGrid()
    data.SetPoints(vtk_points(points))
    for corners in numbers:
        faces = vtkIdList()
        faces.InsertNextId(6)
        for face in FACES:
            for value in (4, *corners[list(face)]):
                faces.InsertNextId(int(value))
        data.InsertNextCell(VTK_POLYHEDRON, faces)
    cells = Cells(cubes(), "hexahedron")
    add_arrays(data, cells)
    return data, [cells]


def explicit_structured():
    points, numbers = numbered(cubes())
    array = vtkCellArray()
    array.SetData(numpy_to_vtkIdTypeArray(numpy.arange(len(numbers) + 1) * 8, deep=True),
                  numpy_to_vtkIdTypeArray(numbers.ravel(), deep=True))
    data = vtkExplicitStructuredGrid()
    data.SetDimensions([CELLS + 1] * 3)
    data.SetPoints(vtk_points(points))
    data.SetCells(array)
    cells = Cells(cubes(), "hexahedron")
    add_arrays(data, cells)
    return data, [cells]


def blocks_with_ghosts():
    """Eight images, each with a layer of its neighbours' cells."""
    data, parts = vtkMultiBlockDataSet(), []
    half = CELLS // 2
    for number, octant in enumerate(itertools.product((0, 1), repeat=3)):
        own = numpy.array([(half * o, half * (o + 1)) for o in octant])
        lower, upper = numpy.maximum(own[:, 0] - 1, 0), numpy.minimum(own[:, 1] + 1, CELLS)
        block, (cells,) = image(lower, upper)
        foreign = ((cells.centers * CELLS < own[:, 0]) | (cells.centers * CELLS > own[:, 1])).any(axis=1)
        block.GetCellData().AddArray(ghosts(foreign * GHOST))
        data.SetBlock(number, block)
        parts.append(Cells(cubes(lower, upper)[~foreign], "hexahedron"))
    return data, parts


def overlapping_amr():
    """Three levels, without marks on the cells that finer ones cover."""
    boxes = [((0, 0, 0), (8, 8, 8)), ((4, 4, 4), (12, 12, 12)), ((12, 12, 12), (20, 20, 20))]
    data, parts = vtkOverlappingAMR(), []
    data.Initialize(3, [1, 1, 1])
    data.SetOrigin([0.0, 0.0, 0.0])
    data.SetGridDescription(8)  # VTK_XYZ_GRID
    for level, (lower, upper) in enumerate(boxes):
        size = 1.0 / (CELLS << level)
        block, (cells,) = image(lower, upper, size, vtkUniformGrid)
        data.SetSpacing(level, [size] * 3)
        data.SetAMRBox(level, 0, vtkAMRBox(list(lower), [i - 1 for i in upper]))
        data.SetDataSet(level, 0, block)
        finer = numpy.array(boxes[level + 1]) / (CELLS << (level + 1)) if level < 2 else numpy.zeros((2, 3))
        covered = ((cells.centers > finer[0]) & (cells.centers < finer[1])).all(axis=1)
        parts.append(Cells(cubes(lower, upper, size)[~covered], "hexahedron"))
    return data, parts


def hyper_trees(masked=False):
    """4 x 4 x 4 trees, split twice along the lower border; with `masked`, the leaves near a corner are no part."""
    data = vtkHyperTreeGrid()
    data.SetDimensions([5, 5, 5])
    data.SetBranchFactor(2)
    for set_coordinates in (data.SetXCoordinates, data.SetYCoordinates, data.SetZCoordinates):
        set_coordinates(numpy_to_vtk(numpy.linspace(0.0, 1.0, 5), deep=True))
    cursor, nodes, leaves = vtkHyperTreeGridNonOrientedGeometryCursor(), [], []

    def visit(level):
        bounds = [0.0] * 6
        cursor.GetBounds(bounds)
        box = numpy.array(bounds).reshape(3, 2)
        corners = box[:, 0] + CUBE * (box[:, 1] - box[:, 0])
        number = cursor.GetGlobalNodeIndex()
        nodes.append((number, corners))
        if level < 1 or (level < 3 and numpy.ptp(numpy.sign(corners @ NORMAL - LEVELS[0])) > 0):
            cursor.SubdivideLeaf()
            for child in range(8):
                cursor.ToChild(child)
                visit(level + 1)
                cursor.ToParent()
        else:
            leaves.append((number, corners))

    start = 0
    for tree in range(64):
        cursor.Initialize(data, tree, True)
        cursor.SetGlobalIndexStart(start)
        visit(0)
        start += cursor.GetTree().GetNumberOfVertices()
    nodes.sort(key=lambda node: node[0])
    add_arrays(data, Cells(numpy.stack([corners for _, corners in nodes]), "hexahedron"))
    if masked:
        mask = vtkBitArray()
        mask.SetNumberOfTuples(start)
        for number, corners in nodes:
            mask.SetValue(number, int(corners.min() >= 0.5 and numpy.ptp(corners, axis=0).max() < 0.2))
        data.SetMask(mask)
        leaves = [leaf for leaf in leaves if leaf[1].min() < 0.5]
    return data, [Cells(numpy.stack([corners for _, corners in leaves]), "hexahedron")]
