# The Python module as users import it: one test a file, by pytest.
file(GLOB python_tests CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/python/*_test.py)
foreach(file IN LISTS python_tests)
  cmake_path(GET file STEM name)
  string(REPLACE "_test" "" name ${name})
  add_test(NAME Python.${name} COMMAND ${Python_EXECUTABLE} -m pytest -q
    -c ${CMAKE_CURRENT_SOURCE_DIR}/python/pytest.ini ${file})
  set_tests_properties(Python.${name} PROPERTIES TIMEOUT 600 ENVIRONMENT
    "PYTHONPATH=${PROJECT_BINARY_DIR}/python;PYTHONDONTWRITEBYTECODE=1;KERF_SOURCE_DIR=${PROJECT_SOURCE_DIR};KERF_BUILD_DIR=${PROJECT_BINARY_DIR}")
endforeach()

# What a step costs through Python, beside the same step in C++: tests/bench/python_overhead.py, run by hand.
pybind11_add_module(kerf_python_steps NO_EXTRAS bench/python_steps.cpp)
set_target_properties(kerf_python_steps PROPERTIES OUTPUT_NAME kerf_steps
  LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests/python)
target_link_libraries(kerf_python_steps PRIVATE kerf_bsp)
