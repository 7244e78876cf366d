#include "core/query/counterpart.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

#include "core/trace/event_facts.h"

namespace kerf {
namespace {

/// The subject of an event, whatever its outcome: its kind, operator and node, or its object.
using SubjectKey = std::tuple<std::size_t, std::uint32_t, std::uint32_t>;

/// Acted and refused are two outcomes of one subject.
SubjectKey subject_of(const Event& event) {
  const std::size_t kind = is_outcome(event) ? std::variant_size_v<EventBody> : event.body.index();
  if (const auto deed = deed_of(event))
    return {kind, static_cast<std::uint32_t>(deed->op), deed->node.node.value};
  const auto object = object_of(event);
  return {kind, 0, object ? object->value : 0};
}

/// The events of the phase that `first` begins; those before any phase if `first` begins none.
std::span<const Event> phase_from(std::span<const Event> events, std::span<const Event>::iterator first) {
  const auto begin = first == events.end() ? events.begin() : first;
  const auto end = std::find_if(first == events.end() ? begin : begin + 1, events.end(), begins_phase);
  return {begin, end};
}

/// The phase of the other run that is the same as this one.
std::span<const Event> same_phase(std::span<const Event> phase, std::span<const Event> those) {
  if (phase.empty() || !begins_phase(phase.front())) return phase_from(those, those.end());
  const auto first =
      std::ranges::find_if(those, [&](const Event& event) { return event.body == phase.front().body; });
  return first == those.end() ? std::span<const Event>() : phase_from(those, first);
}

/// Each subject with the number of its earlier occurrences.
std::vector<std::pair<SubjectKey, int>> numbered(std::span<const Event> events) {
  std::map<SubjectKey, int> seen;
  std::vector<std::pair<SubjectKey, int>> result;
  for (const Event& event : events) {
    const SubjectKey subject = subject_of(event);
    result.emplace_back(subject, seen[subject]++);
  }
  return result;
}

}  // namespace

Counterpart find_counterpart(const Position& here, std::span<const Event> these, std::span<const Event> those,
                             std::uint32_t last) {
  using Match = Counterpart::Match;
  if (here.step > last) return {Position::end_of(last), Match::none};
  if (here.is_end()) return {here, Match::same};
  const auto now = std::ranges::find(these, here.event, &Event::id);
  auto first = now;
  while (first != these.begin() && !begins_phase(*first)) --first;
  const std::span<const Event> past{first, now + 1};
  const std::span<const Event> other = same_phase(past, those);
  const auto names = numbered(past);
  const auto other_names = numbered(other);
  std::map<std::pair<SubjectKey, int>, std::size_t> places;
  for (std::size_t k = 0; k < other_names.size(); ++k) places[other_names[k]] = k;
  for (std::size_t k = past.size(); k-- > 0;) {
    const auto found = places.find(names[k]);
    if (found == places.end()) continue;
    const Event& event = other[found->second];
    const bool same = event.body == past[k].body;
    const Match match = k + 1 < past.size() ? Match::none : same ? Match::same : Match::different;
    return {{here.step, event.id}, match};
  }
  return {Position::end_of(here.step - 1), Match::none};
}

}  // namespace kerf
