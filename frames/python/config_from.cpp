#include "frames/python/config_from.h"

#include "frames/catalog/algorithm.h"

namespace kerf::python {
namespace {

namespace py = pybind11;

/// Truth values are 0 and 1 in texts.
std::string value_text(const py::handle& value) {
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "1" : "0";
  return py::str(value);
}

bool is_mapping(const py::handle& given) {
  const py::object mapping = py::module_::import("collections.abc").attr("Mapping");
  return py::isinstance(given, mapping);
}

}  // namespace

Config config_of_tree(const std::string& tree) {
  if (tree == kTunedTree) return tuned_config();
  if (tree == kPaperTree) return {};
  throw py::value_error("tree: '" + tree + "' is neither 'kerf' nor 'kerf-paper'");
}

Config config_from(const Config& base, const py::handle& given) {
  Config config = base;
  if (given.is_none()) return config;
  if (py::isinstance<py::str>(given)) {
    kerf::apply(config, given.cast<std::string>());
  } else if (is_mapping(given)) {
    for (const auto& [name, value] : py::dict(py::reinterpret_borrow<py::object>(given)))
      kerf::set(config, py::str(name).cast<std::string>(), value_text(value));
  } else {
    throw py::value_error(
        "config: give a dict such as {'max_threshold': 256}, or a text 'max_threshold=256'");
  }
  check(config);
  return config;
}

py::dict config_dict(const Config& config) {
  py::dict all;
  for (const ConfigField& field : config_fields()) {
    const std::string text = get(config, field.name);
    const bool whole = text.find_first_not_of("0123456789") == std::string::npos;
    all[py::str(std::string(field.name))] =
        whole ? py::object(py::int_(py::str(text))) : py::object(py::float_(py::str(text)));
  }
  return all;
}

}  // namespace kerf::python
