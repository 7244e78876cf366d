#pragma once

#include <span>
#include <string>
#include <string_view>

namespace kerf {

/// What exit codes 0 and 1 of a subcommand mean; 2 and 130 mean the same for all (docs/EXIT_CODES.md).
struct ExitMeaning {
  std::string_view command;
  std::string_view holds;
  std::string_view does_not_hold;  ///< empty: the command decides nothing that could fail to hold
};

/// One row for each subcommand.
std::span<const ExitMeaning> exit_meanings();

/// The lines of a subcommand's help. Throws std::logic_error for one that has no row.
std::string exit_help(std::string_view command);

}  // namespace kerf
