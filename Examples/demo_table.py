"""The table of section 8 of Gregorski et al. 2001, for Strata's own choices and for the paper's."""
from paraview import simple
from strata_example import data, field_value
from vtkmodules.util.numpy_support import vtk_to_numpy

# The paper's figures, on its own simulation of this problem, at (0.15, 3).
PAPER = {(0.15, 3.0): ("3174", "5390", "11990", "2.84", "0.007", "", "", "")}
BOUNDS = [(0.15, 3.0), (0.15, 0.3), (0.05, 0.5)]
ROWS = ("cells with an interface", "all cells, interface bound alone", "all cells, both bounds",
        "largest density error, interface cells", "mean density error, interface cells",
        "achieved interface error", "achieved density error", "stopped by")
# As in the paper, one hierarchy is built down to the finest level of interest (here the tightest bounds of the table;
# that of density is in units of its range), and a cell's error accumulates from all that is below it. Where samples
# lie across the represented interface these choices may never meet the density bound: cells stop at a thousandth of
# the box's edges, and `stopped by` says so.
PAPERS_CHOICES = {"DistanceMethod": "Closest vertex", "GhostMethod": "Constant", "ErrorMethod": "Accumulated",
                  "FinestInterfaceErrorBound": 0.05, "FinestFieldErrorBound": 0.02, "MaximumLevel": 30}
CHOICES = (("paper's choices", PAPERS_CHOICES), ("Strata", {}), ("Strata, fitted", {"ErrorMethod": "Fitted"}))
INTERFACES = ("interfaces without the correction of volumes", "interfaces with volumes corrected to the fractions")
NO_BOUND = 1e30


def refiner(case, interfaces, choices):
    """One filter serves all bounds: it keeps its hierarchy."""
    return simple.MultiresolutionTetrahedra(Input=case, Interfaces=interfaces, FieldArrays=["density"], **choices)


def within(tetrahedra, interface_bound, density_bound):
    tetrahedra.InterfaceErrorBound = interface_bound
    tetrahedra.AbsoluteFieldErrorBounds = ["density", str(density_bound)]
    return data(tetrahedra)


def errors_in_interface_cells(mesh):
    cells = mesh.GetCellData()
    return vtk_to_numpy(cells.GetArray("field_error_density"))[vtk_to_numpy(cells.GetArray("material")) < 0]


def figures(tetrahedra, bounds):
    """The column of the table for some choices."""
    mesh = within(tetrahedra, bounds[0], NO_BOUND)
    by_interface = (errors_in_interface_cells(mesh).size, mesh.GetNumberOfCells())
    mesh = within(tetrahedra, *bounds)
    errors = errors_in_interface_cells(mesh)
    achieved = [field_value(mesh, name) for name in ("achieved_interface_error", "achieved_field_error_density")]
    return (f"{by_interface[0]}", f"{by_interface[1]}", f"{mesh.GetNumberOfCells()}",
            f"{errors.max():.3g}", f"{errors.mean():.2g}", f"{achieved[0]:.4f}", f"{achieved[1]:.3g}",
            field_value(mesh, "stopped_by"))


def print_table(title, columns):
    """`columns`: pairs of a heading and one text per row."""
    print("\n" + title)
    print(" " * 39 + "".join(f"{heading:>19}" for heading, _ in columns))
    for row, name in enumerate(ROWS):
        print(f"{name:39}" + "".join(f"{values[row]:>19}" for _, values in columns))


def show(case):
    """All choices on interfaces with and without the correction of their volumes."""
    for correction, title in enumerate(INTERFACES):
        interfaces = simple.MaterialInterfaces(Input=case, VolumeCorrection=correction)
        refiners = [(name, refiner(case, interfaces, choices)) for name, choices in CHOICES]
        for bounds in BOUNDS:
            columns = [("paper's own data", PAPER.get(bounds, ("",) * len(ROWS)))]
            columns += [(name, figures(tetrahedra, bounds)) for name, tetrahedra in refiners]
            print_table(f"interface bound {bounds[0]}, density bound {bounds[1]}; {title}", columns)
