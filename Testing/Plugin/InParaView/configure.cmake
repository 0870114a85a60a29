# cmake -DSTRATA=<root of the project> -DFOLDER=<work folder> -DPYTHON=<interpreter> -P configure.cmake
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}/Plugins")
file(COPY "${CMAKE_CURRENT_LIST_DIR}/CMakeLists.txt" DESTINATION "${FOLDER}")
file(CREATE_LINK "${STRATA}" "${FOLDER}/Plugins/Strata" SYMBOLIC)
execute_process(COMMAND_ERROR_IS_FATAL ANY COMMAND "${CMAKE_COMMAND}" -S "${FOLDER}" -B "${FOLDER}/build" -G Ninja
  "-DPython3_EXECUTABLE=${PYTHON}")
