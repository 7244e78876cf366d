#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>

#include "core/base/counted.h"
#include "core/query/their_faults.h"
#include "core/query/thrash.h"
#include "frames/commands/command.h"
#include "frames/sequence/recording_file.h"
#include "frames/support/errors.h"
#include "frames/support/parse_number.h"

namespace kerf {
namespace {

/// "0.3" or "30%"
double parse_share(const std::string& text) {
  const bool is_percent = text.ends_with('%');
  const auto number =
      parse_number<double>(std::string_view(text).substr(0, text.size() - (is_percent ? 1 : 0)));
  if (!number || !std::isfinite(*number))
    throw UsageError("--overlap '" + text + "' is no share such as 0.3 or 30%");
  if (!is_percent && *number > 1)
    throw UsageError("--overlap '" + text + "' is more than all of a box; do you mean '" + text + "%'?");
  return is_percent ? *number / 100 : *number;
}

StructureLimits parse_limits(const std::string& depth, const std::string& overlap,
                             const std::string& margin) {
  StructureLimits limits;
  if (!depth.empty()) limits.depth = parse_whole("--depth", depth, 0U, UINT32_MAX);
  if (!overlap.empty()) limits.overlap = parse_share(overlap);
  if (!margin.empty()) {
    const auto given = parse_number<Scalar>(margin);
    if (!given || !std::isfinite(*given))
      throw UsageError("--margin '" + margin + "' is no length such as 0.05");
    limits.margin = *given;
  }
  return limits;
}

class LintCommand final : public Command {
 public:
  explicit LintCommand(CLI::App& program);
  void run() const override;

 private:
  /// How many were found and printed.
  [[nodiscard]] std::size_t lint_operators() const;
  [[nodiscard]] std::size_t lint_structure() const;

  std::string file_;
  std::string within_;
  std::string depth_;
  std::string overlap_;
  std::string margin_;
  bool structure_ = false;
};

LintCommand::LintCommand(CLI::App& program)
    : Command(
          program, "lint",
          "Find operators that undo each other, or wait for ever; or faults of another engine's structure") {
  option("FILE", file_, "A recording", "")->required();
  auto* const within =
      option("--within", within_, "What counts as thrashing happens in so many steps (default 50)", "STEPS");
  auto* const structure = command_->add_flag(
      "--structure", structure_, "Check the other engine's structure instead, see `kerf import --structure`");
  structure->excludes(within);
  const auto limit = [&](const char* name, std::string& text, const char* meaning, const char* type) {
    command_->add_option(name, text, meaning)->type_name(type)->needs(structure);
  };
  limit("--depth", depth_, "Find deeper nodes, too; a root has depth 0", "N");
  limit("--overlap", overlap_, "Find siblings that share more of their parent's box, too", "X|N%");
  limit("--margin", margin_, "Find leaves that leave less around their objects where they are placed, too",
        "X");
  command_->footer(
      "FINDS   a node that was split, merged and split again; a partitioner that was balanced one way, back\n"
      "        and again; an operator that was listed and waited for longer\n"
      "        With --structure: a child outside its parent; an object outside its node, in none or in two;\n"
      "        a node with two parents, or to which no way leads; a leaf without objects; a margin smaller\n"
      "        than claimed");
}

void LintCommand::run() const {
  const std::size_t found = structure_ ? lint_structure() : lint_operators();
  if (found > 0) throw DoesNotHold(std::to_string(found) + " found");
  if (!structure_) std::puts("nothing undoes itself, and nothing waits");
}

std::size_t LintCommand::lint_operators() const {
  const std::uint32_t within = within_.empty() ? 50 : parse_whole("--within", within_, 1U, UINT32_MAX);
  return with_recording(file_, [&](const auto& recording) {
    const auto cases = find_thrash(recording->operators(), recording->steps(), within);
    for (const Thrash& thrash : cases)
      std::printf("e%llu  %s\n", static_cast<unsigned long long>(thrash.event),
                  to_text(thrash, recording->info().names).c_str());
    return cases.size();
  });
}

std::size_t LintCommand::lint_structure() const {
  const StructureLimits limits = parse_limits(depth_, overlap_, margin_);
  return with_recording(file_, [&]<int D>(const std::shared_ptr<RecordingReader<D>>& recording) {
    if (recording->structure_steps().empty())
      throw UsageError(file_ + " has no structure of another engine; `kerf import --structure` brings one");
    Replayer<D> replayer(recording);
    const auto faults = find_their_faults<D>(replayer, limits);
    for (const TheirFault& fault : faults)
      std::printf("%s\n", to_text(fault, recording->info().names).c_str());
    if (faults.empty())
      std::printf("the structure is sound in the %zu of %s in which it is known\n",
                  recording->structure_steps().size(), counted(recording->steps(), "step").c_str());
    return faults.size();
  });
}

}  // namespace

AnyCommand make_lint_command(CLI::App& program) { return std::make_unique<LintCommand>(program); }

}  // namespace kerf
