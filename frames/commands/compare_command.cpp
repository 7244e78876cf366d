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
          {"a_only_steps", comparison.steps_only_a},
          {"b_only_steps", comparison.steps_only_b},
          {"a_only_objects", comparison.objects_only_a},
          {"b_only_objects", comparison.objects_only_b},
          {"declared", comparison.declared},
          {"not_compared", not_compared(comparison, a)},
          {"a", as_json(comparison.a)},
          {"b", as_json(comparison.b)}};
}

/// The first few of what only one of two has.
void print_only(const char* before, const std::vector<std::string>& all) {
  constexpr std::size_t kMost = 10;
  if (all.empty()) return;
  std::printf("%s", before);
  for (std::size_t k = 0; k < std::min(kMost, all.size()); ++k) std::printf(" %s", all[k].c_str());
  if (all.size() > kMost) std::printf(" and %zu more", all.size() - kMost);
  std::printf("\n");
}

/// The lines that say where two recordings first differ.
class FirstLines {
 public:
  FirstLines(const RecordingComparison& comparison, const RecordingInfo& a, const RecordingInfo& b)
      : comparison_(comparison), a_(a), b_(b) {}

  void print() const {
    print_only("steps      only A has", comparison_.steps_only_a);
    print_only("steps      only B has", comparison_.steps_only_b);
    print_only("objects    only A names", comparison_.objects_only_a);
    print_only("objects    only B names", comparison_.objects_only_b);
    line("requests", comparison_.requests);
    line("configs", comparison_.config);
    line("shapes", comparison_.shapes);
    line("events", comparison_.events);
    if (comparison_.operators && comparison_.operators == comparison_.events) {
      std::printf("%-10s differ first there, too\n", "operators");
    } else {
      line("operators", comparison_.operators);
    }
    line("trees", comparison_.state);
    line("pairs", comparison_.pairs);
    if (a_.imported || b_.imported) print_theirs();
  }

 private:
  void line(const char* what, const std::optional<std::uint32_t>& step) const {
    if (step) {
      std::printf("%-10s differ first in step %s\n", what, a_.names.step(*step).c_str());
    } else {
      std::printf("%-10s %s\n", what, comparison_.same_words());
    }
  }

  void line(const char* what, const std::optional<EventDifference>& difference) const {
    line(what, step_of(difference));
    if (!difference) return;
    const auto text = [](const std::optional<Event>& event, const GivenNames& names) {
      return event ? describe(*event, names) : "nothing more";
    };
    std::printf("  A: %s\n  B: %s\n", text(difference->a, a_.names).c_str(),
                text(difference->b, b_.names).c_str());
  }

  /// What only imports have.
  void print_theirs() const {
    line("names", comparison_.step_names);
    if (comparison_.object_names) std::printf("%-10s of objects differ\n", "names");
    line("theirs", step_of(comparison_.theirs));
    if (comparison_.theirs) {
      print_only("  only A reported", in_brackets(comparison_.theirs->only_a));
      print_only("  only B reported", in_brackets(comparison_.theirs->only_b));
    }
    line("verdicts", comparison_.verdicts);
    line("structures", comparison_.structures);
  }

  static std::vector<std::string> in_brackets(std::vector<std::string> pairs) {
    for (std::string& pair : pairs) pair = "(" + pair + ")";
    return pairs;
  }

  const RecordingComparison& comparison_;
  const RecordingInfo& a_;
  const RecordingInfo& b_;
};

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
  FirstLines(comparison, a, b).print();
  for (const std::string& line : comparison.declared) std::printf("declared   %s\n", line.c_str());
  print_ends(comparison, a.names);
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
