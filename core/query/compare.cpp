#include "core/query/compare.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <utility>

#include "core/base/counted.h"
#include "core/base/float_mode.h"
#include "core/base/median.h"
#include "core/base/shortest_text.h"
#include "core/recording/shape_rows.h"
#include "core/trace/event_facts.h"

namespace kerf {
namespace {

RecordingSummary summary(std::span<const StepRow> rows, bool complete) {
  RecordingSummary result;
  result.complete = complete;
  result.steps = static_cast<std::uint32_t>(rows.size());
  if (rows.empty()) return result;
  result.operators = rows.back().statistics.operators;
  result.refused = rows.back().statistics.refused;
  std::vector<double> times;
  for (const StepRow& row : rows) {
    result.pairs += row.pairs;
    result.height = std::max(result.height, row.statistics.height);
    result.redundancy += row.statistics.redundancy / static_cast<double>(rows.size());
    times.push_back(1e3 * row.seconds());
  }
  result.milliseconds = median(times);
  result.most_milliseconds = std::ranges::max(times);
  return result;
}

/// The same bits: NaN equals itself.
template <int D>
bool same_boxes(const std::vector<Box<D>>& a, const std::vector<Box<D>>& b) {
  return std::ranges::equal(a, b, [](const Box<D>& x, const Box<D>& y) {
    for (int axis = 0; axis < D; ++axis)
      if (std::bit_cast<std::uint32_t>(x.min[axis]) != std::bit_cast<std::uint32_t>(y.min[axis]) ||
          std::bit_cast<std::uint32_t>(x.max[axis]) != std::bit_cast<std::uint32_t>(y.max[axis]))
        return false;
    return true;
  });
}

template <int D>
bool same_requests(const StepRequests<D>& a, const StepRequests<D>& b) {
  return a.calls == b.calls && a.objects == b.objects && same_boxes(a.boxes, b.boxes) && a.extra == b.extra;
}

/// Each with its shape itself: a recording numbers its shapes as they come.
template <int D>
bool same_looks(const std::vector<LookChange<D>>& a, const std::vector<Shape<D>>& a_shapes,
                const std::vector<LookChange<D>>& b, const std::vector<Shape<D>>& b_shapes) {
  const auto text = [](const Look<D>& look, const std::vector<Shape<D>>& shapes) {
    return look.shape == kNoShape ? ShapeText() : encode_shape<D>(shapes[look.shape]);
  };
  return std::ranges::equal(a, b, [&](const LookChange<D>& x, const LookChange<D>& y) {
    return x.object == y.object && x.look.turn == y.look.turn && x.look.stretch == y.look.stretch &&
           text(x.look, a_shapes) == text(y.look, b_shapes);
  });
}

std::optional<EventDifference> first_difference(const std::vector<Event>& a, const std::vector<Event>& b,
                                                bool (*counts)(const Event&)) {
  auto in_a = a.begin();
  auto in_b = b.begin();
  for (;; ++in_a, ++in_b) {
    in_a = std::find_if(in_a, a.end(), counts);
    in_b = std::find_if(in_b, b.end(), counts);
    if (in_a == a.end() || in_b == b.end() || in_a->body != in_b->body) break;
  }
  if (in_a == a.end() && in_b == b.end()) return std::nullopt;
  EventDifference difference;
  if (in_a != a.end()) difference.a = *in_a;
  if (in_b != b.end()) difference.b = *in_b;
  difference.step = difference.a ? difference.a->step : difference.b->step;
  return difference;
}

bool is_event(const Event& /*any*/) { return true; }

using NamedPair = std::pair<GivenId, GivenId>;

/// Each as often as it was reported, sorted.
std::vector<NamedPair> named(const std::vector<Pair>& pairs, const GivenNames& names) {
  std::vector<NamedPair> result;
  for (const Pair& pair : pairs)
    result.emplace_back(std::minmax({names.object_id(pair.a), names.object_id(pair.b)}));
  std::ranges::sort(result);
  return result;
}

std::vector<std::string> only_in(const std::vector<NamedPair>& a, const std::vector<NamedPair>& b) {
  std::vector<NamedPair> only;
  std::ranges::set_difference(a, b, std::back_inserter(only));
  std::vector<std::string> texts;
  for (const auto& [first, second] : only) texts.push_back(to_string(first) + "," + to_string(second));
  return texts;
}

template <int D>
std::optional<TheirDifference> their_difference(const RecordingReader<D>& a, const RecordingReader<D>& b,
                                                std::uint32_t step) {
  const std::vector<NamedPair> of_a = named(a.their_pairs(step), a.info().names);
  const std::vector<NamedPair> of_b = named(b.their_pairs(step), b.info().names);
  if (of_a == of_b && a.their_step(step).has_value() == b.their_step(step).has_value()) return std::nullopt;
  return TheirDifference{step, only_in(of_a, of_b), only_in(of_b, of_a)};
}

std::string margin_text(const Margin& margin) {
  std::string text = margin.absolute != 0 ? shortest_text(margin.absolute) : "";
  if (margin.share != 0)
    text += (text.empty() ? "" : " and ") + shortest_text(margin.share) + " of the extent";
  return text.empty() ? "none" : text;
}

std::string rounding_text(const BoundRounding& rounding) {
  if (rounding == BoundRounding{}) return "none";
  std::string axes;
  for (unsigned axis = 0; axis < 3; ++axis)
    if ((rounding.planes >> axis & 1U) != 0)
      axes += (axes.empty() ? "" : " and ") + std::string(1, static_cast<char>('x' + axis));
  return "to " + to_text(rounding) + (rounding.floats ? " of floats" : "") +
         (axes.empty() ? "" : " with all boxes flat along " + axes);
}

std::string digits_text(const std::optional<TheirDigits>& digits) {
  if (!digits) return "not known";
  const auto text = [](const WrittenDigits& written) {
    return counted(written.significant, "digit") + " with " + counted(written.decimals, "decimal") +
           (written.coarse ? ", too few," : "");
  };
  return text(digits->boxes) + " of boxes and " + text(digits->nodes) + " of nodes";
}

/// That of the first one which the other recording does not have.
std::string decision_text(const std::vector<Decision>& decisions, std::size_t at) {
  if (at >= decisions.size()) return at == 0 ? "none" : "no other";
  const Decision& decision = decisions[at];
  const std::string event = "e" + std::to_string(decision.event);
  if (!decision.plane) return event + " refused";
  return event + " takes direction " + std::to_string(decision.plane->direction) + " at " +
         shortest_text(decision.plane->offset);
}

std::string or_own(std::uint32_t number) { return number == 0 ? "the scene's own" : std::to_string(number); }

/// By their names, since a recording numbers its objects as they come.
void compare_ignored(const RecordingInfo& a, const RecordingInfo& b, std::vector<std::string>& lines) {
  const std::vector<NamedPair> of_a = named(a.design.ignored, a.names);
  const std::vector<NamedPair> of_b = named(b.design.ignored, b.names);
  const auto add = [&](const std::vector<std::string>& only, const char* which) {
    if (!only.empty())
      lines.push_back("ignored pairs: only " + std::string(which) + " has (" + only.front() + ")" +
                      (only.size() > 1 ? " and " + std::to_string(only.size() - 1) + " more" : ""));
  };
  add(only_in(of_a, of_b), "A");
  add(only_in(of_b, of_a), "B");
}

/// What was said once of all steps: it decides what is asked of the tree or what is a fault of another
/// engine, or says how a scene runs again.
std::vector<std::string> compare_declared(const RecordingInfo& a, const RecordingInfo& b) {
  std::vector<std::string> lines;
  const auto add = [&lines](const std::string& what, const std::string& of_a, const std::string& of_b) {
    if (of_a != of_b) lines.push_back(what + ": " + of_a + " in A, " + of_b + " in B");
  };
  const auto origin = [](const RecordingInfo& info) { return info.imported ? "an import" : "a run of ours"; };
  add("origin", origin(a), origin(b));
  add("volume", std::string(to_string(a.volume)), std::string(to_string(b.volume)));
  add("margin", margin_text(a.design.margin), margin_text(b.design.margin));
  add("rounding of boxes", rounding_text(a.design.rounding), rounding_text(b.design.rounding));
  add("digits of a structure", digits_text(a.digits), digits_text(b.digits));
  compare_ignored(a, b, lines);
  const auto [in_a, in_b] = std::ranges::mismatch(a.decisions, b.decisions);
  add("decisions", decision_text(a.decisions, static_cast<std::size_t>(in_a - a.decisions.begin())),
      decision_text(b.decisions, static_cast<std::size_t>(in_b - b.decisions.begin())));
  if (a.imported || b.imported) return lines;  // their scene is the name of a file
  add("scene", a.scene, b.scene);
  add("seed", std::to_string(a.seed), std::to_string(b.seed));
  add("objects", or_own(a.objects), or_own(b.objects));
  add("steps of growth", or_own(a.grow), or_own(b.grow));
  add("steps between objects that fall anew", std::to_string(a.recycle), std::to_string(b.recycle));
  return lines;
}

/// In how many digits the numbers were written is declared once.
template <int D>
bool same_structure(const std::optional<TheirStructure<D>>& a, const std::optional<TheirStructure<D>>& b) {
  return a.has_value() == b.has_value() && (!a || a->nodes == b->nodes);
}

/// What only imports have.
template <int D>
void compare_theirs(RecordingReader<D>& a, RecordingReader<D>& b, std::uint32_t step,
                    RecordingComparison& result) {
  if (!result.step_names && a.info().names.step(step) != b.info().names.step(step)) result.step_names = step;
  if (!a.info().imported && !b.info().imported) return;
  if (!result.requests && a.their_changes(step) != b.their_changes(step)) result.requests = step;
  if (!result.theirs) result.theirs = their_difference(a, b, step);
  if (!result.verdicts && a.judged_pairs(step) != b.judged_pairs(step)) result.verdicts = step;
  if (!result.structures && !same_structure(a.their_structure(step), b.their_structure(step)))
    result.structures = step;
}

/// What the tree is given.
template <int D>
void compare_given(RecordingReader<D>& a, RecordingReader<D>& b, std::uint32_t step,
                   RecordingComparison& result) {
  if (!result.config && config_of(a.info(), step) != config_of(b.info(), step)) result.config = step;
  if (!result.requests && !same_requests(a.step(step).requests, b.step(step).requests))
    result.requests = step;
  if (!result.shapes && !same_looks(a.step(step).looks, a.shapes(), b.step(step).looks, b.shapes()))
    result.shapes = step;
}

}  // namespace

template <int D>
RecordingComparison compare(RecordingReader<D>& a, RecordingReader<D>& b) {
  const DefaultFloats floats;
  RecordingComparison result;
  result.a = summary(a.rows(), a.info().complete);
  result.b = summary(b.rows(), b.info().complete);
  result.object_names = !std::ranges::equal(a.info().names.objects(), b.info().names.objects()) ||
                        a.info().marks != b.info().marks;
  result.declared = compare_declared(a.info(), b.info());
  for (std::uint32_t step = 1; step <= std::min(a.steps(), b.steps()); ++step) {
    if (!result.state && a.row(step).state_hash != b.row(step).state_hash) result.state = step;
    if (!result.pairs && a.row(step).pairs_hash != b.row(step).pairs_hash) result.pairs = step;
    compare_given(a, b, step, result);
    const auto differs = [&](bool (*counts)(const Event&)) {
      return first_difference(a.step(step).events, b.step(step).events, counts);
    };
    if (!result.events) result.events = differs(is_event);
    if (result.events && !result.operators) result.operators = differs(is_outcome);
    compare_theirs(a, b, step, result);
  }
  return result;
}

template RecordingComparison compare<2>(RecordingReader<2>&, RecordingReader<2>&);
template RecordingComparison compare<3>(RecordingReader<3>&, RecordingReader<3>&);

}  // namespace kerf
