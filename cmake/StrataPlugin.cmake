# Builds the plugin against an installed ParaView, and the Python package beside it.
paraview_plugin_scan(
  PLUGIN_FILES      "${PROJECT_SOURCE_DIR}/paraview.plugin"
  PROVIDES_PLUGINS  plugins
  REQUIRES_MODULES  required_modules
  ENABLE_BY_DEFAULT ON)
# ParaView adds the folder in which it found the paraview.plugin. Standalone, that folder is the one that is
# being configured right now, so point to the plugin's own.
set_property(GLOBAL PROPERTY _paraview_plugin_Strata_file "${PROJECT_SOURCE_DIR}/Plugin/paraview.plugin")
paraview_plugin_build(
  RUNTIME_DESTINATION  "${CMAKE_INSTALL_BINDIR}"
  LIBRARY_DESTINATION  "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}"
  PLUGINS_FILE_NAME    strata.plugins.xml
  AUTOLOAD             Strata
  INSTALL_HEADERS      OFF
  PLUGINS_COMPONENT    paraview_plugins # 5.11 documents this default, but doesn't set it
  PLUGINS              ${plugins})

# 5.11 installs this file without a component, hence into no package.
install(FILES "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/strata.plugins.xml"
  DESTINATION "${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}" COMPONENT paraview_plugins)

# Every program of ParaView loads what it finds in the folder `plugins` beside it.
set(installed_plugin "${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/Strata")
file(RELATIVE_PATH link_target "/${CMAKE_INSTALL_BINDIR}/plugins" "/${installed_plugin}")
file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/plugins")
file(CREATE_LINK "${link_target}" "${CMAKE_BINARY_DIR}/plugins/Strata" SYMBOLIC)
install(FILES "${CMAKE_BINARY_DIR}/plugins/Strata" DESTINATION "${CMAKE_INSTALL_BINDIR}/plugins"
  COMPONENT paraview_plugins)

if (STRATA_PYTHON)
  set(STRATA_PYTHON_DESTINATION "lib/python3/dist-packages")
  vtk_module_wrap_python(
    MODULES             StrataFilters StrataReaders
    TARGET              Strata::python
    PYTHON_PACKAGE      strata
    MODULE_DESTINATION  "${STRATA_PYTHON_DESTINATION}"
    LIBRARY_DESTINATION "${installed_plugin}" # becomes the run path
    INSTALL_HEADERS     OFF
    COMPONENT           python
    BUILD_PYI_FILES     OFF)
  configure_file("${PROJECT_SOURCE_DIR}/cmake/strata.py.in"
    "${CMAKE_BINARY_DIR}/${STRATA_PYTHON_DESTINATION}/strata/__init__.py" @ONLY)
  install(FILES "${CMAKE_BINARY_DIR}/${STRATA_PYTHON_DESTINATION}/strata/__init__.py"
    DESTINATION "${STRATA_PYTHON_DESTINATION}/strata" COMPONENT python)
endif ()

# All that using the plugin needs, without the tests.
add_custom_target(strata_plugin DEPENDS Strata)
if (STRATA_PYTHON)
  add_dependencies(strata_plugin vtkStrataFiltersPython vtkStrataReadersPython)
endif ()
