#include "frames/support/parse_config.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "core/base/assignments.h"
#include "frames/support/errors.h"
#include "frames/support/suggest.h"

namespace kerf {
namespace {

/// An unknown name gets a suggestion, which the core does not make.
void check_names(std::string_view assignments) {
  std::vector<std::string> names;
  for (const ConfigField& field : config_fields()) names.emplace_back(field.name);
  const std::vector<Assignment> all = parse_assignments(assignments);
  for (const Assignment& given : all)
    if (std::ranges::find(names, given.name) == names.end())
      throw std::invalid_argument(unknown_name_message("parameter", given.name, names));
  refuse_second_values(all);
}

}  // namespace

Config parse_config(std::string_view option, const std::string& text, const Config& defaults) {
  try {
    check_names(text);
    Config config = defaults;
    kerf::apply(config, text);
    return config;
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string(option) + ": " + error.what());
  }
}

}  // namespace kerf
