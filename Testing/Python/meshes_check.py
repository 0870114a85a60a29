"""The same analytic problem in every kind of grid: bounds, volumes and materials against what is known exactly."""
import sys

import check_mesh
import meshes_curved as curved
import meshes_grids as grids
import numpy
import strata
from meshes_problem import LEVELS, NAMES, NORMAL, densities, joined, materials, random_points
from vtkmodules.util.numpy_support import vtk_to_numpy

INTERFACE_BOUND, DENSITY_BOUND = 0.01, 0.05
CERTIFIED_INTERFACE_BOUND, CERTIFIED_DENSITY_BOUND = 0.03, 0.1
POINTS_IN_CELL = 20
MINIMUM_VOLUME_FRACTION = 0.1
# The interfaces that stand for a plane deviate from it by this many cells at most.
RECONSTRUCTION = 0.15
ROUNDING = 1e-6  # of floats
# Kinds of grid in which the cells are those of the image.
SAME = ("rectilinear", "curvilinear", "hexahedra", "permuted hexahedra", "voxels", "quadratic hexahedra",
        "explicit structured", "blocks with ghosts")
BOXES = {
    "image": grids.image,
    "rectilinear": grids.rectilinear,
    "curvilinear": grids.curvilinear,
    "hexahedra": grids.hexahedra,
    "stretched": lambda: grids.rectilinear(1.3),
    "turned image": grids.turned_image,
    "permuted hexahedra": grids.permuted_hexahedra,
    "voxels": grids.voxels,
    "quadratic hexahedra": grids.quadratic_hexahedra,
    "tetrahedra": grids.tetrahedra,
    "wedges": grids.wedges,
    "pyramids": grids.pyramids,
    "polyhedra": grids.polyhedra,
    "explicit structured": grids.explicit_structured,
    "blocks with ghosts": grids.blocks_with_ghosts,
    "overlapping AMR": grids.overlapping_amr,
    "hyper trees": grids.hyper_trees,
}
CURVED = {
    "curved quadratic hexahedra": curved.quadratic_hexahedra,
    "curved triquadratic hexahedra": curved.triquadratic_hexahedra,
    "curved quadratic tetrahedra": curved.tetrahedra,
    "curved quadratic wedges": curved.wedges,
    "curved quadratic pyramids": curved.pyramids,
    "Lagrange hexahedra of degree 3": curved.lagrange_hexahedra,
    "Lagrange tetrahedra": curved.lagrange_tetrahedra,
    "Lagrange wedges": curved.lagrange_wedges,
}
OTHERS = {
    "sheared": lambda: grids.curvilinear(grids.SHEAR),
    "left-handed": lambda: grids.curvilinear(grids.SHEAR * [1.0, 1.0, -1.0]),
    "hidden cells": grids.image_with_hole,
    "masked hyper trees": lambda: grids.hyper_trees(True),
}


def run(algorithm, data, port=0):
    algorithm.SetInputDataObject(port, data)
    algorithm.Update()
    return algorithm.GetOutputDataObject(0)


def refined(data, interface_bound=INTERFACE_BOUND, density_bound=DENSITY_BOUND, certified=False):
    filter_ = strata.vtkStrataTetrahedra()
    filter_.SetInterfaceErrorBound(interface_bound)
    filter_.AddFieldArray("density")
    filter_.AddAbsoluteFieldErrorBound("density", density_bound)
    filter_.SetNativeElements(int(certified))
    result = run(filter_, data)
    return result, filter_.GetBoundMet()


def surfaces_of(data):
    """(positive, negative, vertices, nothing) of each interface that Strata finds."""
    collection = run(strata.vtkStrataMaterialInterfaces(), data)
    result = []
    for block in range(collection.GetNumberOfPartitionedDataSets()):
        surface = collection.GetPartition(block, 0)
        if surface.GetNumberOfCells():
            sides = [surface.GetCellData().GetArray(side + "_material").GetValue(0) for side in ("positive", "negative")]
            result.append((*sides, vtk_to_numpy(surface.GetPoints().GetData()).astype(float), None))
    return result


def check_surfaces(surfaces, cell_size):
    """The interfaces between layers lie on their planes."""
    faults = []
    for positive, negative, vertices, *_ in surfaces:
        low, high = sorted((positive, negative))
        if high < len(NAMES):
            if high != low + 1:
                faults.append(f"interfaces: {NAMES[low]} touches {NAMES[high]}")
            off = numpy.abs(vertices @ NORMAL - LEVELS[low]).max()
            if off > RECONSTRUCTION * cell_size:
                faults.append(f"interfaces: {off / cell_size:.3g} cells off the plane {low}")
    return faults


def piece_volumes(representation):
    """Volume of each material's solid pieces."""
    filter_ = strata.vtkStrataExtractMaterials()
    for name in filter_names(representation):
        filter_.AddMaterial(name)
    pieces = run(filter_, representation)
    corners = vtk_to_numpy(pieces.GetPoints().GetData()).astype(float)
    corners = corners[vtk_to_numpy(pieces.GetCells().GetConnectivityArray())].reshape(-1, 4, 3)
    volumes = numpy.abs(numpy.linalg.det(corners[:, 1:] - corners[:, :1])) / 6.0
    return numpy.bincount(vtk_to_numpy(pieces.GetCellData().GetArray("material")), volumes,
                          len(filter_names(representation)))


def filter_names(grid):
    names = grid.GetFieldData().GetAbstractArray("material_names")
    return [names.GetValue(m) for m in range(names.GetNumberOfValues())]


def check_volumes(grid, parts):
    _, volumes, fractions, _ = joined(parts)
    expected = fractions @ volumes
    found = piece_volumes(grid)
    # A layer of the interface's bound, on each of the planes (areas up to 1.5).
    tolerance = 0.5 * INTERFACE_BOUND
    faults = [f"volumes: {name} has {found[m]:.6g}, not {expected[m]:.6g}"
              for m, name in enumerate(NAMES) if abs(found[m] - expected[m]) > tolerance]
    lower, upper = (numpy.array(grid.GetBounds())[side::2] for side in (0, 1))
    outside = (upper - lower).prod() - expected.sum()
    if len(found) > len(NAMES) and abs(found[len(NAMES)] - outside) > 4.0 * tolerance:
        faults.append(f"volumes: outside has {found[len(NAMES)]:.6g}, not {outside:.6g}")
    return faults


def clear_of_planes(points, volumes, interface_bound):
    """Points farther from the planes than the bound and what an interface from fractions is off by."""
    distance = numpy.abs((points @ NORMAL)[:, None] - numpy.array(LEVELS)).min(axis=1)
    # Outside's interface comes within its bound of a cell's face, never as far as its center.
    return points[distance > interface_bound + RECONSTRUCTION * volumes ** (1 / 3)]


def check_truth(representation, points, density_bound):
    """Material and density at points that lie clear of the planes are those of the problem."""
    cells, members, weights = check_mesh.locate(representation, points)
    corners = representation.cells[cells]
    distances = numpy.stack([check_mesh.interpolate(
        numpy.nan_to_num(d[corners], nan=1e9), weights) for d in representation.distances.values()])
    found = distances.argmin(axis=0)
    true = materials(points)[members]
    faults = []
    if (found != true).any():
        faults.append(f"truth: {(found != true).sum()} of {len(found)} points lie in the wrong material")
    exact = densities(points)[true, members]
    represented = numpy.select([true == m for m in representation.values],
                               [check_mesh.interpolate(v[corners], weights) for v in representation.values.values()])
    error = numpy.abs(represented - exact).max()
    if not error <= density_bound * 1.0001:
        faults.append(f"truth: density is off by {error:.4g}")
    return faults


def check_certified(data, parts):
    """Between the centers of the cells, too, where bounds over whole native cells hold."""
    grid, met = refined(data, CERTIFIED_INTERFACE_BOUND, CERTIFIED_DENSITY_BOUND, True)
    points, volumes = random_points(parts, POINTS_IN_CELL)
    size = volumes.max() ** (1 / 3)
    within = (points > 0.5 * size).all(axis=1) & (points < 1.0 - 0.5 * size).all(axis=1)
    points = clear_of_planes(points[within], volumes[within], CERTIFIED_INTERFACE_BOUND)
    # A function of the third density read linearly between samples that are `size` apart: off by size^2 / 4.
    faults = check_truth(check_mesh.Representation(grid, "density"), points, CERTIFIED_DENSITY_BOUND + 0.25 * size ** 2)
    return [f"certified {fault}" for fault in faults + ([] if met else ["bounds are not met"])]


def check(name, build, is_box):
    data, parts = build()
    grid, met = refined(data)
    faults = [] if met else ["bounds are not met"]
    centers, volumes, fractions, values = joined(parts)
    if filter_names(grid) != list(NAMES) + ([] if is_box else ["outside"]):
        faults.append(f"materials are {filter_names(grid)}")
    if grid.GetNumberOfCells() == 0:
        return ["no output"], grid
    corners = numpy.concatenate([part.corners.reshape(-1, 3) for part in parts])
    representation = check_mesh.Representation(grid, "density")
    counts = (fractions >= MINIMUM_VOLUME_FRACTION) | (fractions.argmax(axis=0) == numpy.arange(3)[:, None])
    native = {m: (values[m], counts[m]) for m in range(len(NAMES))}
    surfaces = surfaces_of(data)
    faults += check_mesh.check_mesh(representation, corners.min(axis=0), corners.max(axis=0))
    if not parts[0].at_nodes:
        faults += check_mesh.check_field(representation, centers, native, DENSITY_BOUND)
    faults += check_mesh.check_interfaces(representation, surfaces, INTERFACE_BOUND)
    faults += check_surfaces(surfaces, volumes.max() ** (1 / 3))
    faults += check_volumes(grid, parts)
    faults += check_truth(representation, clear_of_planes(centers, volumes, INTERFACE_BOUND), DENSITY_BOUND)
    faults += check_certified(data, parts) if is_box else []
    print(f"{name}: {len(volumes)} cells in, {grid.GetNumberOfCells()} tetrahedra out")
    return [f"{name}: {fault}" for fault in faults], grid


def arrays_of(grid):
    """Everything that the representation says at its points and of its cells, by name."""
    result = {"points": vtk_to_numpy(grid.GetPoints().GetData()),
              "corners": vtk_to_numpy(grid.GetCells().GetConnectivityArray())}
    for data in (grid.GetPointData(), grid.GetCellData()):
        for i in range(data.GetNumberOfArrays()):
            result[data.GetArrayName(i)] = vtk_to_numpy(data.GetArray(i))
    return result


def check_agreement(outputs):
    """The same cells, whatever the kind of grid and the order in which they come: the same representation."""
    faults = []
    reference = arrays_of(outputs["image"])
    for name in SAME:
        for array, values in arrays_of(outputs[name]).items():
            expected = reference[array]
            if values.shape != expected.shape or not numpy.allclose(values, expected, ROUNDING, ROUNDING, True):
                faults.append(f"agreement: {array} of {name} is not that of the image")
    return faults


def main():
    faults, outputs = [], {}
    for is_box, group in ((True, BOXES), (True, CURVED), (False, OTHERS)):
        for name, build in group.items():
            found, outputs[name] = check(name, build, is_box)
            faults += found
    faults += check_agreement(outputs)
    for fault in faults:
        print("FAULT", fault)
    sys.exit(bool(faults))


main()
