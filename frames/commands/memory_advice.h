#pragma once

#include <string>
#include <string_view>

namespace kerf {

/// The message of a subcommand for which memory did not suffice: what would need less.
std::string out_of_memory(std::string_view command);

}  // namespace kerf
