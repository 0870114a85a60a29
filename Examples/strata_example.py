"""What the examples share: the plugin, the data, and a folder for results.

Each example is a script for pvpython. STRATA_PLUGIN names the plugin's library where it isn't installed,
STRATA_OUTPUT the folder for results (the current one by default).
"""
import os
from pathlib import Path

from paraview import simple
from vtkmodules.vtkCommonCore import vtkLogger

IMPACT = Path(os.environ.get("STRATA_DATA", Path(__file__).resolve().parent.parent / "Data")) / "impact/impact.strata"


def load_plugin():
    """Makes Strata's filters functions of paraview.simple, if they aren't yet."""
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_WARNING)  # 5.11's plane cutter tells when it runs
    if not hasattr(simple, "MultiresolutionTetrahedra"):
        simple.LoadPlugin(os.environ["STRATA_PLUGIN"], remote=False, ns=vars(simple))


def output(name):
    """Path of a result."""
    folder = Path(os.environ.get("STRATA_OUTPUT", "."))
    folder.mkdir(parents=True, exist_ok=True)
    return str(folder / name)


def read_impact(time=15.0):
    """The impact at a time: the case's reader, up to date."""
    case = simple.StrataCaseReader(FileName=str(IMPACT))
    simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    simple.GetTimeKeeper().Time = time
    case.UpdatePipeline(time)
    return case


def data(proxy):
    """The output of a proxy as a VTK object, at the current time (in ParaView's own process, without a server)."""
    proxy.UpdatePipeline(simple.GetTimeKeeper().Time)
    return proxy.GetClientSideObject().GetOutputDataObject(0)


def field_value(dataset, name):
    """The single value of a field data array, as text or number."""
    array = dataset.GetFieldData().GetAbstractArray(name)
    return array.GetValue(0)
