# The Python module: the package kerf/ with its types, and kerf/_kerf, which is made here. In the build folder both lie
# under python/, so that PYTHONPATH=build/release/python finds it without an installation.
# What the program has of scenes and pictures of recordings is compiled once more, as code that can be loaded.
kerf_room(kerf_python FOLDERS python EXCLUDE "/python/module\\.cpp$" SEPARATE "/python/(arrays|queries_of|world)")
target_sources(kerf_python PRIVATE catalog/scene_catalog.cpp
  support/atomic_file.cpp support/outputs.cpp support/suggest.cpp
  sequence/part_recording.cpp sequence/record_run.cpp sequence/recording_file.cpp sequence/recording_picture.cpp)
set_target_properties(kerf_python PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden)
# Also where its headers are compiled alone: types of pybind11 are hidden.
target_compile_options(kerf_python INTERFACE -fvisibility=hidden)
# All of it calls the product, and takes long to compile.
target_compile_options(kerf_python PRIVATE $<$<CONFIG:Release>:-O1>)
target_link_libraries(kerf_python PUBLIC kerf_recording kerf_draw kerf_sims2d kerf_sims3d pybind11::module)

set(python_package ${PROJECT_BINARY_DIR}/python/kerf)
pybind11_add_module(kerf_module NO_EXTRAS python/module.cpp)
set_target_properties(kerf_module PROPERTIES OUTPUT_NAME _kerf LIBRARY_OUTPUT_DIRECTORY ${python_package})
target_compile_options(kerf_module PRIVATE $<$<CONFIG:Release>:-O1>)
target_compile_definitions(kerf_module PRIVATE KERF_VERSION="${PROJECT_VERSION}")
target_link_libraries(kerf_module PRIVATE kerf_python)
target_link_options(kerf_module PRIVATE LINKER:--as-needed LINKER:--exclude-libs,ALL)

file(GLOB python_files CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/python/kerf/*)
set(python_copies)
foreach(file IN LISTS python_files)
  cmake_path(GET file FILENAME name)
  add_custom_command(OUTPUT ${python_package}/${name} DEPENDS ${file}
    COMMAND ${CMAKE_COMMAND} -E copy ${file} ${python_package}/${name} VERBATIM)
  list(APPEND python_copies ${python_package}/${name})
endforeach()
add_custom_target(kerf_python_package ALL DEPENDS kerf_module ${python_copies})

# Where the interpreter looks below /usr/local; the folder's last name is Debian's or Python's. Debian's packages lie in
# lib/python3.
cmake_path(GET Python_SITEARCH FILENAME site_packages)
set(KERF_PYTHON_FOLDER lib/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}/${site_packages}
  CACHE STRING "Where the Python module is installed, below the prefix")
install(TARGETS kerf_module LIBRARY DESTINATION ${KERF_PYTHON_FOLDER}/kerf COMPONENT python)
install(FILES ${python_files} DESTINATION ${KERF_PYTHON_FOLDER}/kerf COMPONENT python)
