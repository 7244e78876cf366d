#pragma once

#include <string>

namespace CLI {
class App;
}

namespace kerf {

/// The man page of a program, section 1, in roff, from what its `--help` says.
std::string manual(const CLI::App& program);

}  // namespace kerf
