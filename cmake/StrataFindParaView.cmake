# Finds an installed ParaView. To be included by the root CMakeLists.txt: imported targets resolve what they
# link to in the directory that imported them.

# Targets of Debian's VTK link to these two, but a search for components doesn't look for them.
find_package(MPI REQUIRED COMPONENTS C)
find_package(Python3 REQUIRED COMPONENTS Interpreter Development)
# Without components ParaView asks for the development files of all that it was built with (GDAL, FFmpeg, ...).
find_package(ParaView 5.11 REQUIRED COMPONENTS VTKExtensionsCore RemotingViews)
find_package(nlohmann_json 3 REQUIRED)

if (BUILD_TESTING)
  find_package(VTK REQUIRED
    COMPONENTS CommonSystem FiltersCore FiltersExtraction FiltersGeometry FiltersModeling FiltersSources ImagingCore
               InteractionStyle IOLegacy IOXML RenderingFreeType RenderingOpenGL2 TestingCore TestingRendering
    PATHS "${ParaView_DIR}/vtk" NO_DEFAULT_PATH)
endif ()
