#include "frames/commands/step_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <stdexcept>

#include "core/query/expression_words.h"
#include "core/query/search.h"
#include "core/replay/cursor.h"
#include "frames/sequence/recording_file.h"
#include "frames/sequence/recording_picture.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/parse_expression.h"
#include "frames/support/parse_number.h"

namespace kerf {
namespace {

std::string step_footer() {
  std::string text =
      "EXPR    conditions joined by && || ! ( ), for example\n"
      "          op==merge && depth>8      pair(12,77) enters     plane(n17) moves\n"
      "          redundancy>5%             step_time>2*median     deferred>16 || missed>0\n"
      "        Numbers may have the units s, ms, us and %. What speaks of events holds right after an event, "
      "all\n"
      "        else at the end of a step; what an event does not have is never true of it.\n"
      "THINGS  pair(i,j), pair(i,j) enters, pair(i,j) leaves, plane(nK) moves, node(nK), object(i) moves\n"
      "\nWORDS\n";
  for (const VariableWord& word : variable_words()) {
    std::string line = "  " + std::string(word.name);
    line.resize(16, ' ');
    text += line + std::string(word.meaning) + "\n";
  }
  return text + "  median        of the steps' times; median(WORD) of any of the steps' words\n";
}

void print_row(const StepRow& row) {
  const Statistics& s = row.statistics;
  std::printf(
      "  step %u: %u objects, %llu pairs, height %u, %u leaves, redundancy %.4f, %u deferred, %.3f ms\n",
      row.step, s.objects, static_cast<unsigned long long>(row.pairs), s.height, s.leaves, s.redundancy,
      s.deferred, 1e3 * row.seconds());
}

template <int D>
void print_moment(Cursor<D>& cursor, const Position& position) {
  cursor.go(position);
  if (const auto event = cursor.event()) {
    std::printf("%s\n", describe(*event).c_str());
  } else {
    std::printf("%s\n", to_string(position).c_str());
  }
  if (position.step > 0) print_row(cursor.recording().row(position.step));
  std::printf("  state hash %s\n", to_hex(cursor.state().hash()).c_str());
}

struct StepRequest {
  Expression expression;
  std::string from;
  std::uint32_t hits = 1;
  bool reverse = false;
  std::filesystem::path picture;  ///< of the last moment; empty: none
};

template <int D>
void step(const std::shared_ptr<RecordingReader<D>>& recording, const StepRequest& request) {
  const InterruptGuard interrupt;
  const auto progress = [&](std::uint32_t /*step*/) { return !interrupt.requested(); };
  Cursor<D> cursor(recording);
  Search<D> search(recording);
  Position at = Position::end_of(request.reverse ? recording->steps() + 1 : 0);
  if (!request.from.empty()) at = parse_position("--from", request.from, *recording);
  for (std::uint32_t hit = 0; hit < request.hits; ++hit) {
    const auto found = request.reverse ? search.backward(request.expression, at, progress)
                                       : search.forward(request.expression, at, progress);
    if (interrupt.requested()) throw Interrupted("interrupted");
    if (!found && hit > 0) break;
    if (!found)
      throw DoesNotHold("there is no such moment " + std::string(request.reverse ? "before" : "after") + " " +
                        to_string(at));
    print_moment(cursor, *found);
    at = *found;
  }
  if (!request.picture.empty()) draw_moment(cursor, {1280, 720}, request.picture);
}

}  // namespace

StepCommand::StepCommand(CLI::App& program)
    : command_(program.add_subcommand("step", "Go to the moment of a recording at which a condition holds")) {
  command_->add_option("FILE", file_, "A recording")->type_name("")->required();
  command_->add_option("--to", to_, "The condition, see below")->type_name("EXPR")->required();
  command_->add_option("--from", from_, "After step N or event eN (default: the beginning)")
      ->type_name("N|eN");
  command_->add_option("--hits", hits_, "How many moments (default 1)")->type_name("N");
  command_->add_option("--picture", picture_, "Draw the last moment found")->type_name("FILE.png");
  command_->add_flag("--reverse", reverse_, "Backwards, from --from or the end");
  command_->footer(step_footer());
}

bool StepCommand::chosen() const { return command_->parsed(); }

void StepCommand::run() const {
  StepRequest request{parse_expression("--to", to_), from_, 1, reverse_, picture_};
  if (!hits_.empty()) {
    const auto hits = parse_number<std::uint32_t>(hits_);
    if (!hits || *hits == 0) throw UsageError("--hits '" + hits_ + "' is no whole number from 1 up");
    request.hits = *hits;
  }
  with_recording(file_, [&](auto recording) { step(recording, request); });
}

}  // namespace kerf
