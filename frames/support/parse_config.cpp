#include "frames/support/parse_config.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <vector>

#include "frames/support/errors.h"
#include "frames/support/suggest.h"

namespace kerf {
namespace {

/// Names come first: an unknown one gets a suggestion, which the core does not make. Of two values of a name
/// the last would win.
void check_names(const std::string& option, std::string_view assignments) {
  std::vector<std::string> names;
  for (const ConfigField& field : config_fields()) names.emplace_back(field.name);
  std::set<std::string_view> given;
  while (!assignments.empty()) {
    const std::string_view assignment = assignments.substr(0, assignments.find(','));
    assignments.remove_prefix(std::min(assignments.size(), assignment.size() + 1));
    const std::string_view name = assignment.substr(0, assignment.find('='));
    if (name.size() == assignment.size()) {
      throw UsageError(option + ": '" + std::string(assignment) +
                       "' is not K=V, for example max_redundancy=0.05");
    }
    if (std::ranges::find(names, name) == names.end()) {
      throw UsageError(option + ": " + unknown_name_message("parameter", name, names));
    }
    if (!given.insert(name).second)
      throw UsageError(option + ": " + std::string(name) + " has two values; leave out one of them");
  }
}

}  // namespace

Config parse_config(std::string_view option, const std::string& text, const Config& defaults) {
  check_names(std::string(option), text);
  try {
    Config config = defaults;
    kerf::apply(config, text);
    return config;
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string(option) + ": " + error.what());
  }
}

}  // namespace kerf
