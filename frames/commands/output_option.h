#pragma once

#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace kerf {

/// Adds an option that says where a command writes to. The help shows such options in a group of their own,
/// by which a test finds them all and holds each against the rules of Outputs.
CLI::Option* add_output(CLI::App& command, const std::string& names, std::string& path,
                        const std::string& meaning, const std::string& type = "FILE");

}  // namespace kerf
