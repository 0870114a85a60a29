# The user guide as pages of ParaView's help, beside those that ParaView makes of the filters' XML. STRATA_HELP holds the
# arguments for paraview_add_plugin; it is empty where Python's markdown is missing.
set(STRATA_HELP)
find_package(Python3 COMPONENTS Interpreter)
execute_process(COMMAND "${Python3_EXECUTABLE}" -c "import markdown" RESULT_VARIABLE markdown_missing ERROR_QUIET)
if (markdown_missing)
  message(STATUS "Without Python's markdown, ParaView's help lacks Strata's user guide")
  return ()
endif ()

set(guide "${PROJECT_SOURCE_DIR}/Documentation/UserGuide")
set(pages "${CMAKE_CURRENT_BINARY_DIR}/guide")
file(GLOB guide_sources CONFIGURE_DEPENDS "${guide}/*.md" "${guide}/*.png")
file(MAKE_DIRECTORY "${pages}")
add_custom_command(
  OUTPUT "${pages}/index.html"
  DEPENDS "${PROJECT_SOURCE_DIR}/cmake/guide_to_html.py" ${guide_sources}
  COMMAND "${Python3_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/cmake/guide_to_html.py" "${guide}" "${pages}"
  COMMENT "Making help pages of the user guide"
  VERBATIM)
add_custom_target(StrataGuide DEPENDS "${pages}/index.html")
set(STRATA_HELP DOCUMENTATION_DIR "${pages}" DOCUMENTATION_DEPENDENCIES StrataGuide "${pages}/index.html")
