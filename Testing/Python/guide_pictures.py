"""Makes every picture that the guide shows anew, tiny: guide_pictures.py GUIDE_FOLDER

STRATA_OUTPUT names the folder for the pictures, STRATA_GUIDE_QUICK=1 makes them tiny.
"""
import os
import re
import runpy
import sys
from pathlib import Path

guide = Path(sys.argv[1])
made = Path(os.environ["STRATA_OUTPUT"])
for old in made.glob("*.png"):
    old.unlink()
sys.path.insert(0, str(guide / "pictures"))
runpy.run_path(str(guide / "pictures" / "make_pictures.py"))

shown = {name for page in guide.glob("*.md") for name in re.findall(r"!\[[^]]*\]\((\S+)\)", page.read_text("utf-8"))}
missing = [name for name in sorted(shown) if not (made / name).is_file()]
unknown = [name for name in sorted(shown) if not (guide / name).is_file()]
print(f"{len(shown)} pictures; not made: {missing}; not in the guide's folder: {unknown}")
sys.exit(1 if missing or unknown or not shown else 0)
