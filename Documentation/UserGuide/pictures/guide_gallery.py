"""The gallery: mixed against separate fields, three levels with what they achieved, a junction close up."""
from guide_junction import junction_grid
from guide_scene import *
from strata_example import field_value


def draw_mixed_and_separate(case, interfaces):
    tetrahedra = refine(case, 0.05, 0.5, Interfaces=interfaces)
    grid = simple.ExtractBlock(Input=case, Selectors=["/Root/grid"])
    mixed = cut(simple.CellDatatoPointData(Input=grid))
    views = []
    for source, text in ((mixed, "mixed field, as usual"), (material_slice(tetrahedra), "each material's own field")):
        view = new_view(480, 520)
        show_density(source, view, bar=False)
        show_lines(cut(interfaces), view, width=1.5, towards_viewer=0.03)
        caption(view, text)
        look_at_plane(view, 3.0, -1.2, 4.0)
        views.append(view)
    save_row(views, "mixed-and-separate.png")


def draw_levels(case, interfaces):
    views = []
    tetrahedra = refine(case, 0.15, 0.5, Interfaces=interfaces)
    for scale in (4.0, 2.0, 1.0):
        # A copy, so that three levels stand side by side.
        level = refine(case, 0.15 * scale, 0.5 * scale, Interfaces=interfaces)
        mesh = data(level)
        view = new_view(340, 540)
        show_density(material_slice(level), view, bar=False)
        show_lines(cut(level), view, opacity=0.4)
        caption(view, f"{mesh.GetNumberOfCells()} cells\ninterface {field_value(mesh, 'achieved_interface_error'):.3f}, "
                      f"density {field_value(mesh, 'achieved_field_error_density'):.2f}")
        look_at_plane(view, 6.0, -6.4, 12.0)
        views.append(view)
    simple.Delete(tetrahedra)
    save_row(views, "three-levels.png")


def draw_junction():
    """Three materials that meet in a line: what Contour makes of the fractions, and what Strata draws."""
    grid = junction_grid(8 if QUICK else 12)
    middle = cut(grid, 0.5)
    views = []
    view = new_view(480, 520)
    points = simple.CellDatatoPointData(Input=grid)
    for material, number in (("left", 0), ("right", 1), ("below", 3)):
        lines = simple.Contour(Input=points, ContourBy=["POINTS", "volume_fraction_" + material], Isosurfaces=[0.5])
        show_lines(cut(lines, 0.5), view, MATERIAL_COLORS[3 * number:3 * number + 3], 4.0, towards_viewer=0.1)
    show_lines(middle, view, [0.6, 0.6, 0.6])
    caption(view, "Contour of each fraction at 0.5: a hole")
    look_at_plane(view, 0.5, 0.5, 0.32)
    views.append(view)

    tetrahedra = simple.MultiresolutionTetrahedra(Input=grid, InterfaceErrorBound=0.01 if not QUICK else 0.1)
    view = new_view(480, 520)
    section = material_slice(tetrahedra, 0.5)
    display = simple.Show(section, view)
    display.Representation = "Surface"
    simple.ColorBy(display, ("CELLS", "material"))
    display.SetScalarBarVisibility(view, False)
    display.Ambient, display.Diffuse = 1.0, 0.0
    colors = simple.GetColorTransferFunction("material")
    colors.InterpretValuesAsCategories = 1
    colors.Annotations = [text for value in range(-1, 3) for text in (str(value), str(value))]
    colors.IndexedColors = [0.0, 0.0, 0.0] + MATERIAL_COLORS[9:12] + MATERIAL_COLORS[:6]
    show_lines(middle, view, [0.6, 0.6, 0.6])
    caption(view, "Material Slice: no hole, no overlap")
    look_at_plane(view, 0.5, 0.5, 0.32)
    views.append(view)
    save_row(views, "junction.png")


def draw(case, interfaces):
    draw_mixed_and_separate(case, interfaces)
    draw_levels(case, interfaces)
    draw_junction()
