#include "frames/commands/output_option.h"

#include <CLI/CLI.hpp>

namespace kerf {

CLI::Option* add_output(CLI::App& command, const std::string& names, std::string& path,
                        const std::string& meaning, const std::string& type) {
  return command.add_option(names, path, meaning)->type_name(type)->group("Outputs");
}

}  // namespace kerf
