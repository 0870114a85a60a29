"""Checks what must hold in the grids of the impact, and prints a table of facts: check.py FILE..."""
import os
import sys

import numpy

from compress import arrays, read

MATERIALS = ("projectile", "block", "empty")
BOUNDS = (0, 12, 0, 12, -16, 4.8)


def require(condition, name, what):
    if not numpy.all(condition):
        sys.exit(f"{name}: {what}")


def check(name, grid, values, fractions, densities):
    require(numpy.allclose(grid.GetBounds(), BOUNDS), name, "the bounds are wrong")
    for array, data in values.items():
        require(numpy.isfinite(data), name, f"{array} is not finite")
    for material, fraction in fractions.items():
        require((fraction >= 0) & (fraction <= 1), name, f"fractions of {material} leave [0, 1]")
    require(sum(fractions.values()) == 1, name, "fractions don't sum to 1")
    for material, density in densities.items():
        require((density > 0) == (fractions[material] > 0), name, f"the density of {material} is not where it is")
    mean = sum(fractions[material] * density for material, density in densities.items())
    require(abs(mean - values["density"]) < 1e-5, name, "the density is not the mean of its parts")
    for array in ("density", "pressure"):
        require(values[array][fractions["empty"] == 1] == 0, name, f"empty cells have {array}")


def main(names):
    print("file                  time  projectile g      block g  two materials  three")
    for name in names:
        grid = read(name)
        values = {array: data.astype(float) for array, data in arrays(grid).items()}
        fractions = {material: values["volume_fraction_" + material] for material in MATERIALS}
        densities = {material: values["density_" + material] for material in MATERIALS[:2]}
        check(name, grid, values, fractions, densities)
        time = grid.GetFieldData().GetArray("TimeValue").GetTuple1(0)
        volume = 12 * 12 * 20.8 / grid.GetNumberOfCells()
        mass = [volume * (fractions[material] * densities[material]).sum() for material in densities]
        present = sum((fraction > 0).astype(int) for fraction in fractions.values())
        print(f"{os.path.basename(name):18} {time:7.2f} {mass[0]:13.4f} {mass[1]:12.2f} "
              f"{(present == 2).sum():14d} {(present == 3).sum():6d}")


if __name__ == "__main__":
    main(sys.argv[1:])
