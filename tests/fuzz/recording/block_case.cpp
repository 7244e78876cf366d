#include <algorithm>
#include <stdexcept>

#include "core/bsp/bsp.h"
#include "core/recording/block_codec.h"
#include "core/recording/compression.h"
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

}  // namespace

std::string block_case(CaseBytes bytes) {
  try {
    BlockDecoder<2> decoder(VolumeKind::box);
    std::vector<RecordedStep<2>> steps;
    decoder.read(compress(bytes), 1, 0, steps);
    return run(steps);
  } catch (const std::runtime_error& error) {
    return error.what()[0] == '\0' ? "an error without a message" : "";
  }
}

}  // namespace kerf::test
