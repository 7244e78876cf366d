#include "core/query/compare.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <utility>

#include "core/base/counted.h"
#include "core/base/float_mode.h"
#include "core/base/median.h"
#include "core/base/shortest_text.h"
#include "core/query/common_numbers.h"
#include "core/query/compare_trees.h"
#include "core/query/object_bound.h"
#include "core/recording/shape_rows.h"
#include "core/replay/replayer.h"
#include "core/trace/event_facts.h"

namespace kerf {
namespace {

using Of = CommonNumbers::Of;

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

bool same_body(const Event& a, const Event& b, CommonNumbers& numbers) {
  if (numbers.are_own()) return a.body == b.body;
  return numbers.renumbered(Of::a, a.body) == numbers.renumbered(Of::b, b.body);
}

std::optional<EventDifference> first_difference(const std::vector<Event>& a, const std::vector<Event>& b,
                                                bool (*counts)(const Event&), CommonNumbers& numbers) {
  auto in_a = a.begin();
  auto in_b = b.begin();
  for (;; ++in_a, ++in_b) {
    in_a = std::find_if(in_a, a.end(), counts);
    in_b = std::find_if(in_b, b.end(), counts);
    if (in_a == a.end() || in_b == b.end() || !same_body(*in_a, *in_b, numbers)) break;
  }
  if (in_a == a.end() && in_b == b.end()) return std::nullopt;
  EventDifference difference;
  if (in_a != a.end()) difference.a = *in_a;
  if (in_b != b.end()) difference.b = *in_b;
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
                                                const CommonSteps::Step& step) {
  const std::vector<NamedPair> of_a = named(a.their_pairs(step.a), a.info().names);
  const std::vector<NamedPair> of_b = named(b.their_pairs(step.b), b.info().names);
  if (of_a == of_b && a.their_step(step.a).has_value() == b.their_step(step.b).has_value())
    return std::nullopt;
  return TheirDifference{step.a, only_in(of_a, of_b), only_in(of_b, of_a)};
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

/// The objects that a recording has or names, rising.
template <int D>
std::vector<GivenId> names_of(RecordingReader<D>& recording) {
  const std::span<const GivenId> names = recording.info().names.objects();
  std::vector<GivenId> all(names.begin(), names.end());
  if (!all.empty()) return all;
  for (std::uint32_t id = 0, bound = object_bound(recording); id < bound; ++id)
    all.push_back(GivenId::of(id));
  return all;
}

std::vector<std::string> only_in(const std::vector<GivenId>& a, const std::vector<GivenId>& b) {
  std::vector<GivenId> only;
  std::ranges::set_difference(a, b, std::back_inserter(only));
  std::vector<std::string> texts;
  for (const GivenId& name : only) texts.push_back(to_string(name));
  return texts;
}

/// Two recordings, step by step, their objects and steps by what they are called.
template <int D>
class Comparing {
 public:
  Comparing(RecordingReader<D>& a, RecordingReader<D>& b)
      : a_(a), b_(b), numbers_(a.info().names, b.info().names) {}

  RecordingComparison run() {
    result_.a = summary(a_.rows(), a_.info().complete);
    result_.b = summary(b_.rows(), b_.info().complete);
    compare_names();
    result_.declared = compare_declared(a_.info(), b_.info());
    CommonSteps steps = common_steps(a_.info().names, a_.steps(), b_.info().names, b_.steps());
    for (const CommonSteps::Step& step : steps.both) {
      compare_given(step);
      compare_events(step);
      numbers_.are_own() ? compare_hashes(step) : compare_replayed(step);
      if (a_.info().imported || b_.info().imported) compare_theirs(step);
    }
    result_.steps_only_a = std::move(steps.only_a);
    result_.steps_only_b = std::move(steps.only_b);
    return std::move(result_);
  }

 private:
  using Step = CommonSteps::Step;

  void compare_names() {
    const GivenNames& a = a_.info().names;
    const GivenNames& b = b_.info().names;
    for (std::uint32_t step = 1; step <= std::min(a_.steps(), b_.steps()) && !result_.step_names; ++step)
      if (a.step(step) != b.step(step)) result_.step_names = step;
    result_.object_names = !numbers_.are_own() || numbers_.renumbered(Of::a, a_.info().marks) !=
                                                      numbers_.renumbered(Of::b, b_.info().marks);
    if (numbers_.are_own()) return;
    const std::vector<GivenId> of_a = names_of(a_);
    const std::vector<GivenId> of_b = names_of(b_);
    result_.objects_only_a = only_in(of_a, of_b);
    result_.objects_only_b = only_in(of_b, of_a);
  }

  /// What the tree is given.
  void compare_given(const Step& step) {
    if (!result_.config && config_of(a_.info(), step.a) != config_of(b_.info(), step.b))
      result_.config = step.a;
    const auto renumbered = [&](const auto& of_a, const auto& of_b, auto same) {
      if (numbers_.are_own()) return same(of_a, of_b);
      return same(numbers_.renumbered(Of::a, of_a), numbers_.renumbered(Of::b, of_b));
    };
    const RecordedStep<D>& a = a_.step(step.a);
    const RecordedStep<D>& b = b_.step(step.b);
    if (!result_.requests && !renumbered(a.requests, b.requests, same_requests<D>)) result_.requests = step.a;
    const auto look_alike = [&](const auto& x, const auto& y) {
      return same_looks(x, a_.shapes(), y, b_.shapes());
    };
    if (!result_.shapes && !renumbered(a.looks, b.looks, look_alike)) result_.shapes = step.a;
  }

  void compare_events(const Step& step) {
    const auto differs = [&](bool (*counts)(const Event&)) {
      auto difference = first_difference(a_.step(step.a).events, b_.step(step.b).events, counts, numbers_);
      if (difference) difference->step = step.a;
      return difference;
    };
    if (!result_.events) result_.events = differs(is_event);
    if (result_.events && !result_.operators) result_.operators = differs(is_outcome);
  }

  void compare_hashes(const Step& step) {
    const StepRow& a = a_.row(step.a);
    const StepRow& b = b_.row(step.b);
    if (!result_.state && a.state_hash != b.state_hash) result_.state = step.a;
    if (!result_.pairs && a.pairs_hash != b.pairs_hash) result_.pairs = step.a;
  }

  /// Hashes are of numbers, so the trees run again.
  void compare_replayed(const Step& step) {
    if (result_.state && result_.pairs) return;
    const Bsp<D, Watch>& a = replayed(a_, a_again_, step.a);
    const Bsp<D, Watch>& b = replayed(b_, b_again_, step.b);
    if (!result_.state && !same_trees(a.state(), b.state(), numbers_)) result_.state = step.a;
    const auto pairs = [this](Of of, const Bsp<D, Watch>& tree) {
      return numbers_.renumbered(of, std::vector<Pair>(tree.pairs().begin(), tree.pairs().end()));
    };
    if (!result_.pairs && pairs(Of::a, a) != pairs(Of::b, b)) result_.pairs = step.a;
  }

  static const Bsp<D, Watch>& replayed(RecordingReader<D>& recording, std::optional<Replayer<D>>& again,
                                       std::uint32_t step) {
    if (!again) again.emplace(std::shared_ptr<RecordingReader<D>>(std::shared_ptr<void>(), &recording));
    again->seek(step);
    return again->tree();
  }

  /// What only imports have.
  void compare_theirs(const Step& step) {
    const auto differ = [&](const auto& of_a, const auto& of_b) {
      if (numbers_.are_own()) return of_a != of_b;
      return numbers_.renumbered(Of::a, of_a) != numbers_.renumbered(Of::b, of_b);
    };
    if (!result_.requests && differ(a_.their_changes(step.a), b_.their_changes(step.b)))
      result_.requests = step.a;
    if (!result_.theirs) result_.theirs = their_difference(a_, b_, step);
    if (!result_.verdicts && differ(a_.judged_pairs(step.a), b_.judged_pairs(step.b)))
      result_.verdicts = step.a;
    if (!result_.structures && !same_structure(numbers_.renumbered(Of::a, a_.their_structure(step.a)),
                                               numbers_.renumbered(Of::b, b_.their_structure(step.b))))
      result_.structures = step.a;
  }

  RecordingReader<D>& a_;
  RecordingReader<D>& b_;
  CommonNumbers numbers_;
  std::optional<Replayer<D>> a_again_;  ///< none until it is needed
  std::optional<Replayer<D>> b_again_;
  RecordingComparison result_;
};

}  // namespace

template <int D>
RecordingComparison compare(RecordingReader<D>& a, RecordingReader<D>& b) {
  const DefaultFloats floats;
  return Comparing<D>(a, b).run();
}

template RecordingComparison compare<2>(RecordingReader<2>&, RecordingReader<2>&);
template RecordingComparison compare<3>(RecordingReader<3>&, RecordingReader<3>&);

}  // namespace kerf
