#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace kerf::python {

/// Converts an object of one of the module's classes, and refuses one that `__new__` made without `__init__`:
/// pybind11 would hand out memory that no constructor has seen.
template <class T>
struct MadeCaster : pybind11::detail::type_caster_base<T> {
  bool load(pybind11::handle from, bool convert) {
    const auto* const type = pybind11::detail::get_type_info(typeid(T));
    if (type != nullptr && PyObject_TypeCheck(from.ptr(), type->type)) {
      auto* const instance = reinterpret_cast<pybind11::detail::instance*>(from.ptr());
      if (instance->get_value_and_holder(type).value_ptr() == nullptr)
        throw pybind11::type_error(std::string(Py_TYPE(from.ptr())->tp_name) +
                                   ".__init__() was not called, so the object cannot be used");
    }
    return pybind11::detail::type_caster_base<T>::load(from, convert);
  }
};

}  // namespace kerf::python

/// Stands at the end of the header that declares a class of the module.
#define KERF_CLASS_OF_PYTHON(Type) \
  template <>                      \
  struct pybind11::detail::type_caster<Type> : kerf::python::MadeCaster<Type> {}
