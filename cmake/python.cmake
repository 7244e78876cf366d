# What the Python module is built for. Its packages are Debian's, so the interpreter is, too, unless
# -DPython_EXECUTABLE names another one.
if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)
endif()
set(PYBIND11_FINDPYTHON ON)
find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module NumPy)
find_package(pybind11 2.10 QUIET CONFIG)
if(NOT Python_FOUND OR NOT pybind11_FOUND)
  message(FATAL_ERROR "The Python module needs pybind11 and numpy (Debian: pybind11-dev, python3-dev, python3-numpy): "
    "install them, or configure with -DKERF_PYTHON=OFF")
endif()
