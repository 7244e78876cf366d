#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "core/base/config.h"

namespace kerf::python {

/// The parameters of "kerf" or "kerf-paper".
Config config_of_tree(const std::string& tree);

/// `base` with the parameters of None, a mapping by name, or "name=value,...". Throws ValueError that says
/// which parameter cannot be, and what can.
Config config_from(const Config& base, const pybind11::handle& given);

/// All parameters by name; numbers as numbers.
pybind11::dict config_dict(const Config& config);

}  // namespace kerf::python
