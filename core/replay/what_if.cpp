#include "core/replay/what_if.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "core/base/counted.h"
#include "core/base/float_mode.h"
#include "core/base/poll.h"
#include "core/recording/recorder.h"
#include "core/recording/schema.h"
#include "core/replay/cursor.h"
#include "core/replay/recorded_looks.h"
#include "core/trace/event_facts.h"

namespace kerf {
namespace {

std::string name_of(std::uint64_t event) { return "e" + std::to_string(event); }

/// The operator of an event: one that acted, or a split that found no partitioner.
std::optional<Operator> decidable(const Event& event) {
  if (const auto* const acted = acted_of(event)) return acted->op;
  const auto* const refused = refused_of(event);
  if (refused == nullptr || refused->reason != Refusal::no_partitioner) return std::nullopt;
  return Operator::split;
}

/// There must be no decision or change from this step on, except decisions in the step before `event`.
template <int D>
void check_latest(const RecordingInfo& info, const RecordingReader<D>& recording, std::uint32_t step,
                  std::uint64_t event) {
  for (const Decision& decision : info.decisions)
    if (decision.event >= event || recording.step_of(decision.event).value_or(step) > step)
      throw std::invalid_argument("the recording has a decision about " + name_of(decision.event) +
                                  ", which would be another event then: start from the recording before it");
  for (const ConfigChange& change : info.changes)
    if (change.step > step)
      throw std::invalid_argument("the recording has another configuration from step " +
                                  recording.info().names.step(change.step) +
                                  " on: start from the recording before that change");
}

template <int D>
ChosenPlane plane_of(Replayer<D>& replayer, const Event& event, std::size_t candidate) {
  const auto candidates = ballot_of(state_before(replayer, event.id), event);
  const std::string ballot = name_of(event.id) + " has " + counted(candidates.size(), "candidate");
  if (candidate >= candidates.size())
    throw std::invalid_argument(ballot + ", counted from 0: there is no candidate " +
                                std::to_string(candidate));
  const BallotEntry& entry = candidates[candidate];
  if (entry.result == Ballot::undividing)
    throw std::invalid_argument("candidate " + std::to_string(candidate) + " of " + name_of(event.id) +
                                " divides nothing, so it cannot be taken");
  return {entry.direction, entry.offset};
}

bool took_effect(const Decision& decision, const Event& event) {
  if (const auto* const refused = refused_of(event))
    return !decision.plane && refused->op == decision.op && refused->reason == Refusal::decided;
  const auto* const acted = acted_of(event);
  return decision.plane && acted != nullptr && acted->direction == decision.plane->direction &&
         acted->new_offset == decision.plane->offset;
}

std::string why_not(const Decision& decision, const Event& event, const GivenNames& names) {
  const std::string what = name_of(decision.event) + ": the decision had no effect: ";
  if (const auto* const refused = refused_of(event)) return what + std::string(to_string(refused->reason));
  return what + describe(event, names) +
         ". What sheds entries beyond max_entries cannot be refused; raise max_entries instead";
}

void check_effect(const RecordingInfo& info, const std::vector<Event>& events) {
  for (const Decision& decision : info.decisions) {
    const auto event = std::ranges::find(events, decision.event, &Event::id);
    if (event != events.end() && !took_effect(decision, *event))
      throw std::runtime_error(why_not(decision, *event, info.names));
  }
}

template <int D>
void rerun_steps(RecordingReader<D>& recording, const RecordingInfo& info, Bsp<D, EventLog>& tree,
                 Recorder<D>& recorder, const std::function<bool()>& stop) {
  RecordedLooks<D> looks(recording);
  if (recording.shape_count() > 0) recorder.show([&](ObjectId object) { return looks.appearance(object); });
  for (std::uint32_t step = 1; step <= recording.steps() && !(stop && stop()); ++step) {
    static_cast<void>(looks.at(step));
    apply(recording.step(step).requests, recorder);
    recorder.step();
    check_effect(info, tree.trace().take());
    const bool is_judged = recording.their_step(step).has_value();
    std::optional<Polling> polling;
    if (info.imported || is_judged)  // there may be many millions of rows
      polling.emplace([&] {
        if (stop && stop()) throw Stopped();
      });
    if (info.imported) recorder.add_theirs(recording.their_changes(step));
    if (const auto structure = recording.their_structure(step)) recorder.add_theirs(*structure);
    if (is_judged) recorder.add_theirs(recording.their_pairs(step), recording.judged_pairs(step));
  }
}

}  // namespace

template <int D>
void decide(RecordingInfo& info, Replayer<D>& replayer, std::uint64_t event,
            std::optional<std::size_t> candidate) {
  const Event happened = replayer.recording().event(event);
  const std::string text = describe(happened, info.names);
  const auto op = decidable(happened);
  if (!op)
    throw std::invalid_argument(text +
                                ": not an operator that acts; `kerf step --to 'kind==acted'` finds one");
  if (candidate && *op != Operator::split)
    throw std::invalid_argument(text + ": only a split has candidates to choose from");
  if (!candidate && !has_acted(happened))
    throw std::invalid_argument(text + ": it has not acted, so there is nothing to refuse");
  check_latest(info, replayer.recording(), happened.step, event);
  Decision decision{event, *op, std::nullopt};
  if (candidate) decision.plane = plane_of(replayer, happened, *candidate);
  info.decisions.push_back(decision);
}

template <int D>
void change_config(RecordingInfo& info, const RecordingReader<D>& recording, std::uint32_t step,
                   const Config& config) {
  if (step == 0 || step > recording.steps())
    throw std::invalid_argument("the recording has " + recording.info().names.steps(1, recording.steps()) +
                                ": there is none to change " + (step == 0 ? "before" : "after") + " them");
  check_latest(info, recording, step - 1, UINT64_MAX);
  if (step == 1) {
    info.config = config;
    return;
  }
  if (config.directions != info.config.directions || config.seed != info.config.seed)
    throw std::invalid_argument("directions and seed can only change from the beginning: leave out the step");
  info.changes.push_back({step, config});
}

template <int D>
bool rerun(RecordingReader<D>& recording, const RecordingInfo& info, const std::filesystem::path& out,
           const std::function<bool()>& stop) {
  const DefaultFloats floats;
  Bsp<D, EventLog> tree(info.config, info.volume);
  Recorder<D> recorder(tree, out,
                       info);  // what has the name already, or is being written, is not ours to remove
  try {
    rerun_steps(recording, info, tree, recorder, stop);
    recorder.finish();
    return tree.steps() == recording.steps();
  } catch (const Stopped&) {
    return false;
  } catch (const CannotWrite&) {
    throw;
  } catch (const std::runtime_error&) {
    remove_recording(out);
    throw;
  }
}

#define KERF_INSTANTIATE(D)                                                                                \
  template void decide<D>(RecordingInfo&, Replayer<D>&, std::uint64_t, std::optional<std::size_t>);        \
  template void change_config<D>(RecordingInfo&, const RecordingReader<D>&, std::uint32_t, const Config&); \
  template bool rerun<D>(RecordingReader<D>&, const RecordingInfo&, const std::filesystem::path&,          \
                         const std::function<bool()>&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
