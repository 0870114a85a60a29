"""Sets Strata beside what ParaView offers, on the same data in the same run, and prints the tables in Markdown:

    STRATA_PLUGIN=build/lib/.../Strata.so pvpython Benchmarks/compare.py PART [--data FOLDER] [--output FOLDER]

Parts: interfaces, levels. FOLDER of the data holds the series of the impact (and, where they are at hand, data of others).
"""
import argparse
import importlib
import os
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
# Part -> the module beside this file whose run(data_folder, output_folder) prints its tables.
PARTS = {"interfaces": "compare_interfaces", "levels": "compare_levels"}


def main():
    parser = argparse.ArgumentParser(description="Sets Strata beside what ParaView offers.")
    parser.add_argument("part", choices=sorted(PARTS))
    parser.add_argument("--data", type=Path, default=HERE.parent / "Data", help="folder of the data sets")
    parser.add_argument("--output", type=Path, default=Path("."), help="folder for files that a part writes")
    options = parser.parse_args()
    sys.path.insert(0, str(HERE.parent / "Examples"))
    sys.path.insert(0, str(HERE))
    os.environ["STRATA_OUTPUT"] = str(options.output)
    importlib.import_module(PARTS[options.part]).run(options.data, options.output)


if __name__ == "__main__":
    main()
