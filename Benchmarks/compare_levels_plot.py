"""The pictures of the levels' figures: times by size of the level, cells by true error, cost of a build by size of the input."""
import math
import os
import resource
import subprocess

# Edges of BenchmarkScale's cubes, and the memory that each needs, in GiB.
SCALE_EDGES = [(47, 0.5), (100, 0.5), (215, 2.0), (512, 12.0)]


def processor_seconds(command):
    """The processor time of a program over all its threads: other programs beside it hardly change it."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def scale_points(program):
    """(native cells, processor seconds) of BenchmarkScale for the sizes that fit into free memory; none if it isn't built."""
    if not program.exists():
        print(f"No cost of builds by size: {program.name} is not built.")
        return []
    free = os.sysconf("SC_AVPHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") / 2**30
    points = [(edge**3, processor_seconds([str(program), str(edge)])) for edge, need in SCALE_EDGES if need < free]
    print("| native cells | processor seconds | ns per cell and log2 of the cells |\n|---|---|---|")
    for cells, seconds in points:
        print(f"| {cells} | {seconds:.1f} | {1e9 * seconds / (cells * math.log2(cells)):.0f} |")
    print()
    return points


def plot_times(axes, columns):
    """Wall times as parts of the build's, which stands for 1."""
    for measured in ("change of level", "deep copy of the mesh", "Plane Cutter", "Material Slice, dragged"):
        points = sorted((row["cells"], row[measured].wall / row["build = rebuild from scratch"].wall) for _, row in columns)
        axes.plot(*zip(*points), "o-", label=measured)
    axes.axhline(0.05, linestyle="--", color="grey", label="1/20")
    axes.set(xscale="log", yscale="log", xlabel="tetrahedra of the level", ylabel="parts of the build's time")


def plot_errors(axes, curves):
    for name, points in curves.items():
        axes.plot(*zip(*points), "o-", label=name)
    axes.set(xscale="log", yscale="log", xlabel="true L-infinity error, field with a jump", ylabel="cells")


def plot_scale(axes, points):
    if not points:
        return
    first_cells, first_seconds = points[0]
    expected = [first_seconds * cells * math.log(cells) / (first_cells * math.log(first_cells)) for cells, _ in points]
    axes.plot(*zip(*points), "o-", label="build")
    axes.plot([cells for cells, _ in points], expected, "--", label="N log N from the smallest")
    axes.set(xscale="log", yscale="log", xlabel="native cells", ylabel="processor seconds")


PLOTS = {"times": plot_times, "errors": plot_errors, "scale": plot_scale}


def plot(name, measured, folder):
    """Draws levels-NAME.png into a folder; not where matplotlib is missing."""
    try:
        import matplotlib
    except ImportError:
        print(f"No plot of {name}: matplotlib is not installed.")
        return
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(6, 4))
    PLOTS[name](axes, measured)
    if axes.lines:
        axes.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(folder / f"levels-{name}.png", dpi=80)
    pyplot.close(figure)
