#pragma once

namespace kerf {

/// The program `kerf`: parses, runs a subcommand, prints errors to standard error.
/// Returns the exit code (see frames/support/errors.h).
int run_command_line(int argc, char** argv);

}  // namespace kerf
