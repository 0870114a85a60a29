"""Makes the guide's pictures: scripts/make-guide-pictures. STRATA_OUTPUT names another folder for them."""
import guide_scene
import guide_filters
import guide_gallery
from paraview import simple
from strata_example import load_plugin, read_impact

load_plugin()
case = read_impact(15.0)
interfaces = simple.MaterialInterfaces(Input=case)
guide_filters.draw(case, interfaces)
guide_gallery.draw(case, interfaces)
