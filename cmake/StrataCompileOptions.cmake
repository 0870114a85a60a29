# Warnings for our own targets; errors where Strata is built by itself.
option(STRATA_WERROR "Treat warnings in Strata's own code as errors" ${PROJECT_IS_TOP_LEVEL})
set(STRATA_WARNINGS -Wall -Wextra -Wpedantic -Wshadow)
if (STRATA_WERROR)
  list(APPEND STRATA_WARNINGS -Werror)
endif ()
# VTK's class macros, which are written with a semicolon, don't pass -Wpedantic.
set(STRATA_VTK_WARNINGS ${STRATA_WARNINGS} -Wno-pedantic)

function (strata_compile_options target)
  target_compile_options(${target} PRIVATE ${STRATA_WARNINGS})
endfunction ()

# One test program per stage: strata_add_core_test(Slice TestSlice.cpp ...)
function (strata_add_core_test stage)
  add_executable(Test${stage} ${ARGN})
  target_link_libraries(Test${stage} PRIVATE StrataCore StrataTestSupport GTest::gtest_main)
  strata_compile_options(Test${stage})
  gtest_discover_tests(Test${stage} TEST_PREFIX "Core." DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS Core TIMEOUT 300)
endfunction ()
