#include <algorithm>
#include <stdexcept>

#include "core/bsp/bsp.h"
#include "core/recording/block_codec.h"
#include "core/recording/compression.h"
#include "core/recording/event_codec.h"
#include "core/replay/oracle.h"
#include "tests/fuzz/recording/recording_cases.h"

namespace kerf::test {
namespace {

/// Runs the steps; those with large numbers of objects, which take long, are only read.
std::string run(const std::vector<RecordedStep<2>>& steps) {
  constexpr std::uint32_t kMost = 200;
  Bsp<2> tree;
  for (const RecordedStep<2>& step : steps) {
    const auto is_large = [](ObjectId object) { return object.value >= kMost; };
    if (step.requests.objects.size() > kMost || std::ranges::any_of(step.requests.objects, is_large))
      return "";
    apply(step.requests, tree);
    tree.step();
    if (!judge_pairs(tree.pairs(), oracle_pairs(tree.objects())).is_exact()) return "its pairs are wrong";
  }
  return "";
}

/// Rows of a recording that say what the block says.
std::vector<StepRow> fitting_rows(CaseBytes bytes) {
  constexpr std::size_t kLeastOfStep = 2;
  ByteReader block(bytes);
  std::vector<StepRow> rows(block.count(kLeastOfStep));
  (void)block.blob();  // calls
  (void)block.blob();  // objects
  ByteReader events(block.blob());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].step = static_cast<std::uint32_t>(k + 1);
    rows[k].first_event = k == 0 ? 0 : rows[k - 1].first_event + rows[k - 1].events;
    rows[k].events = ByteReader(events).varint();
    (void)get_events(events, rows[k]);
  }
  return rows;
}

}  // namespace

std::string block_case(CaseBytes bytes) {
  try {
    BlockDecoder<2> decoder(VolumeKind::box);
    std::vector<RecordedStep<2>> steps;
    decoder.read(compress(bytes), fitting_rows(bytes), steps);
    return run(steps);
  } catch (const std::runtime_error& error) {
    return error.what()[0] == '\0' ? "an error without a message" : "";
  }
}

}  // namespace kerf::test
