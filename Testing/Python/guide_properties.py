"""Every proxy and property that the guide's page on filters names exists.

    pvpython guide_properties.py FILTERS_PAGE
"""
import os
import re
import sys

from paraview import servermanager, simple

GROUPS = ("filters", "sources")


def sections(text):
    """Each proxy's name and the property names in the first column of its tables."""
    for section in re.split(r"^## ", text, flags=re.MULTILINE)[1:]:
        rows = re.findall(r"^\| (`[^|]*) \|", section, flags=re.MULTILINE)
        yield section.split("\n")[0].strip(), {name for row in rows for name in re.findall(r"`(\w+)`", row)}


def make(name):
    manager = servermanager.ProxyManager()
    definitions = manager.GetProxyDefinitionManager()
    return next((manager.NewProxy(group, name) for group in GROUPS if definitions.HasDefinition(group, name)), None)


def faults(name, named):
    proxy = make(name)
    if proxy is None:
        return [f"there is no {name}"]
    return [f"{name} has no {prop}" for prop in sorted(named) if not proxy.GetProperty(prop)]


simple.LoadPlugin(os.environ["STRATA_PLUGIN"], remote=False)
with open(sys.argv[1], encoding="utf-8") as page:
    pages = list(sections(page.read()))
problems = [fault for name, named in pages for fault in faults(name, named)]
print("\n".join(problems))
print(f"{len(pages)} proxies, {len(problems)} faults")
sys.exit(1 if problems or not pages else 0)
