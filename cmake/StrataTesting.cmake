# What the tests of the plugin share: a display, an environment, and one function per kind of test.
set(STRATA_DISPLAY "${PROJECT_SOURCE_DIR}/scripts/with-display")
set(STRATA_TEST_OUTPUT "${CMAKE_BINARY_DIR}/Testing/Output")
set(STRATA_BASELINES "${PROJECT_SOURCE_DIR}/Testing/Baselines")
set(STRATA_FAILURES "(\n|^)ERROR: ;ERR\\|;Traceback;instance(s)? still around;Failed Image Test;ImageNotFound")
set(STRATA_TEST_ENVIRONMENT
  "PYTHONPATH=${CMAKE_BINARY_DIR}/${STRATA_PYTHON_DESTINATION}"
  "STRATA_PLUGIN=$<TARGET_FILE:Strata>"
  "STRATA_DATA=${PROJECT_SOURCE_DIR}/Data"
  "STRATA_TEST_OUTPUT=${STRATA_TEST_OUTPUT}")
if (STRATA_EXTRA_DATA)
  list(APPEND STRATA_TEST_ENVIRONMENT "STRATA_EXTRA_DATA=${STRATA_EXTRA_DATA}")
endif ()
file(MAKE_DIRECTORY "${STRATA_TEST_OUTPUT}")

# GoogleTests of filters and readers, without rendering: strata_add_filter_test(Slice TestSlice.cxx ...)
function (strata_add_filter_test name)
  add_executable(TestFilter${name} ${ARGN})
  target_link_libraries(TestFilter${name} PRIVATE StrataFilters StrataReaders StrataTestSupport GTest::gtest_main
    VTK::CommonDataModel VTK::CommonExecutionModel VTK::FiltersCore VTK::FiltersSources VTK::ImagingCore VTK::IOXML
    VTK::TestingCore)
  target_compile_options(TestFilter${name} PRIVATE ${STRATA_VTK_WARNINGS})
  target_compile_definitions(TestFilter${name} PRIVATE
    "STRATA_DATA=\"${PROJECT_SOURCE_DIR}/Data\"" "STRATA_EXTRA_DATA=\"${STRATA_EXTRA_DATA}\"")
  gtest_discover_tests(TestFilter${name} TEST_PREFIX "Filters." DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS Filters TIMEOUT 300)
endfunction ()

# Pictures compared with Testing/Baselines/<test>.png. Each file is a VTK test, int TestX(int argc, char* argv[]),
# that ends in vtkRegressionTestImage: strata_add_image_tests(Slice TestSliceImage.cxx ...)
function (strata_add_image_tests name)
  # The driver that VTK's own tests have: it wants these two names.
  set(_vtk_build_TEST_OUTPUT_DIRECTORY "${STRATA_TEST_OUTPUT}")
  set(DISABLE_FLOATING_POINT_EXCEPTIONS 1)
  include("${VTK_DIR}/vtkTestingRenderingDriver.cmake")
  create_test_sourcelist(sources TestImages${name}.cxx ${ARGN} EXTRA_INCLUDE vtkTestingObjectFactory.h)
  add_executable(TestImages${name} ${sources})
  target_link_libraries(TestImages${name} PRIVATE StrataFilters StrataReaders
    VTK::CommonDataModel VTK::CommonSystem VTK::FiltersCore VTK::FiltersGeometry VTK::FiltersSources VTK::ImagingCore
    VTK::InteractionStyle VTK::IOXML VTK::RenderingFreeType VTK::RenderingOpenGL2 VTK::TestingCore
    VTK::TestingRendering)
  vtk_module_autoinit(TARGETS TestImages${name}
    MODULES VTK::RenderingOpenGL2 VTK::InteractionStyle VTK::RenderingFreeType)

  foreach (file IN LISTS ARGN)
    get_filename_component(test "${file}" NAME_WE)
    # -T must not be the folder of the baselines: a failing run would write over them.
    add_test(NAME "Images.${test}" COMMAND "${STRATA_DISPLAY}" $<TARGET_FILE:TestImages${name}> ${test}
      -D "${PROJECT_SOURCE_DIR}/Data" -T "${STRATA_TEST_OUTPUT}" -V "${STRATA_BASELINES}/${test}.png")
    set_tests_properties("Images.${test}" PROPERTIES ENVIRONMENT "${STRATA_TEST_ENVIRONMENT}" LABELS Images
      TIMEOUT 300 SKIP_RETURN_CODE 125 FAIL_REGULAR_EXPRESSION "${STRATA_FAILURES}")
  endforeach ()
endfunction ()

# A script run by pvpython under a display; it fails by an exception or by an error message of VTK:
# strata_add_python_test(Pipeline test_pipeline.py argument...)
function (strata_add_python_test name script)
  get_filename_component(script "${script}" ABSOLUTE)
  add_test(NAME "Python.${name}"
    COMMAND "${STRATA_DISPLAY}" $<TARGET_FILE:ParaView::pvpython> "${script}" ${ARGN})
  set_tests_properties("Python.${name}" PROPERTIES ENVIRONMENT "${STRATA_TEST_ENVIRONMENT}" LABELS Python
    TIMEOUT 600 FAIL_REGULAR_EXPRESSION "${STRATA_FAILURES}")
endfunction ()
