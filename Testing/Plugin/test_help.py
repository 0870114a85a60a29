"""ParaView's help of the plugin holds every page and picture of the user guide, a page of each proxy, and no dead link:
test_help.py HELP.qch GUIDE"""
import re
import sqlite3
import sys
import zlib
from pathlib import Path

PROXIES = ["MultiresolutionTetrahedra", "MaterialInterfaces", "MaterialSlice", "MaterialContour", "ExtractMaterials",
           "RepresentedInterfaces", "SampleRepresentation", "RepresentationError"]


def pages_of(help_file):
    """Name and contents of the files in Qt's compressed help, an SQLite data base with Qt's compressed bytes."""
    rows = sqlite3.connect(help_file).execute(
        "SELECT Name, Data FROM FileNameTable JOIN FileDataTable ON FileId = Id WHERE Data NOTNULL")
    # Qt puts the length in four bytes before what zlib made.
    return {name: zlib.decompress(data[4:]) for name, data in rows}


def main():
    pages = pages_of(sys.argv[1])
    guide = Path(sys.argv[2])
    expected = {"index.html" if page.stem == "README" else page.stem + ".html" for page in guide.glob("*.md")}
    expected |= {picture.name for picture in guide.glob("*.png")}
    expected |= {f"filters.{name}.html" for name in PROXIES} | {"sources.StrataCaseReader.html"}
    faults = [f"{name} is missing" for name in sorted(expected - set(pages))]
    for name in sorted(expected & set(pages)):
        if name.endswith(".html") and "." not in name[:-5]:
            text = pages[name].decode()
            for target in re.findall(r'(?:href|src)="([^"#]+)', text):
                if "://" not in target and target not in pages:
                    faults.append(f"{name} leads to {target}, which isn't there")
    print(f"{len(pages)} files in the help")
    for fault in faults:
        print("FAULT", fault)
    sys.exit(bool(faults))


main()
