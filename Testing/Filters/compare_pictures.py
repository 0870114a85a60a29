"""compare_pictures.py PICTURE BASELINE: VTK's own comparison accepts a picture dimmed to 60 % or moved by three pixels;
this one does not. Baselines NAME_1.png, NAME_2.png, ... are tried as well."""
import glob
import os
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

LARGEST_MEAN = 2.0  # of 255
NOTABLE = 24.0  # difference of a pixel that differs
LARGEST_SHARE = 0.01  # of pixels that differ


def read(name):
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetScalars()).astype(float)
    return values.reshape(height, width, -1)[:, :, :3]


def smoothed(picture):
    """The mean over 3 x 3 pixels: another driver may draw an edge one pixel aside."""
    padded = numpy.pad(picture, ((1, 1), (1, 1), (0, 0)), mode="edge")
    height, width = picture.shape[:2]
    return sum(padded[i:i + height, j:j + width] for i in range(3) for j in range(3)) / 9.0


def differences(picture, baseline):
    if picture.shape != baseline.shape:
        return 255.0, 1.0
    difference = numpy.abs(smoothed(picture) - smoothed(baseline)).max(axis=2)
    return difference.mean(), (difference > NOTABLE).mean()


def main(name, baseline):
    stem, extension = os.path.splitext(baseline)
    found = [differences(read(name), read(other)) for other in [baseline] + sorted(glob.glob(stem + "_[0-9]" + extension))]
    mean, share = min(found)
    print(f"mean difference {mean:.2f}, {100 * share:.2f} % of the pixels differ")
    return 0 if mean <= LARGEST_MEAN and share <= LARGEST_SHARE else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
