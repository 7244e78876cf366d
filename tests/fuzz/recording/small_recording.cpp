#include <algorithm>
#include <stdexcept>

#include "core/bsp/bsp.h"
#include "core/bsp/bsp_state.h"
#include "core/recording/recording_writer.h"
#include "core/replay/judge_theirs.h"
#include "core/replay/oracle.h"
#include "core/trace/event_facts.h"
#include "tests/fuzz/recording/recording_cases.h"
#include "tests/support/config_of.h"

namespace kerf::test {
namespace {

constexpr std::uint32_t kObjects = 14;
constexpr std::uint32_t kSteps = 12;

Box<2> box_at(std::uint32_t object, std::uint32_t step) {
  const auto x = static_cast<Scalar>(object * 3 % kObjects) + 0.3F * static_cast<Scalar>(step * (object % 3));
  const auto y = static_cast<Scalar>(object % 4);
  return {{x, y}, {x + 1.5F, y + 1.5F}};
}

StepRequests<2> requests_of(std::uint32_t step) {
  StepRequests<2> requests;
  for (std::uint32_t object = 0; object < kObjects; ++object) {
    const Mobility mobility = object % 5 == 0 ? Mobility::fixed : Mobility::moving;
    if (step == 1) requests.add_insert({object}, box_at(object, step), mobility);
    if (step > 1 && object % 5 != 0) requests.add_move({object}, box_at(object, step));
  }
  if (step == 4) requests.add_remove({kObjects - 1});
  return requests;
}

StepRow row_of(const Bsp<2, EventLog>& tree, const std::vector<Event>& events, std::uint64_t first_event) {
  StepRow row;
  row.step = tree.steps();
  row.statistics = tree.statistics();
  row.pairs = tree.pairs().size();
  row.first_event = first_event;
  row.events = events.size();
  row.state_hash = tree.state_hash();
  row.pairs_hash = hash_pairs(tree.pairs());
  return row;
}

/// Something in every table.
RecordingInfo small_info() {
  RecordingInfo info;
  info.dimension = 2;
  info.scene = "small";
  info.imported = true;
  info.config =
      config_of("directions=16,min_threshold=3,max_threshold=4,schedule_interval=2,max_redundancy=0.3");
  info.changes.push_back({9, info.config});
  info.changes.back().config.merge = false;
  info.design = {{0.05, 0}, {{{1}, {2}}}};
  info.marks.set({1}, {"wheel", Rgb{200, 10, 0}});
  std::vector<GivenId> objects;
  std::vector<std::string> steps;
  for (std::uint32_t object = 0; object < kObjects; ++object) objects.push_back(GivenId::of(100 + object));
  for (std::uint32_t step = 1; step <= kSteps; ++step) steps.push_back(std::to_string(5000 + step));
  info.names = GivenNames(std::move(objects), std::move(steps));
  return info;
}

std::vector<Event> run_step(const RecordingInfo& info, std::uint32_t step, Bsp<2, EventLog>& tree) {
  apply(requests_of(step), tree);
  tree.set_config(config_of(info, step));
  tree.step();
  return tree.trace().take();
}

/// The first operator that acts does not.
Decision first_refused(const RecordingInfo& info) {
  Bsp<2, EventLog> tree(info.config);
  for (std::uint32_t step = 1; step <= kSteps; ++step)
    for (const Event& event : run_step(info, step, tree))
      if (const auto* const acted = acted_of(event)) return {event.id, acted->op, std::nullopt};
  throw std::logic_error("nothing acts in the small recording");
}

/// A box that floats do not hold, for one step, and a filter.
TheirChanges<2> changes_of(std::uint32_t step) {
  constexpr std::uint32_t kObject = 3;
  TheirChanges<2> changes;
  if (step == 1) changes.filters.push_back({{kObject}, {2, 1}});
  if (step == 2) {
    GivenBox<2> box = to_given(box_at(kObject, step));
    box.max[0] -= 1e-9;
    changes.boxes.push_back({{kObject}, box});
  }
  if (step == 3) changes.boxes.push_back({{kObject}, std::nullopt});
  return changes;
}

/// One pair is missing, and one is reported twice.
std::vector<Pair> their_pairs(std::span<const Pair> pairs) {
  std::vector<Pair> theirs(pairs.begin(), pairs.end());
  for (Pair& pair : theirs) pair = make_pair(pair.a, pair.b);
  std::ranges::sort(theirs);
  if (theirs.size() > 1) theirs.front() = theirs.back();
  return theirs;
}

/// Discs, and one triangle that turns.
std::vector<Look<2>> looks_of(const StepRequests<2>& requests, std::uint32_t step, ShapeNumbers<2>& shapes) {
  constexpr std::uint32_t kTriangle = 4;
  std::vector<Look<2>> looks;
  for (const ObjectId object : requests.objects) {
    const bool turns = object.value == kTriangle;
    const Shape<2> shape = turns ? Shape<2>(Outline{{{{0, 0}}, {{0.5F, 0}}, {{0, 0.5F}}}}) : Ball{0.5F};
    looks.push_back({shapes.number_of(shape), {0, {static_cast<std::int16_t>(turns ? 900 * step : 0)}}, {}});
  }
  return looks;
}

}  // namespace

void record_small(const std::filesystem::path& path) {
  RecordingInfo info = small_info();
  info.decisions.push_back(first_refused(info));
  Bsp<2, EventLog> tree(info.config);
  tree.decide(info.decisions);
  RecordingWriter<2> writer(path, info);
  TheirWorld<2> world;
  std::uint64_t next_event = 0;
  for (std::uint32_t step = 1; step <= kSteps; ++step) {
    const std::vector<Event> events = run_step(info, step, tree);
    const StepRequests<2> requests = requests_of(step);
    writer.add(requests, events, row_of(tree, events, next_event), looks_of(requests, step, writer.shapes()));
    if (step == kSmallKeyframe) writer.add(tree.state());
    const TheirChanges<2> changes = changes_of(step);
    world.apply(changes);
    writer.add(changes);
    if (step < 3) {
      const std::vector<Pair> theirs = their_pairs(tree.pairs());
      writer.add(theirs,
                 judge_theirs<2>(theirs, oracle_pairs(tree.objects()), tree.objects(), world, info.design));
    }
    next_event += events.size();
  }
  writer.finish();
}

}  // namespace kerf::test
