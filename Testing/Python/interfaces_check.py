"""Interfaces do not depend on the kind of grid, on the order of the cells, nor on the order of the materials."""
import sys

import meshes_grids as grids
import numpy
import strata
from meshes_problem import NAMES, add_values
from vtkmodules.util.numpy_support import vtk_to_numpy

ROUNDING = 1e-6  # of floats, in a unit cube


def surfaces_of(data, names=NAMES):
    """The triangles between two materials, corners in the order in which they are seen from the first: by names."""
    filter_ = strata.vtkStrataMaterialInterfaces()
    for name in names:
        filter_.AddVolumeFractionArray("volume_fraction_" + name)
    filter_.SetInputDataObject(data)
    filter_.Update()
    collection, result = filter_.GetOutputDataObject(0), {}
    for block in range(collection.GetNumberOfPartitionedDataSets()):
        surface = collection.GetPartition(block, 0)
        if surface.GetNumberOfCells():
            sides = [(*names, "outside")[surface.GetCellData().GetArray(side + "_material").GetValue(0)]
                     for side in ("positive", "negative")]
            corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
            turned = sides != sorted(sides)
            triangles = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)[corners]
            result[tuple(sorted(sides))] = triangles[:, ::-1] if turned else triangles
    return result


def farthest(corners, others):
    """How far the corners of triangles are from the nearest corner of others."""
    corners, others = (numpy.unique(c.reshape(-1, 3).round(9), axis=0) for c in (corners, others))
    return max(((others - corner) ** 2).sum(axis=1).min() for corner in corners) ** 0.5


def vector_area(triangles):
    return numpy.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]).sum(axis=0) / 2.0


def differences(name, surfaces, expected):
    if set(surfaces) != set(expected):
        return [f"{name}: interfaces {sorted(surfaces)}, not {sorted(expected)}"]
    faults = []
    for pair, triangles in surfaces.items():
        if len(triangles) != len(expected[pair]):
            faults.append(f"{name}: {len(triangles)} triangles between {pair}, not {len(expected[pair])}")
            continue
        off = max(farthest(triangles, expected[pair]), farthest(expected[pair], triangles))
        # Polygons between the same corners may be cut into other triangles: the area, with its direction, is the same.
        turned = numpy.abs(vector_area(triangles) - vector_area(expected[pair])).max()
        if not max(off, turned) <= ROUNDING:
            faults.append(f"{name}: the interface between {pair} is off by {off:.3g}, its area by {turned:.3g}")
    return faults


def junction(build):
    """Three materials that meet along a line, the wedges between half planes, instead of the layers."""
    data, (cells,) = build()
    steps = (numpy.arange(6) + 0.5) / 6.0
    inner = numpy.stack(numpy.meshgrid(steps, steps, steps, indexing="ij"), axis=-1).reshape(-1, 3)
    lower, upper = cells.corners.min(axis=1), cells.corners.max(axis=1)
    points = lower[:, None] + inner * (upper - lower)[:, None]
    angle = numpy.arctan2(points[..., 1] - 0.53, points[..., 0] - 0.47 + 0.1 * points[..., 2])
    third = ((angle / (2.0 * numpy.pi) + 0.55) * 3.0).astype(int) % 3
    for m, name in enumerate(NAMES):
        add_values(data.GetCellData(), "volume_fraction_" + name, (third == m).mean(axis=1))
    return data


def main():
    faults = []
    for label, read in (("layers", lambda build: build()[0]), ("junction", junction)):
        image = read(grids.image)
        expected = surfaces_of(image)
        for build in (grids.rectilinear, grids.curvilinear, grids.hexahedra, grids.permuted_hexahedra):
            faults += differences(f"{label} {build.__name__}", surfaces_of(read(build)), expected)
        for order in ((2, 1, 0), (1, 2, 0)):
            names = [NAMES[m] for m in order]
            faults += differences(f"{label} in the order {names}", surfaces_of(image, names), expected)
        print(label, {pair: len(triangles) for pair, triangles in expected.items()})
    sheared = surfaces_of(grids.curvilinear(grids.SHEAR)[0])
    listed = grids.unstructured(grids.cubes() @ grids.SHEAR, "hexahedron", grids.VTK_HEXAHEDRON)[0]
    faults += differences("sheared hexahedra", surfaces_of(listed), sheared)
    for fault in faults:
        print("FAULT", fault)
    sys.exit(bool(faults))


main()
