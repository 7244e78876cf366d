#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "core/base/counted.h"
#include "core/base/poll.h"
#include "core/query/expression_words.h"
#include "core/query/search.h"
#include "core/replay/cursor.h"
#include "frames/commands/command.h"
#include "frames/sequence/recording_file.h"
#include "frames/sequence/recording_picture.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/outputs.h"
#include "frames/support/parse_expression.h"
#include "frames/support/parse_number.h"

namespace kerf {
namespace {

std::string step_footer() {
  std::string text =
      "EXPR    conditions joined by && || ! ( ), for example\n"
      "          op==merge && depth>8      pair(12,77) enters     plane(n17) moves\n"
      "          redundancy>5%             step_time>2*median     deferred>16 || missed>0\n"
      "        Numbers may have units: s, ms, us for times, % for redundancy, balance and quotients. What\n"
      "        concerns events holds right after an event, all else at the end of a step; what an event "
      "does\n"
      "        not have is never true of it.\n"
      "THINGS  pair(i,j), pair(i,j) enters, pair(i,j) leaves, plane(nK) moves, node(nK), object(i) moves\n"
      "\nWORDS\n";
  for (const VariableWord& word : variable_words()) {
    std::string line = "  " + std::string(word.name);
    line.resize(16, ' ');
    text += line + std::string(word.meaning) + "\n";
  }
  return text + "  median        of the steps' times; median(WORD) of any of the steps' words\n";
}

void print_row(const StepRow& row, const GivenNames& names) {
  const Statistics& s = row.statistics;
  std::printf("  step %s: %s, %s, height %u, %s, redundancy %.4f, %u deferred, %.3f ms\n",
              names.step(row.step).c_str(), counted(s.objects, "object").c_str(),
              counted(row.pairs, "pair").c_str(), s.height, counted(s.leaves, "leaf", "leaves").c_str(),
              s.redundancy, s.deferred, 1e3 * row.seconds());
}

/// Those of another engine's pairs of which there is something to be said, a line for each verdict.
template <int D>
void print_theirs(const RecordingReader<D>& recording, std::uint32_t step) {
  constexpr std::size_t kMost = 10;
  std::array<std::vector<Pair>, kVerdicts> by_verdict;
  for (const auto& [pair, verdict] : recording.judged_pairs(step))
    by_verdict[static_cast<std::size_t>(verdict)].push_back(pair);
  for (std::size_t k = 0; k < kVerdicts; ++k) {
    const std::vector<Pair>& pairs = by_verdict[k];
    if (pairs.empty()) continue;
    const auto verdict = static_cast<PairVerdict>(k);
    std::printf("  theirs, %s%s:", is_ignored(verdict) ? "ignored, " : "",
                std::string(to_string(verdict)).c_str());
    for (std::size_t n = 0; n < std::min(kMost, pairs.size()); ++n)
      std::printf(" (%s)", recording.info().names.pair(pairs[n]).c_str());
    if (pairs.size() > kMost) std::printf(" and %zu more", pairs.size() - kMost);
    std::printf("\n");
  }
}

template <int D>
void print_moment(Cursor<D>& cursor, const Position& position) {
  const GivenNames& names = cursor.recording().info().names;
  cursor.go(position);
  if (const auto event = cursor.event()) {
    std::printf("%s\n", describe(*event, names).c_str());
  } else {
    std::printf("%s\n", to_string(position, names).c_str());
  }
  if (position.step > 0) print_row(cursor.recording().row(position.step), names);
  if (position.step > 0 && cursor.recording().info().imported)
    print_theirs(cursor.recording(), position.step);
  std::printf("  state hash %s\n", to_hex(cursor.state().hash()).c_str());
}

struct StepRequest {
  Expression expression;
  std::string from;
  std::uint32_t hits = 1;
  bool reverse = false;
  std::filesystem::path picture;  ///< of the last moment; empty: none
  Replace replace = Replace::nothing;
};

template <int D>
void step(const std::shared_ptr<RecordingReader<D>>& recording, const StepRequest& request) {
  const InterruptGuard interrupt;
  const Polling polling([&] {
    if (interrupt.requested()) throw Interrupted("interrupted");
  });
  const auto progress = [&](std::uint32_t /*step*/) { return !interrupt.requested(); };
  Cursor<D> cursor(recording);
  Search<D> search(recording);
  Position at = Position::end_of(request.reverse ? recording->steps() + 1 : 0);
  if (!request.from.empty()) at = parse_position("--from", request.from, *recording);
  std::uint32_t hit = 0;
  for (; hit < request.hits; ++hit) {
    const auto found = request.reverse ? search.backward(request.expression, at, progress)
                                       : search.forward(request.expression, at, progress);
    poll();
    if (!found && hit > 0) break;
    if (!found)
      throw DoesNotHold("there is no such moment " + std::string(request.reverse ? "before" : "after") + " " +
                        to_string(at, recording->info().names));
    print_moment(cursor, *found);
    at = *found;
  }
  if (hit < request.hits)
    std::fprintf(stderr, "there %s no more, of the %u that were asked for\n",
                 (hit == 1 ? "is one moment and" : "are " + std::to_string(hit) + " moments and").c_str(),
                 request.hits);
  if (!request.picture.empty()) draw_moment(cursor, {1280, 720}, request.picture, request.replace);
}

class StepCommand final : public Command {
 public:
  explicit StepCommand(CLI::App& program);
  void run() const override;

 private:
  std::string file_;
  std::string to_;
  std::string from_;
  std::string hits_;
  std::string picture_;
  bool reverse_ = false;
  bool overwrite_ = false;
};

StepCommand::StepCommand(CLI::App& program)
    : Command(program, "step", "Go to the moment of a recording at which a condition holds") {
  option("FILE", file_, "A recording", "")->required();
  option("--to", to_, "The condition, see below", "EXPR")->required();
  option("--from", from_, "After step N or event eN (default: the beginning)", "N|eN");
  option("--hits", hits_, "How many moments (default 1)", "N");
  output("--picture", picture_, "Draw the last moment found", "FILE.png");
  command_->add_flag("--overwrite", overwrite_, "Replace an earlier picture");
  command_->add_flag("--reverse", reverse_, "Backwards, from --from or the end");
  command_->footer(step_footer());
}

void StepCommand::run() const {
  Outputs outputs({file_}, overwrite_);
  if (!picture_.empty() && !picture_.ends_with(".png"))
    throw UsageError("--picture '" + picture_ + "': call the picture something.png");
  outputs.add_file(picture_);
  StepRequest request{parse_expression("--to", to_), from_, 1, reverse_, picture_, outputs.replace()};
  if (!hits_.empty()) request.hits = parse_whole("--hits", hits_, 1U, UINT32_MAX);
  with_recording(file_, [&](auto recording) { step(recording, request); });
}

}  // namespace

AnyCommand make_step_command(CLI::App& program) { return std::make_unique<StepCommand>(program); }

}  // namespace kerf
