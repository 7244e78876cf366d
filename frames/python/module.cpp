#include "frames/python/bindings.h"

// kerf._kerf: what kerf/__init__.py makes public.
PYBIND11_MODULE(_kerf, module) {
  module.attr("__version__") = KERF_VERSION;
  kerf::python::bind_broad_phase(module);
  kerf::python::bind_recording(module);
  kerf::python::bind_check(module);
  kerf::python::bind_world(module);
  kerf::python::bind_pictures(module);
}
