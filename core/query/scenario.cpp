#include "core/query/scenario.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "core/recording/recorder.h"
#include "core/replay/oracle.h"

namespace kerf {
namespace {

/// The requests one by one; objects that were moved by one call are moved by as many.
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

/// Of several boxes given to an object only the last counts, in the place of the first.
template <int D>
std::vector<ObjectRequest<D>> collapsed(const std::vector<ObjectRequest<D>>& singles) {
  constexpr std::size_t kNone = SIZE_MAX;
  std::map<ObjectId, std::size_t> place;  // of what was asked of each object, in `result`
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

/// Puts every object of the table where it is.
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

template <int D>
TheirStep judge(const std::vector<Pair>& theirs, const ObjectTable<D>& objects) {
  const PairJudgement judgement = judge_pairs(theirs, oracle_pairs(objects));
  return {theirs.size(), judgement.missed.size(), judgement.extra.size(), judgement.twice.size()};
}

}  // namespace

template <int D>
std::size_t Scenario<D>::requests() const {
  std::size_t sum = 0;
  for (const StepRequests<D>& step : steps) sum += step.objects.size();
  return sum;
}

template <int D>
Scenario<D> scenario_of(Replayer<D>& replayer, std::uint32_t first, std::uint32_t last) {
  RecordingReader<D>& recording = replayer.recording();
  Scenario<D> scenario{recording.info(), {}, {}};
  for (std::uint32_t step = std::max(first, 1U); step <= last; ++step) {
    if (step == first && first > 1) {
      replayer.seek(first);
      scenario.steps.push_back(insert_all(replayer.tree().objects()));
    } else {
      scenario.steps.push_back(recording.step(step).requests);
    }
    if (recording.their_step(step)) scenario.theirs.push_back(recording.their_pairs(step));
  }
  return scenario;
}

template <int D>
std::vector<ObjectId> objects_of(const Scenario<D>& scenario) {
  std::vector<ObjectId> objects;
  for (const StepRequests<D>& step : scenario.steps)
    objects.insert(objects.end(), step.objects.begin(), step.objects.end());
  std::ranges::sort(objects);
  objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
  return objects;
}

template <int D>
Scenario<D> with_objects(const Scenario<D>& scenario, const std::vector<ObjectId>& kept) {
  const auto wanted = [&](ObjectId object) { return std::ranges::binary_search(kept, object); };
  Scenario<D> smaller{scenario.info, {}, {}};
  for (const StepRequests<D>& step : scenario.steps) {
    StepRequests<D>& requests = smaller.steps.emplace_back();
    for (const ObjectRequest<D>& single : singles_of(step, scenario.info.volume))
      if (wanted(single.object)) append(requests, single);
  }
  for (const std::vector<Pair>& pairs : scenario.theirs)
    std::ranges::copy_if(pairs, std::back_inserter(smaller.theirs.emplace_back()),
                         [&](const Pair& pair) { return wanted(pair.a) && wanted(pair.b); });
  return smaller;
}

template <int D>
Scenario<D> with_steps(const Scenario<D>& scenario, const std::vector<std::size_t>& kept) {
  Scenario<D> smaller{scenario.info, {}, {}};
  std::size_t next = 0;
  for (const std::size_t step : kept) {
    std::vector<ObjectRequest<D>> merged;
    for (; next <= step; ++next)
      std::ranges::copy(singles_of(scenario.steps[next], scenario.info.volume), std::back_inserter(merged));
    StepRequests<D>& requests = smaller.steps.emplace_back();
    for (const ObjectRequest<D>& single : collapsed(merged)) append(requests, single);
    if (!scenario.theirs.empty()) smaller.theirs.push_back(scenario.theirs[step]);
  }
  return smaller;
}

template <int D>
void record(const Scenario<D>& scenario, const std::filesystem::path& path) {
  Bsp<D, EventLog> tree(scenario.info.config, scenario.info.volume);
  Recorder<D> recorder(tree, path, scenario.info);
  for (std::size_t k = 0; k < scenario.steps.size(); ++k) {
    apply(scenario.steps[k], recorder);
    recorder.step();
    (void)tree.trace().take();
    if (!scenario.theirs.empty())
      recorder.add_theirs(scenario.theirs[k], judge(scenario.theirs[k], tree.objects()));
  }
  recorder.finish();
}

#define KERF_INSTANTIATE(D)                                                                \
  template struct Scenario<D>;                                                             \
  template Scenario<D> scenario_of<D>(Replayer<D>&, std::uint32_t, std::uint32_t);         \
  template std::vector<ObjectId> objects_of<D>(const Scenario<D>&);                        \
  template Scenario<D> with_objects<D>(const Scenario<D>&, const std::vector<ObjectId>&);  \
  template Scenario<D> with_steps<D>(const Scenario<D>&, const std::vector<std::size_t>&); \
  template void record<D>(const Scenario<D>&, const std::filesystem::path&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
