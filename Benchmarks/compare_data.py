"""The cases of compare_interfaces.py: rectilinear grids with fractions of every material in cells."""
from pathlib import Path

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkPlane, vtkRectilinearGrid
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter, vtkTableBasedClipDataSet
from vtkmodules.vtkIOXML import vtkXMLRectilinearGridReader

# Title, file, prefix of the fractions' arrays (or their names).
FILES = (("impact, 32", "impact/impact_32_04.vtr", "volume_fraction_"),
         ("impact, 64", "impact/impact_64_04.vtr", "volume_fraction_"),
         ("impact, 128", "impact/impact_128_04.vtr", "volume_fraction_"),
         ("CTH rod and plate", "cth/cth.vtr", "Volume Fraction"),
         ("four-phase dam break", "openfoam/damBreak4phase_t0.30.vtr", "alpha."))
HIDDEN = 32
PRESENT = 1e-6  # fraction from which on a material is in a cell


class Case:
    """A rectilinear grid and its fractions as [material][x, y, z], with `hidden` cells."""

    def __init__(self, title, axes, names, fractions, hidden=None):
        self.title, self.axes, self.names, self.fractions = title, axes, names, fractions
        self.hidden = numpy.zeros(fractions[0].shape, dtype=bool) if hidden is None else hidden
        self.grid = rectilinear_grid(axes)
        for name, values in zip(names, fractions):
            add_array(self.grid, name, values.astype(numpy.float32))
        if self.hidden.any():
            add_array(self.grid, vtkDataSetAttributes.GhostArrayName(), (self.hidden * HIDDEN).astype(numpy.uint8))

    def mixed(self):
        """Whether a cell holds several materials, [x, y, z]."""
        present = sum((fraction > PRESENT).astype(int) for fraction in self.fractions)
        return (present > 1) & ~self.hidden


def rectilinear_grid(axes):
    grid = vtkRectilinearGrid()
    grid.SetDimensions(*[len(axis) for axis in axes])
    for set_axis, axis in zip((grid.SetXCoordinates, grid.SetYCoordinates, grid.SetZCoordinates), axes):
        set_axis(numpy_to_vtk(numpy.asarray(axis, dtype=float), deep=1))
    return grid


def add_array(grid, name, values):
    """Adds an array [x, y, z] to the cells."""
    array = numpy_to_vtk(values.ravel(order="F"), deep=1)
    array.SetName(name)
    grid.GetCellData().AddArray(array)


def read(title, path, marker):
    reader = vtkXMLRectilinearGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    axes = [vtk_to_numpy(axis).astype(float)
            for axis in (grid.GetXCoordinates(), grid.GetYCoordinates(), grid.GetZCoordinates())]
    shape = [len(axis) - 1 for axis in axes]
    cells = grid.GetCellData()
    names = [cells.GetArrayName(i) for i in range(cells.GetNumberOfArrays())]

    def array(name):
        return vtk_to_numpy(cells.GetArray(name)).reshape(shape, order="F")

    ghosts = vtkDataSetAttributes.GhostArrayName()
    hidden = (array(ghosts) & HIDDEN) != 0 if ghosts in names else None
    names = [name for name in names if marker in name]
    fractions = numpy.clip([array(name).astype(float) for name in names], 0.0, 1.0)
    sums = fractions.sum(axis=0)
    return Case(title, axes, names, fractions / numpy.where(sums > 0.0, sums, 1.0), hidden)


def disc_in_rectangles(x0, x1, y0, y1, radius):
    """The area that rectangles share with a disc about the origin."""
    def below_corner(x, y):  # of the disc's part with coordinates below x, y
        x, y = numpy.clip(x, -radius, radius), numpy.clip(y, -radius, radius)
        edge = numpy.sqrt(numpy.maximum(radius ** 2 - y ** 2, 0.0))

        def strip(a, b):  # from x = a to b, y from -edge(x) to its middle 0
            f = [0.5 * (t * numpy.sqrt(numpy.maximum(radius ** 2 - t ** 2, 0.0))
                        + radius ** 2 * numpy.arcsin(numpy.clip(t / radius, -1.0, 1.0))) for t in (a, b)]
            return f[1] - f[0]

        left, right = numpy.minimum(-edge, x), numpy.minimum(edge, x)
        half = strip(numpy.full_like(x, -radius), x)
        outer = strip(numpy.full_like(x, -radius), left) + strip(right, x)
        inner = y * (right - left)
        return half + numpy.where(y >= 0.0, outer + inner, inner - outer)

    return below_corner(x1, y1) - below_corner(x0, y1) - below_corner(x1, y0) + below_corner(x0, y0)


def sphere(count, center, radius):
    """Fractions of a sphere in the unit cube: discs, summed along z by Gauss' rule."""
    axis = numpy.linspace(0.0, 1.0, count + 1)
    x0, y0 = numpy.meshgrid(axis[:-1] - center[0], axis[:-1] - center[1], indexing="ij")
    nodes, weights = numpy.polynomial.legendre.leggauss(16)
    parts = 8
    sums = numpy.zeros((count, count, count))
    for k in range(count):
        for part in range(parts):
            for node, weight in zip(nodes, weights):
                z = axis[k] + (part + 0.5 * (1.0 + node)) / (parts * count) - center[2]
                if abs(z) < radius:
                    area = disc_in_rectangles(x0, x0 + 1.0 / count, y0, y0 + 1.0 / count,
                                              numpy.sqrt(radius ** 2 - z ** 2))
                    sums[:, :, k] += 0.5 * weight / parts * area * count ** 2
    sums = numpy.clip(sums, 0.0, 1.0)
    return Case(f"sphere, {count}", [axis] * 3, ["ball", "rest"], [sums, 1.0 - sums])


def half_planes(count):
    """Three materials between three half planes that meet in a slanted line: cells clipped by planes."""
    axis = numpy.linspace(0.0, 1.0, count + 1)
    line = numpy.array([0.21, 0.34, 1.0]) / numpy.linalg.norm([0.21, 0.34, 1.0])
    u = numpy.cross(line, [1.0, 0.0, 0.0])
    u /= numpy.linalg.norm(u)
    v = numpy.cross(line, u)
    normals = [numpy.cos(a) * u + numpy.sin(a) * v for a in (0.3, 0.3 + 2.0, 0.3 + 4.3)]
    grid = rectilinear_grid([axis] * 3)
    add_array(grid, "cell", numpy.arange(count ** 3).reshape((count,) * 3, order="F"))
    split = vtkDataSetTriangleFilter()
    split.SetInputData(grid)
    split.Update()
    fractions = [sector_volumes(split.GetOutput(), normals[m], -normals[(m + 1) % 3], count) for m in range(3)]
    return Case(f"three half planes, {count}", [axis] * 3, ["a", "b", "c"], [f * count ** 3 for f in fractions])


def sector_volumes(tetrahedra, first, second, count):
    """Volume by cell of the part of tetrahedra on the positive sides of two planes through the middle."""
    for normal in (first, second):
        plane = vtkPlane()
        plane.SetOrigin(0.512, 0.487, 0.5)
        plane.SetNormal(*normal)
        clip = vtkTableBasedClipDataSet()
        clip.SetInputData(tetrahedra)
        clip.SetClipFunction(plane)
        clip.SetOutputPointsPrecision(1)
        clip.Update()
        split = vtkDataSetTriangleFilter()
        split.SetInputData(clip.GetOutput())
        split.Update()
        tetrahedra = split.GetOutput()
    points = vtk_to_numpy(tetrahedra.GetPoints().GetData()).astype(float)
    corners = points[vtk_to_numpy(tetrahedra.GetCells().GetConnectivityArray()).reshape(-1, 4)]
    volumes = numpy.abs(numpy.linalg.det(corners[:, 1:] - corners[:, :1])) / 6.0
    cells = vtk_to_numpy(tetrahedra.GetCellData().GetArray("cell"))
    return numpy.bincount(cells, volumes, count ** 3).reshape((count,) * 3, order="F")


def cases(folder):
    """The generated cases, then those whose files are in the folder."""
    yield sphere(32, (0.513, 0.498, 0.487), 0.3)
    yield half_planes(32)
    for title, path, marker in FILES:
        if (Path(folder) / path).exists():
            yield read(title, Path(folder) / path, marker)
