#include "frames/commands/command_options.h"

#include <CLI/CLI.hpp>

namespace kerf {

std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  std::vector<const CLI::Option*> options = command.get_options();
  // CLI11 keeps a group as a command without a name.
  for (const CLI::App* group : command.get_subcommands([](const CLI::App*) { return true; })) {
    if (!group->get_name().empty()) continue;
    const std::vector<const CLI::Option*> more = options_of(*group);
    options.insert(options.end(), more.begin(), more.end());
  }
  return options;
}

}  // namespace kerf
