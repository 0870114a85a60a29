"""The plugin works across a network: test_server.py PVSERVER [PORT]

A server of one rank and this client load it, and give what the client alone does: the same mesh, slice and results,
and first views with names.
"""
import os
import re
import subprocess
import sys

from paraview import simple

TIME = 15.0


def start(server):
    """A server, and the port that it listens at, as it says itself."""
    process = subprocess.Popen([server, "--server-port=0"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    for line in process.stdout:
        port = re.search(r"Accepting connection\(s\): \S+:(\d+)", line)
        if port:
            return process, int(port.group(1))
        print(line, end="")
    raise AssertionError("the server doesn't say where it listens")


def run(remote):
    """Counts, ranges and results of a pipeline, and the names in its first view."""
    simple.LoadPlugin(os.environ["STRATA_PLUGIN"], remote=False, ns=vars(simple))
    if remote:
        simple.LoadPlugin(os.environ["STRATA_PLUGIN"], remote=True)
    case = simple.OpenDataFile(os.path.join(os.environ["STRATA_DATA"], "impact", "impact.strata"))
    tetrahedra = simple.MultiresolutionTetrahedra(Input=case, FieldArrays=["density"], InterfaceErrorBound=0.3,
                                                  FieldErrorBound=0.2)
    tetrahedra.UpdatePipeline(TIME)
    section = simple.MaterialSlice(Input=tetrahedra)
    section.UpdatePipeline(TIME)
    view = simple.CreateRenderView()
    view.ViewTime = TIME
    display = simple.Show(tetrahedra, view)
    simple.Render(view)
    data = section.GetDataInformation()
    found = [tetrahedra.NumberOfCells, tetrahedra.AchievedInterfaceError, tetrahedra.StoppedBy, data.GetNumberOfPoints(),
             data.GetNumberOfCells(), section.PointData["density"].GetRange(), list(display.LookupTable.Annotations)]
    return [str(value) for value in found]


def outcome(server, port):
    """What a client of its own finds, connected to the port unless that is 0."""
    printed = subprocess.run(["pvpython", __file__, server, port], stdout=subprocess.PIPE, text=True, check=True).stdout
    found = [line for line in printed.splitlines() if line.startswith("found ")]
    print(*found, sep="\n")
    return found


def client(port):
    if port != "0":
        simple.Disconnect()
        simple.Connect("localhost", int(port))
    print("found", run(remote=port != "0"))


def main(server):
    alone = outcome(server, "0")
    process, port = start(server)
    try:
        across = outcome(server, str(port))
    finally:
        process.terminate()
    if alone != across or "several" not in alone[0]:
        print("ERROR: client and server differ from a client alone")
        return 1
    return 0


if __name__ == "__main__":
    if len(sys.argv) > 2:
        client(sys.argv[2])
    else:
        sys.exit(main(sys.argv[1]))
