"""Every property of every proxy has documentation, a domain, and a default that works: test_proxies.py XML..."""
import os
import sys
import xml.etree.ElementTree as ElementTree

from paraview import servermanager
from paraview.simple import LoadPlugin
from vtkmodules.vtkCommonCore import reference

GROUPS = ("filters", "sources")
# Domains that set a default by themselves once the input is known.
DEFAULT_DOMAINS = {
    "ArrayListDomain", "ArrayRangeDomain", "ArraySelectionDomain", "BoundsDomain", "FileListDomain",
    "ProxyListDomain",
}


def definitions(files):
    """The proxies that the files define: (group, name, element)."""
    for file in files:
        for group in ElementTree.parse(file).getroot().findall("ProxyGroup"):
            for proxy in group:
                yield group.get("name"), proxy.get("name"), proxy


def property_elements(proxy):
    return {element.get("name"): element for element in proxy if element.tag.endswith("Property")}


def documented(element):
    documentation = element.find("Documentation")
    return documentation is not None and (documentation.text or "").strip() != ""


def domains(prop):
    iterator = prop.NewDomainIterator()
    iterator.Begin()
    found = []
    while not iterator.IsAtEnd():
        found.append(iterator.GetDomain())
        iterator.Next()
    return found


def is_in_domain(prop, domain):
    """ParaView 5.11 finds no value in a range of doubles with two ends: look at the ends."""
    if not domain.IsA("vtkSMDoubleRangeDomain"):
        return domain.IsInDomain(prop)
    exists = [reference(0), reference(0)]
    low, high = domain.GetMinimum(0, exists[0]), domain.GetMaximum(0, exists[1])
    return all((not exists[0] or low <= value) and (not exists[1] or value <= high)
               for value in (prop.GetElement(i) for i in range(prop.GetNumberOfElements())))


def default_in_range(element):
    """Whether the defaults lie within the ranges of the definition; ranges of the data are not known here."""
    values = [float(value) for value in element.get("default_values").split()]
    for domain in element.iter():
        if domain.tag in ("DoubleRangeDomain", "IntRangeDomain"):
            lowest = float((domain.get("min") or "-inf").split()[0])
            highest = float((domain.get("max") or "inf").split()[0])
            if min(values) < lowest or max(values) > highest:
                return False
    return True


def has_default(element):
    if element.get("default_values") not in (None, ""):
        return True
    if element.tag in ("InputProperty", "Property") or element.get("repeat_command") == "1":
        return True  # an input has no default, a list is empty, a button has no value
    return any(child.tag in DEFAULT_DOMAINS for child in element)


def faults_of_property(prop, element):
    if not documented(element):
        yield "has no documentation"
    if element.get("information_only") == "1" or element.tag == "Property":
        return
    if not domains(prop) and element.find("Hints/FreeText") is None:
        yield "has no domain"
    if not has_default(element):
        yield "has no default"
    numeric = element.tag in ("DoubleVectorProperty", "IntVectorProperty")
    if numeric and element.get("default_values") and not default_in_range(element):
        yield "has a default outside its range"


def faults_of_proxy(group, name, element):
    proxy = servermanager.ProxyManager().NewProxy(group, name)
    if proxy is None:
        return [f"{name} can't be made"]
    faults = [] if documented(element) else [f"{name} has no documentation"]
    if group == "filters" and element.find("Hints/ShowInMenu[@category='Strata']") is None:
        faults.append(f"{name} is not in the menu Strata")
    for property_name, property_element in property_elements(element).items():
        prop = proxy.GetProperty(property_name)
        faults += [f"{name}.{property_name} {fault}" for fault in faults_of_property(prop, property_element)]
    return faults


def main(files):
    LoadPlugin(os.environ["STRATA_PLUGIN"], remote=False)
    found = [definition for definition in definitions(files) if definition[0] in GROUPS]
    faults = [fault for definition in found for fault in faults_of_proxy(*definition)]
    print("\n".join(faults))
    print(f"{len(found)} proxies, {len(faults)} faults")
    return 1 if faults or not found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
