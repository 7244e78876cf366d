#include "frames/commands/lint_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <stdexcept>

#include "core/query/thrash.h"
#include "frames/sequence/recording_file.h"
#include "frames/support/errors.h"
#include "frames/support/parse_number.h"

namespace kerf {

LintCommand::LintCommand(CLI::App& program)
    : command_(program.add_subcommand("lint", "Find operators that undo each other, or wait for ever")) {
  command_->add_option("FILE", file_, "A recording")->type_name("")->required();
  command_->add_option("--within", within_, "What counts as thrashing happens in so many steps (default 50)")
      ->type_name("STEPS");
  command_->footer(
      "FINDS   a node that was split, merged and split again; a partitioner that was balanced one way, back\n"
      "        and again; an operator that was listed and waited for longer");
}

bool LintCommand::chosen() const { return command_->parsed(); }

void LintCommand::run() const {
  std::uint32_t within = 50;
  if (!within_.empty()) {
    const auto given = parse_number<std::uint32_t>(within_);
    if (!given || *given == 0) throw UsageError("--within '" + within_ + "' is no whole number from 1 up");
    within = *given;
  }
  const std::size_t found = with_recording(file_, [&](const auto& recording) {
    const auto cases = find_thrash(recording->operators(), recording->steps(), within);
    for (const Thrash& thrash : cases)
      std::printf("e%llu  %s\n", static_cast<unsigned long long>(thrash.event),
                  to_text(thrash, recording->info().names).c_str());
    return cases.size();
  });
  if (found > 0) throw DoesNotHold(std::to_string(found) + " found");
  std::printf("nothing undoes itself, and nothing waits\n");
}

}  // namespace kerf
