"""A synthetic grid: three materials that meet in a line along y, with volume fractions from 8 x 8 points per cell."""
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

CENTRE = (0.52, 0.47)
POINTS_PER_AXIS = 8


def materials_at(x, z):
    """0 below the line through the centre; above it, 1 left and 2 right of a slanted line."""
    dx, dz = x - CENTRE[0], z - CENTRE[1]
    return numpy.where(dz < 0.25 * dx, 0, numpy.where(dx + 0.3 * dz < 0.0, 1, 2))


def fractions(cells):
    """Arrays [z][x] of each material's share of the cell."""
    inside = (numpy.arange(cells * POINTS_PER_AXIS) + 0.5) / (cells * POINTS_PER_AXIS)
    x, z = numpy.meshgrid(inside, inside)
    found = materials_at(x, z)
    return [(found == m).reshape(cells, POINTS_PER_AXIS, cells, POINTS_PER_AXIS).mean(axis=(1, 3)) for m in range(3)]


def junction_grid(cells):
    """A proxy with the grid of cells^3 cells on the unit cube."""
    grid = vtkImageData()
    grid.SetDimensions(cells + 1, cells + 1, cells + 1)
    grid.SetSpacing(1.0 / cells, 1.0 / cells, 1.0 / cells)
    shares = fractions(cells)
    for name, share in zip(("below", "left", "right"), shares):
        values = numpy.repeat(share[:, numpy.newaxis, :], cells, axis=1)
        array = numpy_to_vtk(values.ravel(), deep=True)
        array.SetName("volume_fraction_" + name)
        grid.GetCellData().AddArray(array)
    density = numpy_to_vtk(numpy.repeat((4 * shares[0] + 2 * shares[1] + shares[2])[:, numpy.newaxis, :], cells,
                                        axis=1).ravel(), deep=True)
    density.SetName("density")
    grid.GetCellData().AddArray(density)
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(grid)
    producer.UpdatePipeline()
    return producer
