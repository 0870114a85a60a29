"""What is left between the surfaces of the impact and of its representations, in Markdown:

    PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 Benchmarks/hausdorff.py FOLDER/impact/impact_32_04.vtr

For levels with bounds at points and certified ones, direct and fitted: cells, the certified intervals of the two-sided
Hausdorff distance (RepresentationError), the largest distance from points strewn over each surface to the other one (VTK
and numpy, none of Strata's code), volumes, and what the intervals cost. The original's interfaces are taken without and
with volume correction. Fails where an interval is wider than a thousandth of the diagonal or a strewn point lies beyond it.
"""
import argparse
import sys
import time
from pathlib import Path

import real_data
import real_data_sampling
import strata
from real_data_sets import read

INTERFACE_BOUND, DENSITY_BOUND = 0.15, 0.3
SETTINGS = {"field": "density", "without": ["empty"]}
WIDTH = 1e-3  # of the diagonal


def originals(data, corrected):
    """The interfaces in the data."""
    interfaces = real_data.configured(strata.vtkStrataMaterialInterfaces(), SETTINGS, False)
    interfaces.SetVolumeCorrection(corrected)
    interfaces.SetInputDataObject(data)
    interfaces.Update()
    return interfaces.GetOutputDataObject(0)


def representation(data, interfaces, certified, method):
    mesh = real_data.configured(strata.vtkStrataTetrahedra(), SETTINGS)
    mesh.SetInterfaceErrorBound(INTERFACE_BOUND)
    mesh.AddAbsoluteFieldErrorBound("density", DENSITY_BOUND)
    mesh.SetNativeElements(certified)
    mesh.SetErrorMethod(real_data.METHODS[method])
    mesh.SetInputDataObject(0, data)
    mesh.SetInputDataObject(1, interfaces)
    mesh.Update()
    return mesh.GetOutputDataObject(0), mesh.GetAchievedInterfaceError()


class Measured:
    """RepresentationError's table, its rows by kind, and its processor time."""

    def __init__(self, mesh, data, interfaces, tolerance):
        errors = real_data.configured(strata.vtkStrataError(), SETTINGS, False)
        errors.SetHausdorffTolerance(tolerance)
        for port, input_ in enumerate((mesh, data, interfaces)):
            errors.SetInputDataObject(port, input_)
        wall, cpu = time.time(), time.process_time()
        errors.Update()
        self.wall, self.cpu = time.time() - wall, time.process_time() - cpu
        self.table = errors.GetOutputDataObject(0)

    def rows(self, kind):
        return [i for i in range(self.table.GetNumberOfRows()) if self.text(i, "kind") == kind]

    def text(self, row, name):
        return self.table.GetValueByName(row, name).ToString()

    def number(self, row, name):
        return self.table.GetValueByName(row, name).ToDouble()

    def interval(self, way):
        """Over all pairs of materials."""
        return [max(self.number(i, f"{way}_{end}") for i in self.rows("interface")) for end in ("lower", "upper")]

    def volume_error(self, material):
        """As a part of the original volume."""
        row, = [i for i in self.rows("volume") if self.text(i, "material") == material]
        return self.number(row, "represented_volume") / self.number(row, "original_volume") - 1.0

    def misclassified(self):
        return sum(self.number(i, "misclassified_volume") for i in self.rows("misclassified"))


def strewn_distances(mesh, interfaces, count):
    """The largest over all pairs, there and back."""
    represented = strata.vtkStrataRepresentedInterfaces()
    represented.SetInputDataObject(mesh)
    represented.Update()
    there = back = 0.0
    original = real_data_sampling.surfaces(interfaces)
    own = real_data_sampling.surfaces(represented.GetOutputDataObject(0))
    for pair, one, other in real_data_sampling.strewn_over(original, own, count):
        there = max(there, real_data_sampling.farthest(one, own[pair]))
        back = max(back, real_data_sampling.farthest(other, original[pair]))
    return there, back, sum(map(len, original.values())), sum(map(len, own.values()))


def row(data, interfaces, certified, method, count):
    """A line of the table, and whether all holds."""
    mesh, claimed = representation(data, interfaces, certified, method)
    diagonal = real_data.diagonal_of(data)
    measured = Measured(mesh, data, interfaces, WIDTH)
    intervals = [measured.interval(way) for way in ("original_to_represented", "represented_to_original")]
    *strewn, original, own = strewn_distances(mesh, interfaces, count)
    holds = all(upper - lower <= 1.001 * WIDTH * diagonal and found <= upper
                for (lower, upper), found in zip(intervals, strewn))
    if certified:
        holds = holds and max(lower for lower, _ in intervals) <= claimed * (1 + 1e-6)
    texts = [f"{'certified' if certified else 'points'}, {method}", f"{mesh.GetNumberOfCells()}", f"{claimed:.4f}"]
    texts += [f"{lower:.4f} to {upper:.4f}; {found:.4f}" for (lower, upper), found in zip(intervals, strewn)]
    texts += [f"{100.0 * measured.volume_error('projectile'):+.1f} %", f"{measured.misclassified():.1f}",
              f"{original}, {own}", f"{measured.wall:.1f} s, {measured.cpu:.1f} s"]
    return "| " + " | ".join(texts) + " |" + ("" if holds else " VIOLATED"), holds


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("grid", type=Path)
    parser.add_argument("--points", type=int, default=100000, help="strewn over all surfaces of a side")
    options = parser.parse_args()
    data, fine = read(options.grid), True
    for corrected in (False, True):
        interfaces = originals(data, corrected)
        print(f"\n**{'with' if corrected else 'without'} volume correction**\n\n| level | cells | claimed | original to "
              "represented; strewn | back; strewn | projectile | misclassified | triangles | measuring: wall, CPU |\n"
              + "|---" * 9 + "|")
        for certified in (False, True):
            for method in ("direct", "fitted"):
                text, holds = row(data, interfaces, certified, method, options.points)
                fine = fine and holds
                print(text, flush=True)
    sys.exit(not fine)


if __name__ == "__main__":
    main()
