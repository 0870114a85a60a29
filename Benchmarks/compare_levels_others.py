"""What ParaView offers instead of levels: cutters, decimation and resampling, measured on the same data.

Debian's VTK is compiled without optimization. With the library of make-optimized-filters loaded first, the plane cutters and
the decimation are optimized; resampling and Cutter stay as packaged.
"""
import math
import os
from pathlib import Path

from compare_levels_time import Duration, median
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPlane
from vtkmodules.vtkFiltersCore import (
    vtk3DLinearGridPlaneCutter,
    vtkCellDataToPointData,
    vtkCutter,
    vtkPlaneCutter,
    vtkUnstructuredGridQuadricDecimation,
)

# Quadric decimation takes time in proportion to a high power of the cells: larger meshes are left out.
MOST_CELLS_TO_DECIMATE = 60000
# More points take Resample To Image, unoptimized, more than ten seconds.
MOST_POINTS_TO_RESAMPLE = 1500000
HYPER_TREE_PLUGIN = "paraview-*/plugins/HyperTreeGridADR/HyperTreeGridADR.so"


def optimized():
    return "OptimizedFilters" in os.environ.get("LD_PRELOAD", "")


def load_hyper_trees():
    """Loads ParaView's plugin with Resample To Hyper Tree Grid; false where it isn't found."""
    if not hasattr(simple, "ResampleToHyperTreeGrid"):
        libraries = Path(simple.__file__).parents[3]
        found = [*libraries.glob(HYPER_TREE_PLUGIN), *libraries.glob(f"*-linux-gnu/{HYPER_TREE_PLUGIN}")]
        named = os.environ.get("STRATA_HYPER_TREE_PLUGIN")
        for library in [named] if named else found[:1]:
            simple.LoadPlugin(str(library), ns=vars(simple))
    return hasattr(simple, "ResampleToHyperTreeGrid")


def cutters(mesh, normal, places):
    """Dragging a plane through a mesh with each of VTK's cutters."""
    result = {}
    for cutter_class in (vtkPlaneCutter, vtk3DLinearGridPlaneCutter, vtkCutter):
        plane = vtkPlane()
        plane.SetNormal(normal)
        cutter = cutter_class()
        cutter.SetInputData(mesh)
        (cutter.SetCutFunction if cutter_class is vtkCutter else cutter.SetPlane)(plane)

        def move(moved=plane):
            moved.SetOrigin(next(places))

        move()
        cutter.Update()
        result[cutter_class.__name__] = median(cutter.Update, before=move)
    return result


def decimation(mesh, field):
    """To half the tetrahedra; None for meshes that would take it minutes."""
    if mesh.GetNumberOfCells() > MOST_CELLS_TO_DECIMATE:
        return None
    filter_ = vtkUnstructuredGridQuadricDecimation()
    filter_.SetInputData(mesh)
    filter_.SetScalarsName(field)
    filter_.SetTargetReduction(0.5)
    return Duration.of(filter_.Update)


def image(source, mesh):
    """Resample To Image with as many points as the mesh has cells; None for too many."""
    if mesh.GetNumberOfCells() > MOST_POINTS_TO_RESAMPLE:
        return None
    size = max(2, round(mesh.GetNumberOfCells() ** (1.0 / 3.0)))
    resampled = simple.ResampleToImage(Input=source)
    resampled.SamplingDimensions = [size, size, size]
    result = Duration.of(resampled.UpdatePipeline)
    simple.Delete(resampled)
    return result


def hyper_tree(source, field, bound):
    """Resample To Hyper Tree Grid, down to the native cells where the field deviates by more than half its bound: duration
    and leaves. It takes data at points alone, which averages of the cells' make (not timed)."""
    to_points = vtkCellDataToPointData()
    to_points.SetInputData(source.GetClientSideObject().GetOutputDataObject(0))
    to_points.Update()
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, to_points.GetOutput())
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(blocks)
    producer.UpdatePipeline()
    tree = simple.ResampleToHyperTreeGrid(Input=producer)
    tree.SubdividingCriterion = "Standard Deviation"
    tree.SubdividingCriterionArray = ["POINTS", field]
    tree.Dimensions = [3, 3, 3]
    tree.MaxDepth = round(math.log2(to_points.GetOutput().GetNumberOfCells()) / 3.0)
    tree.Min = 0.5 * bound
    tree.Max = 1e300
    result = Duration.of(tree.UpdatePipeline)
    leaves = tree.GetClientSideObject().GetOutputDataObject(0).GetNumberOfLeaves()
    simple.Delete(tree)
    simple.Delete(producer)
    return result, leaves
