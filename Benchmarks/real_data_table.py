"""The table of real data in Documentation/algorithm/RealData.md, each row in a process of its own, in Markdown:

    export PYTHONPATH=build/lib/python3/dist-packages
    /usr/bin/python3 Benchmarks/real_data_table.py FOLDER ROWS.jsonl

ROWS.jsonl keeps the rows that are done: run again after a stop, or to print what there is (--print). Delete it when the
code has changed. Every row is checked: what is found must not exceed what the representation claims of itself.
"""
import argparse
import json
import math
import sys
from pathlib import Path

import real_data

USUAL = ("0.04:0.08", "0.02:0.04", "0.01:0.02")
# Name in real_data_sets.DATA_SETS -> bounds as parts of the diagonal and of the field's range.
BOUNDS = {"impact 32": ("0.02:0.04", "0.01:0.02", "0.005:0.01"), "spcth amr": USUAL, "spcth leaves": USUAL, "cth": USUAL,
          "drop": USUAL, "sloshing 2": USUAL, "sloshing 8": USUAL, "charge 0.17": USUAL, "triple point": USUAL,
          "triple curved": USUAL, "obstacle": USUAL, "dam break": USUAL, "dam break polyhedra": USUAL,
          "frog": ("0.08:0.08", "0.04:0.04", "0.02:0.02"), "impact 128": USUAL, "sedov": USUAL}
# Films of four fluids that end within the box take ever more cells, and are not shown at any of the bounds.
CERTIFIED = {name: ("0.16:0.16", "0.08:0.08", "0.04:0.08") for name in ("dam break", "dam break polyhedra")}
# The readers of these give no field at points, and cells of several sizes meet in them; or they have no fields.
ONLY_IN_CELLS = ("spcth amr", "frog", "impact 128")
ONLY_AT_POINTS = ("triple curved",)
# Fields at points jump where cells of two sizes meet: no continuous one comes as near as asked for, at any level.
MAXIMUM_LEVELS = {("drop", True, True): 20}
KINDS = ((True, False), (True, True), (False, True), (False, False))  # certified, at points
LIMIT = 1000000  # cells


def plan():
    """What rows there are: name, certified, field at points, bounds."""
    return [(name, certified, points, bounds) for certified, points in KINDS for name in BOUNDS
            if name not in (ONLY_IN_CELLS if points else ONLY_AT_POINTS)
            for bounds in (CERTIFIED if certified and name in CERTIFIED else BOUNDS)[name]]


def key(name, certified, points, bounds):
    return f"{name}|{'certified' if certified else 'at samples'}|{'points' if points else 'cells'}|{bounds}"


def computed(name, certified, points, bounds, options):
    level = MAXIMUM_LEVELS.get((name, certified, points), 60)
    run = argparse.Namespace(
        folder=options.folder, defaults=False, bounds=bounds, certified=certified, points=points, method="direct",
        set=["LimitCells=1", f"MaximumNumberOfCells={LIMIT}", f"MaximumLevel={level}"], measure=True, sample=True,
        seconds=options.seconds)
    *rows, last = real_data.run_apart(name, run)
    return {**rows[0], **last} if rows else last


def length(row, name):
    return f"{row[name] / row['diagonal']:.4f}" if name in row else "-"


def interfaces(row):
    """Claimed, found by RepresentationError, sampled. Certified errors are distances between surfaces, both ways."""
    if not row["certified"]:
        return [length(row, name) for name in ("claimed interface", "measured interface", "sampled interface")]

    def found(what):
        ends = [max(row.get(f"{what} {way} {end}", math.nan) for way in ("there", "back")) / row["diagonal"]
                for end in ("lower", "upper")]
        return " to ".join(f"{end:.4f}" for end in ends)

    if math.isinf(row["claimed interface"]) and "claimed regions" in row:
        return [f"inf; regions {length(row, 'claimed regions')}", f"inf; regions {found('regions')}",
                length(row, "sampled Hausdorff")]
    return [length(row, "claimed interface"), found("Hausdorff"), length(row, "sampled Hausdorff")]


def fields(row):
    claimed = f"{max(row['claimed fields']):.4g}" if row["claimed fields"] else "-"
    claimed += f" + {row['left out']:.3g}" if row.get("left out") else ""
    return [claimed] + [f"{row[name]:.4g}" if name in row and row["claimed fields"] else "-"
                        for name in ("measured field", "sampled field")]


def line(row):
    name, errors, place, bounds = row["key"].split("|")
    start = [name, f"{row['cells in']}" if "cells in" in row else "", row.get("fields", ""), place,
             bounds.replace(":", " ")]
    if "failed" in row or not row["cells out"]:
        reason = row.get("failed") or row["said"][0].split(": ", 2)[-1]
        return "| " + " | ".join(start + [reason] + [""] * 9) + " |"
    found = row["violations"]
    met = "yes" if row["met"] else row["stopped by"]
    return "| " + " | ".join(start + [str(row["cells out"])] + interfaces(row) + fields(row) + [
        met + ("; EXCEEDED" if found else ""), f"{row['cpu']:.1f} s", f"{row['memory']:.0f} MB"]) + " |"


def show(rows):
    for certified, title in ((True, "certified"), (False, "at samples")):
        print(f"\n**{title}**\n\n| data | cells in | field | in | bounds | cells out | interface claimed | found "
              "| sampled | field claimed | found | sampled | met | CPU | memory |\n" + "|---" * 15 + "|")
        for name in BOUNDS:
            for row in rows.values():
                if row["key"].startswith(f"{name}|{title}|"):
                    print(line(row))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("rows", type=Path, help="file that keeps the rows")
    parser.add_argument("--only", default="", help="data sets, with commas between")
    parser.add_argument("--seconds", type=int, default=240, help="time limit of a row, measuring included")
    parser.add_argument("--print", action="store_true", help="print the table of the rows that are done")
    options = parser.parse_args()
    texts = options.rows.read_text().splitlines() if options.rows.exists() else []
    rows = {row["key"]: row for row in map(json.loads, texts)}
    for name, *how in plan():
        if options.print or key(name, *how) in rows or (options.only and name not in options.only.split(",")):
            continue
        row = {"key": key(name, *how), **computed(name, *how, options)}
        rows[row["key"]] = row
        with options.rows.open("a") as file:
            print(json.dumps(row), file=file)
        print(line(row), *row.get("violations", []), sep="\n    ", flush=True)
    if options.print:
        show(rows)
    sys.exit(any(row.get("violations") for row in rows.values()))


if __name__ == "__main__":
    main()
