#include <cstdio>
#include <string>

#include "frames/commands/command.h"
#include "frames/commands/completion.h"

namespace kerf {
namespace {

class CompletionCommand final : public Command {
 public:
  explicit CompletionCommand(CLI::App& program);
  void run() const override;

 private:
  std::string shell_;
};

CompletionCommand::CompletionCommand(CLI::App& program)
    : Command(program, "completion", "Print a script that completes commands and options in a shell") {
  command_->add_option("SHELL", shell_, "bash: source <(kerf completion bash); zsh; fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
}

void CompletionCommand::run() const {
  std::fputs(completion(*command_->get_parent(), shell_).c_str(), stdout);
}

}  // namespace

AnyCommand make_completion_command(CLI::App& program) { return std::make_unique<CompletionCommand>(program); }

}  // namespace kerf
