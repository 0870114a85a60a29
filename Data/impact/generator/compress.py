"""Rewrites .vtr files inline, compressed by zlib, and checks that no value changed: compress.py FOLDER FILE...

Inline, not appended: with Debian 12's libexpat, ParaView 5.11 reads no appended data, not even its own.
"""
import os
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLRectilinearGridReader, vtkXMLRectilinearGridWriter


def read(name):
    reader = vtkXMLRectilinearGridReader()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()


def write(grid, name):
    writer = vtkXMLRectilinearGridWriter()
    writer.SetInputData(grid)
    writer.SetFileName(name)
    writer.SetDataModeToBinary()
    writer.SetHeaderTypeToUInt64()
    writer.SetByteOrderToLittleEndian()
    writer.SetCompressorTypeToZLib()
    writer.SetCompressionLevel(9)
    writer.SetBlockSize(1 << 20)
    writer.Write()


def arrays(grid):
    data = grid.GetCellData()
    return {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}


def main(folder, names):
    for name in names:
        compressed = os.path.join(folder, os.path.basename(name))
        grid = read(name)
        write(grid, compressed)
        before, after = arrays(grid), arrays(read(compressed))
        for array in before:
            if not numpy.array_equal(before[array], after[array]):
                sys.exit(f"{compressed}: {array} changed")
        print(f"{compressed}: {os.path.getsize(name)} -> {os.path.getsize(compressed)} bytes")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
