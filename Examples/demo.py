"""The main job on the impact of Data/impact: read, refine, slice. Written to demo/:

    impact_slice.png   density of each material on the plane y = 0, the cut tetrahedra, the original interfaces
    impact_mixed.png   the same mesh coloured by one mixed density, interpolated linearly
    interfaces.png     the original interfaces by pair of materials
    impact.vtu         the representation

and, printed, the table of section 8 of Gregorski et al. 2001. scripts/demo runs it: pvpython Examples/demo.py
"""
import os
from pathlib import Path

os.environ.setdefault("STRATA_OUTPUT", str(Path(__file__).resolve().parent.parent / "demo"))

import demo_pictures
import demo_table
from paraview import simple
from strata_example import load_plugin, output, read_impact

INTERFACE_BOUND = 0.15
DENSITY_BOUND = 3.0


def refine(case, interfaces):
    return simple.MultiresolutionTetrahedra(
        Input=case, Interfaces=interfaces, FieldArrays=["density"], InterfaceErrorBound=INTERFACE_BOUND,
        AbsoluteFieldErrorBounds=["density", str(DENSITY_BOUND)])


def main():
    load_plugin()
    case = read_impact()
    interfaces = simple.MaterialInterfaces(Input=case)
    tetrahedra = refine(case, interfaces)

    demo_pictures.draw_slice(tetrahedra, interfaces, output("impact_slice.png"))
    demo_pictures.draw_mixed(tetrahedra, interfaces, case, output("impact_mixed.png"))
    demo_pictures.draw_interfaces(interfaces, output("interfaces.png"))
    # ParaView 5.11 as packaged by Debian reads no appended data.
    simple.SaveData(output("impact.vtu"), proxy=tetrahedra, DataMode="Binary")
    for name in ("impact_slice.png", "impact_mixed.png", "interfaces.png", "impact.vtu"):
        print("wrote", output(name))

    demo_table.show(case)


if __name__ == "__main__":
    main()
