#include "core/bsp/bsp.h"
#include "core/bsp/bsp_state.h"
#include "core/recording/recording_writer.h"
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

}  // namespace

void record_small(const std::filesystem::path& path) {
  RecordingInfo info;
  info.dimension = 2;
  info.scene = "small";
  info.config =
      config_of("directions=16,min_threshold=3,max_threshold=4,schedule_interval=2,max_redundancy=0.3");
  Bsp<2, EventLog> tree(info.config);
  RecordingWriter<2> writer(path, info);
  std::uint64_t next_event = 0;
  for (std::uint32_t step = 1; step <= kSteps; ++step) {
    const StepRequests<2> requests = requests_of(step);
    apply(requests, tree);
    tree.step();
    const std::vector<Event> events = tree.trace().take();
    writer.add(requests, events, row_of(tree, events, next_event));
    if (step == kSmallKeyframe) writer.add(tree.state());
    if (step < 3) writer.add(tree.pairs(), std::span<const JudgedPair>());
    next_event += events.size();
  }
  writer.finish();
}

}  // namespace kerf::test
