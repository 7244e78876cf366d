#include "frames/commands/man_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "frames/commands/manual.h"

namespace kerf {

ManCommand::ManCommand(CLI::App& program)
    : program_(program),
      command_(program.add_subcommand("man", "Print the man page: kerf man | man --local-file -")) {}

bool ManCommand::chosen() const { return command_->parsed(); }

void ManCommand::run() const { std::fputs(manual(program_).c_str(), stdout); }

}  // namespace kerf
