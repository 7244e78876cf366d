#pragma once

#include <string>

namespace CLI {
class App;
}

namespace kerf {

/// A script with which a shell completes commands and options of a program, and names of files elsewhere:
/// "bash", "zsh" or "fish". Throws std::logic_error for another shell.
std::string completion(const CLI::App& program, const std::string& shell);

}  // namespace kerf
