#include "core/query/search.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/base/float_mode.h"
#include "core/query/object_bound.h"
#include "core/query/recorded_moment.h"
#include "core/replay/judge_theirs.h"
#include "core/replay/oracle.h"

namespace kerf {
namespace {

bool is_change(const std::optional<ConditionNumber>& before, const ConditionNumber& now, Change change) {
  if (change == Change::becomes_true) return now.is_true() && (!before || !before->is_true());
  return before && *before != now;
}

/// The objects that a condition names.
std::vector<GivenId> objects_of(const Expression& expression) {
  std::vector<GivenId> ids;
  for (const ExpressionPart& part : expression.parts()) {
    if (part.kind != ExpressionPart::Kind::happening) continue;
    const bool is_pair = part.happening <= Happening::pair_leaves;
    if (is_pair || part.happening == Happening::object_moves) ids.push_back(part.a);
    if (is_pair) ids.push_back(part.b);
  }
  return ids;
}

/// The pairs that a condition names.
std::vector<Pair> pairs_of(const Expression& expression, const GivenNames& names) {
  std::vector<Pair> pairs;
  for (const ExpressionPart& part : expression.parts()) {
    if (part.kind != ExpressionPart::Kind::happening || part.happening > Happening::pair_leaves) continue;
    const auto a = names.find_object(part.a);
    const auto b = names.find_object(part.b);
    if (a && b) pairs.push_back(make_pair(*a, *b));
  }
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace

template <int D>
Search<D>::Search(std::shared_ptr<RecordingReader<D>> recording) : recording_(std::move(recording)) {}

template <int D>
void Search<D>::check(const Expression& expression) {
  if (takes_all_) return;
  for (const GivenId& id : objects_of(expression)) check_object(id);
  if (!expression.asks_oracle() || !recording_->info().imported) return;
  if (!has_judgement_) has_judgement_ = recording_->steps() == 0 || !recording_->their_steps().empty();
  if (!*has_judgement_)
    throw std::invalid_argument(recording_->path().string() +
                                " has no pairs of another engine; `kerf import --pairs` brings them");
}

template <int D>
void Search<D>::check_object(const GivenId& id) {
  const GivenNames& names = recording_->info().names;
  const bool has_names = !names.objects().empty();
  const std::optional<ObjectId> object = names.find_object(id);
  if (object && (has_names || object->value < most_objects())) return;
  std::string why = "the recording has no object " + to_string(id);
  if (!has_names) {
    if (!object_bound_) object_bound_ = object_bound(*recording_);
    if (object && object->value < *object_bound_) return;
    why += *object_bound_ == 0 ? "; it has none" : "; it has 0 to " + std::to_string(*object_bound_ - 1);
  }
  throw std::invalid_argument(why);
}

/// At a time: smaller numbers are known without a look into the recording.
template <int D>
std::uint32_t Search<D>::most_objects() const {
  std::uint32_t most = 0;
  for (const StepRow& row : recording_->rows()) most = std::max(most, row.statistics.objects);
  return most;
}

template <int D>
std::optional<Position> Search<D>::forward(const Expression& expression, const Position& from,
                                           const Progress& progress) {
  const DefaultFloats floats;
  check(expression);
  const Range range{from, Position::end_of(recording_->steps() + 1), false};
  for (std::uint32_t step = std::max(from.step, 1U); step <= recording_->steps(); ++step) {
    if (progress && !progress(step)) return std::nullopt;
    if (const auto found = in_step(expression, step, range)) return found;
  }
  return std::nullopt;
}

template <int D>
std::optional<Position> Search<D>::backward(const Expression& expression, const Position& from,
                                            const Progress& progress) {
  const DefaultFloats floats;
  check(expression);
  const Range range{Position{0, 0}, from, true};
  for (std::uint32_t step = std::min(from.step, recording_->steps()); step > 0; --step) {
    if (progress && !progress(step)) return std::nullopt;
    if (const auto found = in_step(expression, step, range)) return found;
  }
  return std::nullopt;
}

template <int D>
std::optional<Position> Search<D>::forward_change(const Expression& expression, const Position& from,
                                                  Change change, const Progress& progress) {
  const DefaultFloats floats;
  check(expression);
  std::optional<ConditionNumber> before = last_value(expression, from);
  for (std::uint32_t step = std::max(from.step, 1U); step <= recording_->steps(); ++step) {
    if (progress && !progress(step)) return std::nullopt;
    for (const ValueAt& now : values_in(expression, step)) {
      if (now.position <= from) continue;
      if (is_change(before, now.value, change)) return now.position;
      before = now.value;
    }
  }
  return std::nullopt;
}

template <int D>
std::optional<Position> Search<D>::backward_change(const Expression& expression, const Position& from,
                                                   Change change, const Progress& progress) {
  const DefaultFloats floats;
  check(expression);
  std::optional<ValueAt> later;  // whether it is a change depends on the moments before it
  for (std::uint32_t step = std::min(from.step, recording_->steps()); step > 0; --step) {
    if (progress && !progress(step)) return std::nullopt;
    const std::vector<ValueAt> values = values_in(expression, step);
    for (auto now = values.rbegin(); now != values.rend(); ++now) {
      if (later && is_change(now->value, later->value, change)) return later->position;
      if (now->position < from) later = *now;
    }
  }
  return later && is_change(std::nullopt, later->value, change) ? std::optional(later->position)
                                                                : std::nullopt;
}

/// Calls `visit(position, moment)` for the moments after the events of a step.
template <int D>
template <class Visit>
void Search<D>::visit_events(const Expression& expression, std::uint32_t step, Visit visit) {
  const auto visit_event = [&](const Event& event, const Bsp<D, Watch>* tree) {
    visit(Position{step, event.id}, RecordedMoment<D>(*recording_, step, &event, tree, nullptr, medians_));
  };
  if (!needs_replay(expression)) {
    for (const Event& event : recording_->step(step).events) visit_event(event, nullptr);
    return;
  }
  if (!replayer_) replayer_ = std::make_unique<Replayer<D>>(recording_);
  replayer_->seek(step - 1);
  replayer_->advance([&](const Event& event) { visit_event(event, &replayer_->tree()); });
}

/// The moments of a step that have a value.
template <int D>
auto Search<D>::values_in(const Expression& expression, std::uint32_t step) -> std::vector<ValueAt> {
  std::vector<ValueAt> values;
  const auto add = [&](const Position& at, const ConditionNumber& x) {
    if (x.exists()) values.push_back({at, x});
  };
  if (!expression.asks_events()) {
    add(Position::end_of(step), value(expression, Position::end_of(step)));
    return values;
  }
  visit_events(expression, step,
               [&](const Position& at, const Moment& moment) { add(at, kerf::value(expression, moment)); });
  return values;
}

template <int D>
std::optional<ConditionNumber> Search<D>::last_value(const Expression& expression, const Position& up_to) {
  for (std::uint32_t step = std::min(up_to.step, recording_->steps()); step > 0; --step) {
    const std::vector<ValueAt> values = values_in(expression, step);
    for (auto now = values.rbegin(); now != values.rend(); ++now)
      if (now->position <= up_to) return now->value;
  }
  return std::nullopt;
}

template <int D>
ConditionNumber Search<D>::value(const Expression& expression, const Position& at) {
  const DefaultFloats floats;
  check(expression);
  ConditionNumber result;
  if (at.step == 0) return result;
  const auto ask = [&](const Event* event, const Bsp<D, Watch>* tree, const std::vector<Pair>* before) {
    result = kerf::value(expression, RecordedMoment<D>(*recording_, at.step, event, tree, before, medians_));
  };
  if (!at.is_end() && !expression.asks_depth()) {
    const std::vector<Event>& events = recording_->step(at.step).events;
    ask(&events[at.event - recording_->row(at.step).first_event], nullptr, nullptr);
    return result;
  }
  if (!needs_replay(expression)) {
    ask(nullptr, nullptr, nullptr);
    return result;
  }
  if (!replayer_) replayer_ = std::make_unique<Replayer<D>>(recording_);
  replayer_->seek(at.step - 1);
  const std::vector<Pair> before = pairs_now(expression);
  replayer_->advance([&](const Event& event) {
    if (event.id == at.event) ask(&event, &replayer_->tree(), nullptr);
  });
  if (at.is_end()) ask(nullptr, &replayer_->tree(), &before);
  return result;
}

/// Where the replay is, sorted. Of an import, whose boxes the tree has rounded outward, those that the
/// expression names and that overlap as they were given.
template <int D>
std::vector<Pair> Search<D>::pairs_now(const Expression& expression) const {
  const Bsp<D, Watch>& tree = replayer_->tree();
  std::vector<Pair> pairs = sorted_pairs(tree.pairs());
  if (!recording_->info().imported) return pairs;
  std::vector<Pair> asked = pairs_of(expression, recording_->info().names);
  std::erase_if(asked, [&](const Pair& pair) {
    return !std::ranges::binary_search(pairs, pair) ||
           !overlap_as_given(*recording_, replayer_->step(), tree.objects(), pair);
  });
  return asked;
}

/// The recording has the judgements of an import's pairs.
template <int D>
bool Search<D>::needs_replay(const Expression& expression) const {
  return expression.asks_depth() || expression.asks_pairs() ||
         (expression.asks_oracle() && !recording_->info().imported);
}

template <int D>
std::optional<Position> Search<D>::in_step(const Expression& expression, std::uint32_t step,
                                           const Range& range) {
  if (expression.asks_events()) return in_events(expression, step, range);
  return at_end(expression, step, range);
}

template <int D>
std::optional<Position> Search<D>::in_events(const Expression& expression, std::uint32_t step,
                                             const Range& range) {
  std::optional<Position> found;
  visit_events(expression, step, [&](const Position& at, const Moment& moment) {
    if (at <= range.after || at >= range.before || (found && !range.wants_last)) return;
    if (holds(expression, moment)) found = at;
  });
  return found;
}

template <int D>
std::optional<Position> Search<D>::at_end(const Expression& expression, std::uint32_t step,
                                          const Range& range) {
  const Position position = Position::end_of(step);
  if (position <= range.after || position >= range.before) return std::nullopt;
  std::vector<Pair> before;
  if (needs_replay(expression)) {
    if (!replayer_) replayer_ = std::make_unique<Replayer<D>>(recording_);
    replayer_->seek(step - 1);
    if (expression.asks_pairs()) before = pairs_now(expression);
    replayer_->seek(step);
  }
  const Bsp<D, Watch>* const tree = replayer_ ? &replayer_->tree() : nullptr;
  const RecordedMoment<D> moment(*recording_, step, nullptr, tree, &before, medians_);
  return holds(expression, moment) ? std::optional(position) : std::nullopt;
}

template class Search<2>;
template class Search<3>;

}  // namespace kerf
