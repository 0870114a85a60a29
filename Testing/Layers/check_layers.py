"""Fails when an include points up: check_layers.py FOLDER

The layers, from below: Geometry, Model, the stages (which never include each other), Pipeline, Filters/Conversion,
then Filters and Readers. Nothing below Testing and Benchmarks includes them, and the core includes nothing of VTK.
"""
import os
import re
import sys

FOLDERS = ("Core", "Filters", "Readers", "Plugin", "Testing", "Benchmarks")
SEARCH_PATHS = ("Core", "Filters", "Readers", "Testing", ".")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
SOURCE = re.compile(r"\.(h|hpp|cpp|cxx)$")


def layer(path):
    """The rank of a file's layer and the name of its part; a part may always include itself."""
    parts = path.split("/")
    if parts[0] == "Core":
        if len(parts) == 2:
            return 3, "Pipeline"
        return {"Geometry": 0, "Model": 1}.get(parts[1], 2), parts[1]
    if parts[:2] == ["Filters", "Conversion"]:
        return 4, "Conversion"
    if parts[0] in ("Filters", "Readers"):
        return 5, parts[0]
    return {"Plugin": 6, "Testing": 7}.get(parts[0], 8), parts[0]


def resolve(root, including, name):
    """The project's file that an include names, or None where it is somebody else's."""
    for folder in (os.path.dirname(including),) + SEARCH_PATHS:
        path = os.path.normpath(os.path.join(folder, name))
        if not path.startswith("..") and os.path.isfile(os.path.join(root, path)):
            return path
    return None


def violations_in(root, path):
    with open(os.path.join(root, path), encoding="utf-8") as file:
        includes = INCLUDE.findall(file.read())
    rank, part = layer(path)
    for _, name in includes:
        if path.startswith("Core/") and os.path.basename(name).startswith("vtk"):
            yield f"{path}: the core includes {name}"
        target = resolve(root, path, name)
        if target is None:
            continue
        target_rank, target_part = layer(target)
        if target_part != part and target_rank >= rank:
            yield f"{path}: {part} includes {target}"


def violations(root):
    for folder in FOLDERS:
        for directory, _, files in os.walk(os.path.join(root, folder)):
            for file in sorted(filter(SOURCE.search, files)):
                yield from violations_in(root, os.path.relpath(os.path.join(directory, file), root))


if __name__ == "__main__":
    found = list(violations(sys.argv[1]))
    print("\n".join(found) or "every include points down")
    sys.exit(1 if found else 0)
