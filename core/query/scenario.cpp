#include "core/query/scenario.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "core/base/float_mode.h"
#include "core/recording/recorder.h"
#include "core/replay/judge_theirs.h"
#include "core/replay/oracle.h"
#include "core/replay/recorded_looks.h"
#include "core/trace/event_facts.h"

namespace kerf {
namespace {

/// The requests one by one; a call that moves many objects becomes one call for each.
template <int D>
std::vector<ObjectRequest<D>> singles_of(const StepRequests<D>& requests, VolumeKind kind) {
  std::vector<ObjectRequest<D>> singles;
  for_each_request(requests, kind, [&](ObjectRequest<D> request) {
    if (request.kind == RequestKind::move_boxes) request.kind = RequestKind::move_box;
    singles.push_back(request);
  });
  return singles;
}

template <int D>
void append(StepRequests<D>& requests, const ObjectRequest<D>& single) {
  switch (single.kind) {
    case RequestKind::insert_box:
      return requests.add_insert(single.object, single.volume.box, single.mobility);
    case RequestKind::insert_volume:
      return requests.add_insert(single.object, single.volume, single.mobility);
    case RequestKind::move_box:
    case RequestKind::move_boxes:
      return requests.add_move(single.object, single.volume.box);
    case RequestKind::move_volume:
      return requests.add_move(single.object, single.volume);
    case RequestKind::remove:
      return requests.add_remove(single.object);
  }
}

/// Of several boxes of an object only the last counts, in the place of the first.
template <int D>
std::vector<ObjectRequest<D>> collapsed(const std::vector<ObjectRequest<D>>& singles) {
  constexpr std::size_t kNone = SIZE_MAX;
  std::map<ObjectId, std::size_t> place;  // of each object's request in `result`
  std::vector<ObjectRequest<D>> result;
  for (const ObjectRequest<D>& single : singles) {
    std::size_t& last = place.try_emplace(single.object, kNone).first->second;
    const bool moves = single.kind == RequestKind::move_box || single.kind == RequestKind::move_volume;
    if (moves && last != kNone && has_volume(result[last].kind) == has_volume(single.kind)) {
      result[last].volume = single.volume;
      continue;
    }
    last = single.kind == RequestKind::remove ? kNone : result.size();
    result.push_back(single);
  }
  return result;
}

/// Puts every object of the table into its present place.
template <int D>
StepRequests<D> insert_all(const ObjectTable<D>& table) {
  StepRequests<D> requests;
  for (std::uint32_t id = 0; id < table.bound(); ++id) {
    const Mobility mobility = table.is_fixed({id}) ? Mobility::fixed : Mobility::moving;
    if (table.state({id}) == ObjectState::quarantined) requests.add_insert({id}, Box<D>::empty(), mobility);
    if (!table.is_placed({id})) continue;
    if (table.kind() == VolumeKind::box) {
      requests.add_insert({id}, table.box({id}), mobility);
    } else {
      requests.add_insert({id}, table.volume({id}), mobility);
    }
  }
  return requests;
}

/// Puts every object's box in doubles, and its filter, where they are at the end of a step.
template <int D>
TheirChanges<D> all_changes(const RecordingReader<D>& recording, const ObjectTable<D>& table,
                            std::uint32_t step) {
  TheirChanges<D> changes;
  for (std::uint32_t id = 0; recording.info().imported && id < table.bound(); ++id) {
    if (const auto box = recording.given_box({id}, step)) changes.boxes.push_back({{id}, box});
    if (const auto filter = recording.filter({id}, step)) changes.filters.push_back({{id}, *filter});
  }
  return changes;
}

/// How every object looks.
template <int D>
std::vector<LookChange<D>> all_looks(const Looks<D>& looks) {
  std::vector<LookChange<D>> all;
  for (std::uint32_t id = 0; id < looks.bound(); ++id)
    if (looks.of({id}).shape != kNoShape) all.push_back({{id}, looks.of({id})});
  return all;
}

/// Of several changes of an object the last counts.
template <class Change>
void keep_last(std::vector<Change>& changes) {
  std::ranges::reverse(changes);
  std::ranges::stable_sort(changes, {}, &Change::object);
  const auto is_same = [](const Change& a, const Change& b) { return a.object == b.object; };
  changes.erase(std::unique(changes.begin(), changes.end(), is_same), changes.end());
}

bool& switch_of(Config& config, Operator op) {
  switch (op) {
    case Operator::balance:
      return config.balance;
    case Operator::shift_split:
      return config.shift_split;
    case Operator::split:
      return config.split;
    case Operator::swap:
      return config.swap;
    case Operator::merge:
      break;
  }
  return config.merge;
}

/// As in the recording that the scenario makes.
template <int D>
RecordingInfo info_of(const Scenario<D>& scenario) {
  RecordingInfo info = scenario.info;
  info.changes.clear();
  info.decisions.clear();
  if (!scenario.steps.empty()) info.config = scenario.steps.front().config;
  for (std::uint32_t k = 1; k < scenario.steps.size(); ++k)
    if (scenario.steps[k].config != scenario.steps[k - 1].config)
      info.changes.push_back({k + 1, scenario.steps[k].config});
  if (!info.names.names_steps()) return info;
  std::vector<std::string> steps;
  for (const ScenarioStep<D>& step : scenario.steps) steps.push_back(step.name);
  info.names = GivenNames({info.names.objects().begin(), info.names.objects().end()}, std::move(steps));
  return info;
}

}  // namespace

template <int D>
std::size_t Scenario<D>::requests() const {
  std::size_t sum = 0;
  for (const ScenarioStep<D>& step : steps) sum += step.requests.objects.size();
  return sum;
}

template <int D>
Scenario<D> scenario_of(Replayer<D>& replayer, std::uint32_t first, std::uint32_t last) {
  const DefaultFloats floats;
  RecordingReader<D>& recording = replayer.recording();
  Scenario<D> scenario{recording.info(), {}, {}};
  if (recording.shape_count() > 0)
    scenario.shapes = std::make_shared<const std::vector<Shape<D>>>(recording.shapes());
  for (std::uint32_t number = std::max(first, 1U); number <= last; ++number) {
    ScenarioStep<D>& step = scenario.steps.emplace_back();
    step.config = config_of(recording.info(), number);
    step.name = recording.info().names.step(number);
    if (number == first && first > 1) {
      replayer.seek(first);
      step.requests = insert_all(replayer.tree().objects());
      step.looks = all_looks(RecordedLooks<D>(recording).at(first));
      step.changes = all_changes(recording, replayer.tree().objects(), first);
    } else {
      step.requests = recording.step(number).requests;
      step.looks = recording.step(number).looks;
      if (recording.info().imported) step.changes = recording.their_changes(number);
    }
    if (recording.their_step(number)) step.theirs = recording.their_pairs(number);
  }
  return scenario;
}

template <int D>
std::vector<ObjectId> objects_of(const Scenario<D>& scenario) {
  std::vector<ObjectId> objects;
  for (const ScenarioStep<D>& step : scenario.steps) {
    objects.insert(objects.end(), step.requests.objects.begin(), step.requests.objects.end());
    if (!step.theirs) continue;
    for (const Pair& pair : *step.theirs) objects.insert(objects.end(), {pair.a, pair.b});
  }
  std::ranges::sort(objects);
  objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
  return objects;
}

template <int D>
Scenario<D> with_objects(const Scenario<D>& scenario, const std::vector<ObjectId>& kept) {
  const auto wanted = [&](ObjectId object) { return std::ranges::binary_search(kept, object); };
  Scenario<D> smaller{scenario.info, {}, scenario.shapes};
  for (const ScenarioStep<D>& step : scenario.steps) {
    ScenarioStep<D>& rest = smaller.steps.emplace_back();
    rest.config = step.config;
    rest.name = step.name;
    for (const ObjectRequest<D>& single : singles_of(step.requests, scenario.info.volume))
      if (wanted(single.object)) append(rest.requests, single);
    const auto concerns = [&](const auto& change) { return wanted(change.object); };
    std::ranges::copy_if(step.looks, std::back_inserter(rest.looks), concerns);
    std::ranges::copy_if(step.changes.boxes, std::back_inserter(rest.changes.boxes), concerns);
    std::ranges::copy_if(step.changes.filters, std::back_inserter(rest.changes.filters), concerns);
    if (!step.theirs) continue;
    std::ranges::copy_if(*step.theirs, std::back_inserter(rest.theirs.emplace()),
                         [&](const Pair& pair) { return wanted(pair.a) && wanted(pair.b); });
  }
  return smaller;
}

template <int D>
Scenario<D> with_steps(const Scenario<D>& scenario, const std::vector<std::size_t>& kept) {
  Scenario<D> smaller{scenario.info, {}, scenario.shapes};
  std::size_t next = 0;
  for (const std::size_t index : kept) {
    std::vector<ObjectRequest<D>> merged;
    ScenarioStep<D>& step = smaller.steps.emplace_back();
    for (; next <= index; ++next) {
      std::ranges::copy(singles_of(scenario.steps[next].requests, scenario.info.volume),
                        std::back_inserter(merged));
      const std::vector<LookChange<D>>& looks = scenario.steps[next].looks;
      step.looks.insert(step.looks.end(), looks.begin(), looks.end());
      const auto& [boxes, filters] = scenario.steps[next].changes;
      step.changes.boxes.insert(step.changes.boxes.end(), boxes.begin(), boxes.end());
      step.changes.filters.insert(step.changes.filters.end(), filters.begin(), filters.end());
    }
    keep_last(step.changes.boxes);
    keep_last(step.changes.filters);
    step.name = scenario.steps[index].name;
    step.config = scenario.steps[index].config;
    for (const ObjectRequest<D>& single : collapsed(merged)) append(step.requests, single);
    step.theirs = scenario.steps[index].theirs;
  }
  return smaller;
}

template <int D>
std::vector<Acting> acting_operators(const Scenario<D>& scenario) {
  const DefaultFloats floats;
  std::vector<Acting> acting;
  Bsp<D, EventLog> tree(scenario.info.config, scenario.info.volume);
  for (std::size_t k = 0; k < scenario.steps.size(); ++k) {
    apply(scenario.steps[k].requests, tree);
    tree.set_config(scenario.steps[k].config);
    tree.step();
    for (const Event& event : tree.trace().take()) {
      const auto* const acted = acted_of(event);
      if (acted == nullptr) continue;
      const Acting found{k, acted->op};
      if (std::ranges::find(acting, found) == acting.end()) acting.push_back(found);
    }
  }
  return acting;
}

template <int D>
Scenario<D> without_operators(Scenario<D> scenario, const std::vector<Acting>& left_out) {
  for (const Acting& acting : left_out) switch_of(scenario.steps[acting.step].config, acting.op) = false;
  return scenario;
}

template <int D>
void record(const Scenario<D>& scenario, const std::filesystem::path& path) {
  const RecordingInfo info = info_of(scenario);
  Bsp<D, EventLog> tree(info.config, info.volume);
  Recorder<D> recorder(tree, path, info);
  TheirWorld<D> world;
  Looks<D> looks;
  if (scenario.shapes)
    recorder.show([&](ObjectId object) { return appearance_of(looks.of(object), *scenario.shapes); });
  for (const ScenarioStep<D>& step : scenario.steps) {
    looks.apply(step.looks);
    apply(step.requests, recorder);
    recorder.step();
    (void)tree.trace().take();
    world.apply(step.changes);
    recorder.add_theirs(step.changes);
    if (step.theirs)
      recorder.add_theirs(*step.theirs, judge_theirs<D>(*step.theirs, oracle_pairs(tree.objects()),
                                                        tree.objects(), world, info.design));
  }
  recorder.finish();
}

#define KERF_INSTANTIATE(D)                                                                \
  template struct Scenario<D>;                                                             \
  template Scenario<D> scenario_of<D>(Replayer<D>&, std::uint32_t, std::uint32_t);         \
  template std::vector<ObjectId> objects_of<D>(const Scenario<D>&);                        \
  template Scenario<D> with_objects<D>(const Scenario<D>&, const std::vector<ObjectId>&);  \
  template Scenario<D> with_steps<D>(const Scenario<D>&, const std::vector<std::size_t>&); \
  template std::vector<Acting> acting_operators<D>(const Scenario<D>&);                    \
  template Scenario<D> without_operators<D>(Scenario<D>, const std::vector<Acting>&);      \
  template void record<D>(const Scenario<D>&, const std::filesystem::path&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
