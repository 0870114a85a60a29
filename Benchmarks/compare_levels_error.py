"""Cells at equal true L-infinity error on analytic fields: tetrahedra with and without materials beside octrees.

The field with a jump is 1 + 0.1 x inside a ball and 0.1 y outside, and the field without is a product of sines. No mesh can
be right at the jump itself: the error is the largest at points farther from it than LAYER, the same for all methods.
"""
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersHyperTree import vtkHyperTreeGridToUnstructuredGrid

CENTER = numpy.array([0.52, 0.51, 0.49])
RADIUS = 0.3
NATIVE_CELLS = 128
# The diagonal of a native cell: nearer, samples of the grid alone tell nothing.
LAYER = 3.0**0.5 / NATIVE_CELLS
SAMPLES = 400000
ERROR = 0.05


def depth_of(points):
    """How far a point lies inside the ball."""
    return RADIUS - numpy.linalg.norm(points - CENTER, axis=-1)


def inside(points):
    return 1.0 + 0.1 * points[..., 0]


def outside(points):
    return 0.1 * points[..., 1]


def jumping(points):
    return numpy.where(depth_of(points) > 0.0, inside(points), outside(points))


def smooth(points):
    return numpy.prod(numpy.sin(numpy.pi * (points + 0.1)), axis=-1)


def grid(field, cells=NATIVE_CELLS):
    """The unit cube with the field at the points and at the centres of the cells, and the ball's volume fractions."""
    image = vtkImageData()
    image.SetDimensions(cells + 1, cells + 1, cells + 1)
    image.SetSpacing(1.0 / cells, 1.0 / cells, 1.0 / cells)

    def places(at):
        z, y, x = numpy.meshgrid(at, at, at, indexing="ij")
        return numpy.stack([x.ravel(), y.ravel(), z.ravel()], axis=-1)

    def add(data, name, values):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        data.AddArray(array)

    corners = places(numpy.arange(cells + 1) / cells)
    centers = places((numpy.arange(cells) + 0.5) / cells)
    # A plane cuts a small cube; along its normal the fraction is linear but for the ends.
    normals = numpy.abs(centers - CENTER) / numpy.linalg.norm(centers - CENTER, axis=-1)[:, None]
    fractions = numpy.clip(0.5 + depth_of(centers) * cells / numpy.sum(normals, axis=-1), 0.0, 1.0)
    add(image.GetPointData(), "f", field(corners))
    add(image.GetCellData(), "f", field(centers))
    add(image.GetCellData(), "f_ball", inside(centers))
    add(image.GetCellData(), "f_rest", outside(centers))
    add(image.GetCellData(), "volume_fraction_ball", fractions)
    add(image.GetCellData(), "volume_fraction_rest", 1.0 - fractions)
    add(image.GetCellData(), "all", numpy.ones(len(centers), dtype=numpy.int32))
    return image


def producer(data):
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    source.UpdatePipeline()
    return source


def sample_points(jump):
    points = numpy.random.default_rng(1).random((SAMPLES, 3))
    return points[numpy.abs(depth_of(points)) > LAYER] if jump else points


def strata_error(mesh, name, field, points):
    cloud = vtkPolyData()
    positions = vtkPoints()
    positions.SetDataTypeToDouble()
    positions.SetData(numpy_to_vtk(points, deep=True))
    cloud.SetPoints(positions)
    target = producer(cloud)
    sampled = simple.SampleRepresentation(Input=mesh, Points=target)
    sampled.UpdatePipeline()
    values = vtk_to_numpy(sampled.GetClientSideObject().GetOutputDataObject(0).GetPointData().GetArray(name))
    simple.Delete(sampled)
    return float(numpy.nanmax(numpy.abs(values - field(points))))


def strata_curve(image, field, bounds, jump, materials, method="Direct"):
    """(error, cells) at falling bounds."""
    source = producer(image)
    points = sample_points(jump)
    curve = []
    mesh = simple.MultiresolutionTetrahedra(Input=source)
    if materials:
        mesh.VolumeFractionArrays = ["volume_fraction_ball", "volume_fraction_rest"]
    else:
        mesh.VolumeFractionArrays = []
        mesh.MaterialIdArray = "all"
    mesh.FieldArrays = ["f"]
    mesh.ErrorMethod = method
    for interface_bound, field_bound in bounds:
        mesh.InterfaceErrorBound = interface_bound
        mesh.AbsoluteFieldErrorBounds = ["f", str(field_bound)]
        mesh.UpdatePipeline()
        cells = mesh.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells()
        curve.append((strata_error(mesh, "f", field, points), cells))
    simple.Delete(mesh)
    simple.Delete(source)
    return curve


def leaf_errors(leaves, field, jump):
    """The error of each leaf with the best constant that it could hold: half the field's range in it, found at a lattice
    of points. Kinder than the means that the filter writes."""
    corners = vtk_to_numpy(leaves.GetPoints().GetData()).astype(float)
    cells = vtk_to_numpy(leaves.GetCells().GetConnectivityArray()).reshape(-1, 8)
    lower = corners[cells].min(axis=1)
    size = corners[cells].max(axis=1) - lower
    least = numpy.full(len(cells), numpy.inf)
    most = numpy.full(len(cells), -numpy.inf)
    for part in numpy.ndindex(4, 4, 4):
        points = lower + size * (numpy.array(part) / 3.0)
        values = field(points)
        counts = numpy.abs(depth_of(points)) > LAYER if jump else numpy.ones(len(points), dtype=bool)
        least = numpy.where(counts, numpy.minimum(least, values), least)
        most = numpy.where(counts, numpy.maximum(most, values), most)
    return numpy.where(most > least, 0.5 * (most - least), 0.0)


def tree_curve(image, field, jump, thresholds, depths):
    """(error, leaves) of Resample To Hyper Tree Grid, subdivided where the standard deviation is above a threshold."""
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, image)
    source = producer(blocks)
    curve = []
    for depth, threshold in zip(depths, thresholds):
        tree = simple.ResampleToHyperTreeGrid(Input=source)
        tree.SubdividingCriterion = "Standard Deviation"
        tree.SubdividingCriterionArray = ["POINTS", "f"]
        tree.Dimensions = [3, 3, 3]
        tree.MaxDepth = depth
        tree.Min = threshold
        tree.Max = 1e9
        tree.UpdatePipeline()
        leaves = vtkHyperTreeGridToUnstructuredGrid()
        leaves.SetInputData(tree.GetClientSideObject().GetOutputDataObject(0))
        leaves.Update()
        found = leaf_errors(leaves.GetOutput(), field, jump)
        curve.append((float(found.max()), len(found)))
        simple.Delete(tree)
    simple.Delete(source)
    return curve


def cells_for(curve, error):
    """The fewest cells of a curve's points that keep an error."""
    fitting = [cells for found, cells in curve if found <= error]
    return min(fitting) if fitting else None


def print_curves(title, curves):
    print(f"{title}: true L-infinity error and cells\n")
    print("| method | " + " | ".join(f"{number + 1}" for number in range(max(map(len, curves.values())))) + " |")
    print("|---" * (1 + max(map(len, curves.values()))) + "|")
    for name, curve in curves.items():
        print(f"| {name} | " + " | ".join(f"{error:.3g}: {cells}" for error, cells in curve) + " |")
    print(flush=True)


def run(trees):
    """Prints the tables and returns the curves of the field with a jump; `trees`: whether hyper tree grids are at hand."""
    image = grid(jumping)
    bounds = [(distance, ERROR) for distance in (2.0 * LAYER, LAYER, 0.7 * LAYER)]
    jump = {
        "Strata": strata_curve(image, jumping, bounds, True, True),
        "Strata, fitted": strata_curve(image, jumping, bounds, True, True, "Fitted"),
        "Strata without materials": strata_curve(image, jumping, [(1.0, b) for b in (0.1, ERROR)], True, False),
    }
    image_smooth = grid(smooth)
    bounds = [(1.0, b) for b in (0.1, 0.05, 0.02, 0.01, 0.005)]
    flat = {"Strata": strata_curve(image_smooth, smooth, bounds, False, False)}
    if trees:
        jump["Hyper tree grid"] = tree_curve(image, jumping, True, (0.005, 0.002), (7, 8))
        flat["Hyper tree grid"] = tree_curve(image_smooth, smooth, False, (0.04, 0.02, 0.01), (7, 7, 7))
    print_curves(f"A field with a jump, farther than {LAYER:.4f} from it", jump)
    wanted = {name: cells_for(curve, ERROR) for name, curve in jump.items()}
    print(f"Cells for an error of {ERROR}: " + ", ".join(f"{name} {cells}" for name, cells in wanted.items()) + "\n")
    print_curves("A smooth field", flat)
    return jump
