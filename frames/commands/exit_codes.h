#pragma once

#include <span>
#include <string>
#include <string_view>

namespace kerf {

/// What exit codes 0 and 1 of a subcommand say; 2 and 130 say the same of all (docs/EXIT_CODES.md).
struct ExitMeaning {
  std::string_view command;
  std::string_view holds;
  std::string_view does_not_hold;  ///< empty: the command asks nothing that could be answered with no
};

/// One row for each subcommand.
std::span<const ExitMeaning> exit_meanings();

/// The lines of a subcommand's help. Throws std::logic_error for one that has no row.
std::string exit_help(std::string_view command);

/// The table of docs/EXIT_CODES.md.
std::string exit_table();

}  // namespace kerf
