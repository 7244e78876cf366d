#include "frames/commands/completion_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "frames/commands/completion.h"

namespace kerf {

CompletionCommand::CompletionCommand(CLI::App& program)
    : program_(program),
      command_(program.add_subcommand("completion",
                                      "Print a script that completes commands and options in a shell")) {
  command_->add_option("SHELL", shell_, "bash: source <(kerf completion bash); zsh; fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
}

bool CompletionCommand::chosen() const { return command_->parsed(); }

void CompletionCommand::run() const { std::fputs(completion(program_, shell_).c_str(), stdout); }

}  // namespace kerf
