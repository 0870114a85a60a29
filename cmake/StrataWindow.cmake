# What the plugin adds to ParaView's window: widgets for the panel, and an abort button that works. Sets
# STRATA_WINDOW_INTERFACES and STRATA_WINDOW_SOURCES, arguments for paraview_add_plugin, and STRATA_WINDOW_LIBRARIES.
find_package(Qt5 REQUIRED COMPONENTS Widgets)
set(STRATA_WINDOW_LIBRARIES Qt5::Widgets)
foreach (library IN ITEMS pqWidgets pqCore pqComponents pqApplicationComponents)
  list(APPEND STRATA_WINDOW_LIBRARIES ParaView::${library})
  # Those of an installed ParaView bring along libraries that we don't use, whose targets would need the development
  # files of all that it was built with (HDF5, Boost, NetCDF, ...).
  get_target_property(configurations ParaView::${library} IMPORTED_CONFIGURATIONS)
  if (NOT configurations)
    continue ()
  endif ()
  foreach (configuration IN LISTS configurations)
    set_target_properties(ParaView::${library} PROPERTIES
      INTERFACE_LINK_LIBRARIES                           ParaView::RemotingServerManager
      IMPORTED_LINK_DEPENDENT_LIBRARIES_${configuration} "")
  endforeach ()
endforeach ()

set(STRATA_WINDOW_INTERFACES)
set(STRATA_WINDOW_SOURCES)

macro (strata_window_add class)
  list(APPEND STRATA_WINDOW_INTERFACES ${interfaces})
  list(APPEND STRATA_WINDOW_SOURCES ${sources}
    "${PROJECT_SOURCE_DIR}/Plugin/Window/${class}.cxx" "${PROJECT_SOURCE_DIR}/Plugin/Window/${class}.h")
endmacro ()

# strata_panel_widget(<WIDGET or GROUP_WIDGET> <name in the XML> <class>)
macro (strata_panel_widget kind type class)
  paraview_plugin_add_property_widget(KIND ${kind} TYPE ${type} CLASS_NAME ${class}
    INTERFACES interfaces SOURCES sources)
  strata_window_add(${class})
endmacro ()

paraview_plugin_add_auto_start(CLASS_NAME pqStrataAbort INTERFACES interfaces SOURCES sources)
strata_window_add(pqStrataAbort)
strata_panel_widget(WIDGET strata_logarithmic_slider pqStrataLogarithmicSlider)
strata_panel_widget(WIDGET strata_material_list pqStrataMaterialList)
strata_panel_widget(GROUP_WIDGET strata_box pqStrataBox)
strata_panel_widget(GROUP_WIDGET strata_sphere pqStrataSphere)
