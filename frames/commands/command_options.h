#pragma once

#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace kerf {

/// The options and arguments of a command, those of its option groups, too.
std::vector<const CLI::Option*> options_of(const CLI::App& command);

}  // namespace kerf
