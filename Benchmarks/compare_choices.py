"""Cells that Strata's choices and the paper's need at equal bounds, on data of others and a sphere, in Markdown:

    PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 Benchmarks/compare_choices.py FOLDER [--certified]

FOLDER holds the data sets (cth, openfoam). Each row runs in a process of its own, with a time limit. The impact is
compared by the target `compare`.
"""
import argparse
import tempfile
from pathlib import Path

import numpy
import real_data
import real_data_sets

# Name in real_data_sets.DATA_SETS -> bounds as parts of the diagonal and of the field's range, cubes of the base mesh.
CASES = {"sphere": ("0.002:0.01", [3, 3, 3]), "cth": ("0.02:0.04", [2, 1, 1]), "dam break": ("0.04:0.08", [2, 2, 1])}
PAPERS = ["DistanceMethod=1", "GhostMethod=2", "MaximumLevel=30"]
# Name, error method, how much tighter than the level's bounds the hierarchy is built, properties of the filter.
ONLY_AT_POINTS = (("the paper's", "accumulated", 1, PAPERS),
                  ("the paper's, hierarchy 3 times finer", "accumulated", 3, PAPERS),
                  ("direct, constant ghosts", "direct", 1, ["GhostMethod=2"]),
                  ("direct, linear ghosts", "direct", 1, ["GhostMethod=1"]))
CHOICES = (("direct", "direct", 1, []),
           ("direct, base cubes {cubes}", "direct", 1, ["BaseCubes={cubes}"]),
           ("saturated, hierarchy 2 times finer", "saturated", 2, []),
           ("fitted", "fitted", 1, []))
SPHERE = 32  # cells along an edge


def write_sphere(path):
    """Fractions of a sphere in the unit cube; a quadratic field inside and another one outside."""
    import compare_data
    from vtkmodules.vtkIOXML import vtkXMLRectilinearGridWriter
    case = compare_data.sphere(SPHERE, (0.513, 0.498, 0.487), 0.3)
    for name, fractions in zip(("volume_fraction_ball", "volume_fraction_rest"), case.fractions):
        compare_data.add_array(case.grid, name, fractions)
    for name in case.names:
        case.grid.GetCellData().RemoveArray(name)
    x, y, z = numpy.meshgrid(*[(axis[1:] + axis[:-1]) / 2 for axis in case.axes], indexing="ij")
    compare_data.add_array(case.grid, "heat_ball", 3.0 + x ** 2 - y * z)
    compare_data.add_array(case.grid, "heat_rest", x + 0.5 * z ** 2)
    writer = vtkXMLRectilinearGridWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(case.grid)
    writer.Write()


def row_of(name, choice, options):
    """What real_data.py finds for a data set and a choice."""
    _, method, finer, settings = choice
    bounds, cubes = CASES[name]
    settings = [text.format(cubes=cubes) for text in settings]
    if finer > 1:
        interface, field = map(float, bounds.split(":"))
        diagonal = real_data.diagonal_of(real_data_sets.load(options.folder, name)[0])
        settings += [f"FinestInterfaceErrorBound={interface * diagonal / finer}",
                     f"FinestFieldErrorBound={field / finer}"]
    run = argparse.Namespace(folder=options.folder, defaults=False, bounds=bounds, certified=options.certified, points=False,
                             method=method, set=settings, measure=False, sample=False, seconds=options.seconds)
    return next(real_data.run_apart(name, run))


def show(name, options):
    """Prints the table of a data set."""
    bounds, cubes = CASES[name]
    choices = CHOICES if options.certified else ONLY_AT_POINTS + CHOICES
    rows = {choice[0]: row_of(name, choice, options) for choice in choices}
    direct = rows["direct"].get("cells out")
    print(f"\n**{name}**, bounds {bounds.replace(':', ', ')}\n\n"
          "| choices | cells | of direct | interface, diagonals | CPU | stopped by |\n|---|---|---|---|---|---|")
    for title, row in rows.items():
        title = title.format(cubes="x".join(map(str, cubes)))
        if "failed" in row:
            print(f"| {title} | {row['failed']} | | | | |")
            continue
        part = f"{row['cells out'] / direct:.2f}" if direct else ""
        print(f"| {title} | {row['cells out']} | {part} | {row['claimed interface'] / row['diagonal']:.5f} | "
              f"{row['cpu']:.1f} s | {row['stopped by']} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", default="", help="data sets, with commas between")
    parser.add_argument("--certified", action="store_true", help="errors over whole native cells")
    parser.add_argument("--seconds", type=int, default=120, help="time limit of a row")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        sphere = Path(folder) / "sphere.vtr"
        write_sphere(sphere)
        real_data_sets.DATA_SETS["sphere"] = (sphere, {"field": "heat"})
        for name in options.only.split(",") if options.only else CASES:
            show(name, options)


if __name__ == "__main__":
    main()
