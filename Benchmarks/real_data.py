"""Real data in a table: cells in, cells out at several bounds, the errors claimed and found, time and memory.

    PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 Benchmarks/real_data.py FOLDER --defaults
    PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 Benchmarks/real_data.py FOLDER --measure --sample

FOLDER holds the data sets (impact, openfoam, cth, ...). --defaults leaves everything to the filter, as a first Apply
does. Else bounds are parts of the box's diagonal and of the field's range. Each data set runs in a process of its own.
"""
import argparse
import json
import math
import os
import resource
import signal
import sys
import time
from pathlib import Path

from real_data_sets import DATA_SETS, load, with_field_at_points

METHODS = {"direct": 0, "saturated": 1, "fitted": 2, "accumulated": 3}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", default="", help="data sets, by parts of their names, with commas between")
    parser.add_argument("--defaults", action="store_true", help="what a first Apply gives")
    parser.add_argument("--bounds", default="0.02:0.04,0.01:0.02,0.005:0.01", help="interface:field, relative")
    parser.add_argument("--points", action="store_true", help="move the field from cells to points")
    parser.add_argument("--certified", action="store_true", help="errors over whole native cells")
    parser.add_argument("--method", choices=METHODS, default="direct")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=NUMBER", help="a property of the filter")
    parser.add_argument("--measure", action="store_true", help="run RepresentationError")
    parser.add_argument("--sample", action="store_true", help="sample independently of Strata's code")
    parser.add_argument("--seconds", type=int, default=300, help="time limit of a data set")
    parser.add_argument("--json", type=Path, help="write the rows, with all that was found, into a file")
    return parser.parse_args()


def at_points(data, settings):
    """The data set, and what to set, with a field at points: one that it has there, or the field moved there."""
    from real_data_native import fraction_array
    if "point field" in settings:
        return data, {**settings, "field": settings["point field"]}
    return with_field_at_points(data, settings["field"], lambda m: fraction_array(data.GetCellData(), m)), settings


def configured(algorithm, settings, with_field=True):
    """What the conventions of names don't say."""
    algorithm.SetMaterialIdArray(settings.get("ids", ""))
    algorithm.SetRemainderMaterial(settings.get("remainder", "empty"))
    for name in settings.get("without", []):
        algorithm.AddMaterialWithoutFields(name)
    if with_field and "field" in settings:
        algorithm.AddFieldArray(settings["field"])
    return algorithm


def watched(algorithm, said):
    """Collects warnings and errors instead of printing them."""
    def note(_, event, text="?"):
        said.append(event[:-len("Event")] + ": " + text.strip().splitlines()[-1])
    note.CallDataType = "string0"
    for observed in (algorithm, algorithm.GetExecutive()):
        observed.AddObserver("ErrorEvent", note)
        observed.AddObserver("WarningEvent", note)
    return algorithm


def texts(data, name):
    array = data.GetFieldData().GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array else []


def left_out(mesh):
    """What the mesh says that its fields' errors leave out; 0 without curved cells."""
    arrays = [mesh.GetFieldData().GetArray("not_in_field_error_" + name) for name in texts(mesh, "field_names")]
    return max((array.GetValue(0) for array in arrays if array), default=0.0)


def field_number(data, name):
    """A number in the field data, or None."""
    array = data.GetFieldData().GetArray(name)
    return array.GetValue(0) if array else None


class Run:
    """One data set: reads it, refines it at one bound after another, and looks at the results."""

    def __init__(self, name, options):
        self.name, self.options = name, options
        self.data, self.settings = load(options.folder, name)
        if options.points:
            self.data, self.settings = at_points(self.data, self.settings)
        self.said = []
        if options.defaults:
            self.settings = {}

    def refine(self, interface, field):
        """A row, and the representation. Bounds of None leave all to the filter's defaults."""
        import strata
        filter_ = watched(configured(strata.vtkStrataTetrahedra(), self.settings), self.said)
        if interface is not None:
            filter_.SetInterfaceErrorBound(interface)
            filter_.SetFieldErrorBound(field)
        filter_.SetErrorMethod(METHODS[self.options.method])
        filter_.SetNativeElements(int(self.options.certified))
        for text in self.options.set:
            property_, value = text.split("=")
            getattr(filter_, "Set" + property_)(json.loads(value))
        filter_.SetInputDataObject(0, self.data)
        start, cpu = time.time(), sum(os.times()[:2])
        filter_.Update()
        seconds, cpu = time.time() - start, sum(os.times()[:2]) - cpu
        mesh = filter_.GetOutputDataObject(0)
        return {"data": self.name, "cells in": self.data.GetNumberOfElements(1), "cells out": mesh.GetNumberOfCells(),
                "materials": len(texts(mesh, "material_names")), "fields": ", ".join(texts(mesh, "field_names")),
                "interface bound": interface, "field bound": field, "certified": self.options.certified,
                "claimed interface": filter_.GetAchievedInterfaceError(), "claimed regions": field_number(mesh, "achieved_region_error"),
                "claimed fields": [filter_.GetAchievedFieldError(f)
                                   for f in range(filter_.GetNumberOfAchievedFieldErrors())],
                "left out": left_out(mesh), "met": bool(filter_.GetBoundMet()), "stopped by": filter_.GetStoppedBy(), "seconds": seconds,
                "cpu": cpu, "memory": peak_memory()}, mesh

    def measure(self, row, mesh):
        """RepresentationError's findings."""
        import strata
        errors = watched(configured(strata.vtkStrataError(), self.settings, False), self.said)
        errors.SetInputDataObject(0, mesh)
        errors.SetInputDataObject(1, self.data)
        start = time.time()
        errors.Update()
        row["measuring seconds"] = time.time() - start
        table = errors.GetOutputDataObject(0)
        kinds = [table.GetValueByName(i, "kind").ToString() for i in range(table.GetNumberOfRows())]

        def column(kind, name):
            numbers = [table.GetValueByName(i, name).ToDouble() for i, k in enumerate(kinds) if k == kind]
            return [number for number in numbers if not math.isnan(number)]

        row["measured field"] = max(column("field", "largest"), default=0.0)
        row["measured interface"] = max(column("interface", "largest"), default=0.0)
        row["missing"] = sum(column("field", "missing")) + sum(column("interface", "missing"))
        for end in ("lower", "upper"):
            for name, short in (("original_to_represented", "there"), ("represented_to_original", "back")):
                row[f"Hausdorff {short} {end}"] = max(column("interface", f"{name}_{end}"), default=0.0)
                row[f"regions {short} {end}"] = max(column("region", f"{name}_{end}"), default=0.0)
        row["misclassified"] = sum(column("misclassified", "misclassified_volume"))

    def rows(self):
        steps = [(None, None)]
        if not self.options.defaults:
            steps = [tuple(map(float, step.split(":"))) for step in self.options.bounds.split(",")]
        diagonal = diagonal_of(self.data)
        for interface, field in steps:
            row, mesh = self.refine(interface and interface * diagonal, field)
            row["diagonal"] = diagonal
            if self.options.measure and row["cells out"]:
                self.measure(row, mesh)
            if self.options.sample and row["cells out"]:
                import real_data_sampling
                row.update(real_data_sampling.sample(mesh, self))
            row["violations"] = violations(row)
            row["said"], self.said = self.said, []
            yield row


def violations(row, rounding=1e-5, digits=1e-12):
    """What was found and exceeds what the representation says of itself, by more than rounding."""
    claims = {"field": max(row["claimed fields"], default=0.0) + row["left out"]}
    if not row["certified"]:  # certified errors are distances between surfaces, not from vertices to planes
        claims["interface"] = row["claimed interface"]
    least = {"field": digits * row.get("magnitude", 0.0), "interface": digits * row["diagonal"]}
    found = [f"{how} {what} error {row[f'{how} {what}']:.5g} > {claimed:.5g} claimed"
             for what, claimed in claims.items() for how in ("measured", "sampled")
             if row.get(f"{how} {what}", 0.0) > claimed * (1.0 + rounding) + least[what]]
    if row["certified"]:
        found += [f"{how} {row[how]:.5g} > {row['claimed interface']:.5g} certified"
                  for how in ("Hausdorff there lower", "Hausdorff back lower", "sampled Hausdorff")
                  if row.get(how, 0.0) > row["claimed interface"] * (1.0 + rounding)]
        found += [f"{how} {row[how]:.5g} > {row['claimed regions']:.5g} certified"
                  for how in ("regions there lower", "regions back lower")
                  if row.get(how, 0.0) > row["claimed regions"] * (1.0 + rounding)]
    if row.get("missing"):
        found.append(f"{row['missing']:.0f} native elements in cells without their material")
    if row.get("sampled Hausdorff", 0.0) > 1.001 * max(row.get(f"Hausdorff {way} upper", math.inf)
                                                       for way in ("there", "back")):
        found.append(f"sampled Hausdorff distance {row['sampled Hausdorff']:.5g} lies above the interval")
    return found


def diagonal_of(data):
    from vtkmodules.vtkCommonDataModel import vtkBoundingBox
    bounds = [0.0] * 6
    data.GetBounds(bounds)
    return vtkBoundingBox(bounds).GetDiagonalLength()


def peak_memory():
    """Of this process, in megabytes."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0


def run_apart(name, options):
    """The rows of a data set, computed in a child process, which an alarm ends."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reading)
        signal.alarm(options.seconds)
        with os.fdopen(writing, "w") as pipe:
            for row in Run(name, options).rows():
                print(json.dumps(row), file=pipe, flush=True)
        os._exit(0)
    os.close(writing)
    with os.fdopen(reading) as pipe:
        for line in pipe:
            yield json.loads(line)
    status = os.waitpid(child, 0)[1]
    if status:
        reason = "time limit" if status == signal.SIGALRM else f"ended with status {status}"
        yield {"data": name, "failed": reason}


def length_text(row, name, part=1.0):
    return f"{row[name] / part:.5f}" if name in row else "-"


def printed(row):
    """A line of the table. Lengths are parts of the box's diagonal."""
    if "failed" in row:
        return f"{row['data']:16} {row['failed']}"
    size = row["diagonal"]
    bound = "default" if row["interface bound"] is None else f"{row['interface bound'] / size:g} {row['field bound']:g}"
    lengths = [length_text(row, name, size) for name in (
        "claimed interface", "measured interface", "sampled interface", "Hausdorff there upper",
        "Hausdorff back upper", "sampled Hausdorff")]
    fields = [f"{max(row['claimed fields'], default=0.0):.4g}"] + [
        f"{row[name]:.4g}" if name in row else "-" for name in ("measured field", "sampled field")]
    return (f"{row['data']:16}{row['cells in']:9} {bound:11}{row['cells out']:9} {' '.join(lengths)}  "
            f"{' '.join(fields)} {row['seconds']:6.1f} s {row['cpu']:6.1f} s {row['memory']:6.0f} MB "
            f"{row['stopped by']}; {row['fields']}, {row['materials']} materials")


def main():
    options = arguments()
    sys.path.insert(0, str(Path(__file__).resolve().parent))
    wanted = [part for part in options.only.split(",") if part]
    print("Lengths in diagonals: interface claimed, measured, sampled; Hausdorff there, back, sampled. "
          "Field: claimed, measured, sampled. Wall time, CPU time, peak memory.")
    rows = []
    for name in DATA_SETS:
        if not wanted or any(part in name for part in wanted):
            for row in run_apart(name, options):
                rows.append(row)
                print(printed(row), flush=True)
                for text in row.get("violations", []) + row.get("said", []):
                    print("    " + text[:200], flush=True)
    if options.json:
        options.json.write_text(json.dumps(rows, indent=1))
    sys.exit(any(row.get("violations") or "failed" in row for row in rows))


if __name__ == "__main__":
    main()
