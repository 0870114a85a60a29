"""Turns a grid of Data/impact into the plain file that the benchmarks of the core read (which knows no VTK):

    pvpython export_grid.py impact_32_04.vtr impact_32_04.raw

Layout, all little endian: three int64, the numbers of points along x, y, z; the coordinates along each axis,
float64; then float32 arrays with one value per cell, x running fastest: the arrays named below, in that order.
"""
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLRectilinearGridReader

ARRAYS = ("volume_fraction_projectile", "volume_fraction_block", "volume_fraction_empty",
          "density_projectile", "density_block")


def main(source, target):
    reader = vtkXMLRectilinearGridReader()
    reader.SetFileName(source)
    reader.Update()
    grid = reader.GetOutput()
    axes = [vtk_to_numpy(axis) for axis in (grid.GetXCoordinates(), grid.GetYCoordinates(), grid.GetZCoordinates())]
    arrays = [vtk_to_numpy(grid.GetCellData().GetArray(name)) for name in ARRAYS]
    with open(target, "wb") as file:
        numpy.array([len(axis) for axis in axes], dtype="<i8").tofile(file)
        for axis in axes:
            axis.astype("<f8").tofile(file)
        for array in arrays:
            array.astype("<f4").tofile(file)


if __name__ == "__main__":
    main(*sys.argv[1:])
