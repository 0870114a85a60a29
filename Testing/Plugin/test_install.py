"""An installed plugin is found and loaded, and its Python package works: test_install.py CMAKE BUILD FOLDER

The installation goes to FOLDER instead of the root. ParaView's programs load what they find in `plugins` beside them;
here the variable PV_PLUGIN_PATH names that folder.
"""
import glob
import os
import shutil
import subprocess
import sys

USE_PLUGIN = "from paraview.simple import *; MultiresolutionTetrahedra"
USE_PACKAGE = "import strata; print(strata.__file__); strata.vtkStrataTetrahedra()"


def install(cmake, build, folder):
    shutil.rmtree(folder, ignore_errors=True)
    environment = dict(os.environ, DESTDIR=folder)
    for component in ("paraview_plugins", "python"):
        subprocess.run([cmake, "--install", build, "--component", component], env=environment, check=True,
                       stdout=subprocess.DEVNULL)


def only(pattern):
    found = glob.glob(pattern, recursive=True)
    if len(found) != 1:
        sys.exit(f"ERROR: {pattern} is {found or 'nowhere'}")
    return found[0]


def run(statement, **environment):
    surroundings = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    subprocess.run(["pvpython", "-c", statement], env={**surroundings, **environment}, check=True)


def main(cmake, build, folder):
    install(cmake, build, folder)
    run(USE_PLUGIN, PV_PLUGIN_PATH=only(f"{folder}/**/bin/plugins"))
    run(USE_PACKAGE, PYTHONPATH=os.path.dirname(only(f"{folder}/**/strata/__init__.py")) + "/..")


if __name__ == "__main__":
    main(*sys.argv[1:])
