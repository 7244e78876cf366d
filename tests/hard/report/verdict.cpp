#include "tests/hard/report/verdict.h"

#include <array>

namespace kerf::test {
namespace {

/// 7, 42, 950, 1k, 42k, 3M, 2G: at most three characters and a unit.
std::string short_number(std::uint64_t n) {
  constexpr std::string_view kUnits = " kMGTPE";
  std::size_t unit = 0;
  while (n >= 1000) {
    n /= 1000;
    ++unit;
  }
  std::string text = std::to_string(n);
  if (unit > 0) text += kUnits[unit];
  return text;
}

}  // namespace

std::string_view to_string(Verdict verdict) {
  constexpr std::array<std::string_view, kVerdictCount> kNames{"n.a.",   "exact",  "extra",    "twice",
                                                               "broken", "missed", "time-out", "crash"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::uint64_t Outcome::count() const {
  switch (verdict) {
    case Verdict::extra:
      return trial.extra;
    case Verdict::twice:
      return trial.twice;
    case Verdict::broken:
      return trial.statuses + trial.violations;
    case Verdict::missed:
      return trial.missed;
    default:
      return 0;
  }
}

Verdict judge(const Trial& trial, bool extra_allowed) {
  if (trial.missed > 0) return Verdict::missed;
  if (trial.statuses + trial.violations > 0) return Verdict::broken;
  if (trial.twice > 0) return Verdict::twice;
  return trial.extra > 0 && !extra_allowed ? Verdict::extra : Verdict::exact;
}

Outcome worse(const Outcome& a, const Outcome& b) {
  if (a.verdict == Verdict::not_applicable) return b;
  if (b.verdict == Verdict::not_applicable) return a;
  Outcome result = a.verdict < b.verdict ? b : a;
  result.trial = worse(a.trial, b.trial);
  return result;
}

std::string symbol(const Outcome& outcome) {
  switch (outcome.verdict) {
    case Verdict::not_applicable:
      return "";
    case Verdict::exact:
      return "=";
    case Verdict::extra:
      return "+" + short_number(outcome.count());
    case Verdict::twice:
      return "2x" + short_number(outcome.count());
    case Verdict::broken:
      return "!" + short_number(outcome.count());
    case Verdict::missed:
      return "-" + short_number(outcome.count());
    case Verdict::time_out:
      return outcome.inferred ? "t" : "T";
    case Verdict::crash:
      return "X";
  }
  return "";
}

}  // namespace kerf::test
