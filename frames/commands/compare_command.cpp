#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "core/query/compare.h"
#include "frames/commands/command.h"
#include "frames/page/json.h"
#include "frames/sequence/recording_file.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

Json as_json(const RecordingSummary& summary) {
  Json json{{"steps", summary.steps}, {"ended_in_order", summary.complete}};
  for (int op = 0; op < kOperatorCount; ++op)
    json["operators"][std::string(to_string(static_cast<Operator>(op)))] =
        summary.operators[static_cast<std::size_t>(op)];
  json["refused"] = summary.refused;
  json["pairs"] = summary.pairs;
  json["height"] = summary.height;
  json["redundancy"] = summary.redundancy;
  json["median_ms"] = summary.milliseconds;
  json["most_ms"] = summary.most_milliseconds;
  return json;
}

/// A step of an import is the text that its engine gave it, any other one is a number.
Json step_or_null(const std::optional<std::uint32_t>& step, const GivenNames& names) {
  if (!step) return nullptr;
  return names.names_steps() ? Json(names.step(*step)) : Json(*step);
}

template <class Difference>
std::optional<std::uint32_t> step_of(const std::optional<Difference>& difference) {
  return difference ? std::optional(difference->step) : std::nullopt;
}

/// The event in one of the two runs; empty if nothing differs, or the run has nothing more.
std::string text_of(const std::optional<EventDifference>& difference,
                    std::optional<Event> EventDifference::*run, const GivenNames& names) {
  return difference && *difference.*run ? describe(*(*difference.*run), names) : "";
}

/// Empty: nothing is left.
std::string not_compared(const RecordingComparison& comparison, const GivenNames& names) {
  const std::uint32_t last = std::min(comparison.a.steps, comparison.b.steps);
  return comparison.both_unfinished() ? "what came after step " + names.step(last) + " of either" : "";
}

Json as_json(const RecordingComparison& comparison, const GivenNames& a, const GivenNames& b) {
  const auto step = [&a](const std::optional<std::uint32_t>& of) { return step_or_null(of, a); };
  return {{"same", comparison.same()},
          {"first_different",
           {{"requests", step(comparison.requests)},
            {"config", step(comparison.config)},
            {"shapes", step(comparison.shapes)},
            {"state", step(comparison.state)},
            {"pairs", step(comparison.pairs)},
            {"events", step(step_of(comparison.events))},
            {"a_event", text_of(comparison.events, &EventDifference::a, a)},
            {"b_event", text_of(comparison.events, &EventDifference::b, b)},
            {"operators", step(step_of(comparison.operators))},
            {"a_operator", text_of(comparison.operators, &EventDifference::a, a)},
            {"b_operator", text_of(comparison.operators, &EventDifference::b, b)},
            {"theirs", step(step_of(comparison.theirs))},
            {"a_theirs", comparison.theirs ? comparison.theirs->only_a : std::vector<std::string>()},
            {"b_theirs", comparison.theirs ? comparison.theirs->only_b : std::vector<std::string>()},
            {"verdicts", step(comparison.verdicts)},
            {"structures", step(comparison.structures)},
            {"step_names", step(comparison.step_names)}}},
          {"same_object_names", !comparison.object_names},
          {"declared", comparison.declared},
          {"not_compared", not_compared(comparison, a)},
          {"a", as_json(comparison.a)},
          {"b", as_json(comparison.b)}};
}

void print_first(const char* what, const std::optional<std::uint32_t>& step, const GivenNames& names) {
  if (step) {
    std::printf("%-10s differ first in step %s\n", what, names.step(*step).c_str());
  } else {
    std::printf("%-10s are the same\n", what);
  }
}

void print_first(const char* what, const std::optional<EventDifference>& difference, const GivenNames& a,
                 const GivenNames& b) {
  print_first(what, step_of(difference), a);
  if (!difference) return;
  const auto text = [](const std::optional<Event>& event, const GivenNames& names) {
    return event ? describe(*event, names) : "nothing more";
  };
  std::printf("  A: %s\n  B: %s\n", text(difference->a, a).c_str(), text(difference->b, b).c_str());
}

/// The first few pairs that only one of two engines reported.
void print_only(const char* which, const std::vector<std::string>& pairs) {
  constexpr std::size_t kMost = 10;
  if (pairs.empty()) return;
  std::printf("  only %s reported", which);
  for (std::size_t k = 0; k < std::min(kMost, pairs.size()); ++k) std::printf(" (%s)", pairs[k].c_str());
  if (pairs.size() > kMost) std::printf(" and %zu more", pairs.size() - kMost);
  std::printf("\n");
}

/// What only imports have.
void print_theirs(const RecordingComparison& comparison, const GivenNames& names) {
  print_first("names", comparison.step_names, names);
  if (comparison.object_names) std::printf("%-10s of objects differ\n", "names");
  print_first("theirs", step_of(comparison.theirs), names);
  if (comparison.theirs) {
    print_only("A", comparison.theirs->only_a);
    print_only("B", comparison.theirs->only_b);
  }
  print_first("verdicts", comparison.verdicts, names);
  print_first("structures", comparison.structures, names);
}

void print_ends(const RecordingComparison& comparison, const GivenNames& names) {
  const auto text = [](const RecordingSummary& run) { return run.complete ? "yes" : "no"; };
  if (comparison.one_unfinished())
    std::printf("%-10s in order: %s in A, %s in B\n", "ended", text(comparison.a), text(comparison.b));
  const std::string left = not_compared(comparison, names);
  if (!left.empty()) std::printf("not compared: %s, since neither was ended in order\n", left.c_str());
}

void print_figures(const RecordingSummary& a, const RecordingSummary& b) {
  const auto row = [](const char* name, double x, double y) {
    std::printf("%-14s %14.6g %14.6g\n", name, x, y);
  };
  std::printf("%-14s %14s %14s\n", "", "A", "B");
  row("steps", a.steps, b.steps);
  for (int op = 0; op < kOperatorCount; ++op) {
    const auto k = static_cast<std::size_t>(op);
    row(std::string(to_string(static_cast<Operator>(op))).c_str(), static_cast<double>(a.operators[k]),
        static_cast<double>(b.operators[k]));
  }
  row("refused", static_cast<double>(a.refused), static_cast<double>(b.refused));
  row("pairs", static_cast<double>(a.pairs), static_cast<double>(b.pairs));
  row("height", a.height, b.height);
  row("redundancy", a.redundancy, b.redundancy);
  row("ms, median", a.milliseconds, b.milliseconds);
  row("ms, most", a.most_milliseconds, b.most_milliseconds);
}

void print(const RecordingComparison& comparison, const RecordingInfo& a, const RecordingInfo& b) {
  const GivenNames& names = a.names;
  print_first("requests", comparison.requests, names);
  print_first("configs", comparison.config, names);
  print_first("shapes", comparison.shapes, names);
  print_first("events", comparison.events, names, b.names);
  if (comparison.operators && comparison.operators == comparison.events) {
    std::printf("%-10s differ first there, too\n", "operators");
  } else {
    print_first("operators", comparison.operators, names, b.names);
  }
  print_first("trees", comparison.state, names);
  print_first("pairs", comparison.pairs, names);
  if (a.imported || b.imported) print_theirs(comparison, names);
  for (const std::string& line : comparison.declared) std::printf("declared   %s\n", line.c_str());
  print_ends(comparison, names);
  print_figures(comparison.a, comparison.b);
}

class CompareCommand final : public Command {
 public:
  explicit CompareCommand(CLI::App& program);
  void run() const override;

 private:
  std::string a_;
  std::string b_;
  bool json_ = false;
};

CompareCommand::CompareCommand(CLI::App& program)
    : Command(program, "compare", "Find where two recordings first differ") {
  option("A", a_, "A recording", "")->required();
  option("B", b_, "Another, of the same dimension", "")->required();
  command_->add_flag("--json", json_, "As JSON");
}

void CompareCommand::run() const {
  const RecordingComparison comparison =
      with_recording(a_, [&]<int D>(std::shared_ptr<RecordingReader<D>> a) {
        if (read_recording_info(b_).dimension != D)
          throw std::runtime_error(a_ + " and " + b_ + " are not of the same dimension");
        RecordingReader<D> b(b_);
        return compare(*a, b);
      });
  const RecordingInfo a = read_recording_info(a_);
  const RecordingInfo b = read_recording_info(b_);
  if (json_) {
    std::printf("%s\n", json_text(as_json(comparison, a.names, b.names)).c_str());
  } else {
    print(comparison, a, b);
  }
  if (!comparison.same()) throw DoesNotHold("the recordings differ");
}

}  // namespace

AnyCommand make_compare_command(CLI::App& program) { return std::make_unique<CompareCommand>(program); }

}  // namespace kerf
