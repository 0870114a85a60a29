# script-version: 2.0
"""In situ, with Catalyst: at each step of a simulation a slice as a file, and what the representation achieved.

ParaView's own driver stands in for a simulation and hands over the grids of files, one a step:

    pvbatch -m paraview.demos.filedriver_miniapp -s catalyst_impact.py -g 'Data/impact/impact_32_*.vtr'

STRATA_PLUGIN names the plugin's library where it isn't installed, STRATA_OUTPUT the folder for results.
"""
import os
from pathlib import Path

from paraview import simple

if not hasattr(simple, "MultiresolutionTetrahedra"):
    simple.LoadPlugin(os.environ["STRATA_PLUGIN"], remote=False, ns=vars(simple))

FOLDER = Path(os.environ.get("STRATA_OUTPUT", "."))
FOLDER.mkdir(parents=True, exist_ok=True)
TABLE = FOLDER / "catalyst_impact.csv"

# The name is that of the channel on which the simulation hands its grid over.
grid = simple.TrivialProducer(registrationName="input")
tetrahedra = simple.MultiresolutionTetrahedra(
    Input=grid, FieldArrays=["density"], InterfaceErrorBound=0.3, AbsoluteFieldErrorBounds=["density", "1"])
section = simple.MaterialSlice(Input=tetrahedra)
section.SliceType.Origin = [0.0, 0.0, 0.0]
section.SliceType.Normal = [0.0, 1.0, 0.0]


def catalyst_initialize():
    TABLE.write_text("step,cells,interface_error,density_error\n")


def catalyst_execute(info):
    section.UpdatePipeline(info.time)
    mesh = tetrahedra.GetClientSideObject().GetOutputDataObject(0)
    errors = [mesh.GetFieldData().GetArray("achieved_" + name).GetValue(0)
              for name in ("interface_error", "field_error_density")]
    with open(TABLE, "a") as table:
        table.write(f"{info.timestep},{mesh.GetNumberOfCells()},{errors[0]:.4f},{errors[1]:.4f}\n")
    simple.SaveData(str(FOLDER / f"catalyst_slice_{info.timestep:02d}.vtp"), section, DataMode="Binary")
