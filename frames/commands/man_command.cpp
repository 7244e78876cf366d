#include <cstdio>

#include "frames/commands/command.h"
#include "frames/commands/manual.h"

namespace kerf {
namespace {

class ManCommand final : public Command {
 public:
  explicit ManCommand(CLI::App& program);
  void run() const override;
};

ManCommand::ManCommand(CLI::App& program)
    : Command(program, "man", "Print the man page: kerf man | man --local-file -") {}

void ManCommand::run() const { std::fputs(manual(*command_->get_parent()).c_str(), stdout); }

}  // namespace

AnyCommand make_man_command(CLI::App& program) { return std::make_unique<ManCommand>(program); }

}  // namespace kerf
