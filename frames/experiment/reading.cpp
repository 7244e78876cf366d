#include "frames/experiment/reading.h"

#include <algorithm>
#include <array>

namespace kerf {
namespace {

constexpr std::array<Reading, 8> kReadings{
    {{"kerf-paper", "kerf-paper as it is",
      "\"2.5% increase on the number of objects\": of the node's own. 4.5, a swap is fast \"since this "
      "subtree is nearly empty\": only nodes are swapped of which one side has at most a tenth of the "
      "other's objects. Thresholds are the root of the scene's objects, from 16 to 128; candidates are "
      "judged on 256 objects"},
     {"kerf-paper:swap_share=1", "swap at once",
      "5.2, \"performed when balancing fails\": whatever both sides have"},
     {"kerf-paper:swap_share=1:swap_rest=10", "swap at once, then rest",
      "likewise, and a leaf that a swap left is not split for ten scheduling intervals"},
     {"kerf-paper:scene_redundancy=1", "2.5 % of the scene",
      "\"2.5% increase on the number of objects\": of the scene's, 106 of 4,250, at each node"},
     {"kerf-paper:max_redundancy=1:max_entries=1.025", "2.5 % of all entries",
      "\"2.5% increase on the number of objects\": all entries of the tree together"},
     {"kerf-paper:min_threshold=16:max_threshold=16", "t is 16", "\"t from 16 to 128\": the least one"},
     {"kerf-paper:min_threshold=128:max_threshold=128", "t is 128", "\"t from 16 to 128\": the greatest one"},
     {"kerf-paper:sample=1000000", "no subset", "4.1, \"a subset of these objects\": all of them"}}};

}  // namespace

std::span<const Reading> readings() { return kReadings; }

ReadingShape shape_of(const ExperimentRun& run, std::string_view contestant) {
  const auto index =
      static_cast<std::size_t>(std::ranges::find(contestants(), contestant) - contestants().begin());
  const auto settled = std::span(run).subspan(run.size() / 3);
  const auto leaves = [&](const ExperimentStep& row) { return row.contestants[index].leaves; };
  const auto depth = [&](const ExperimentStep& row) { return row.contestants[index].height; };
  const auto [fewest, most] = std::ranges::minmax(settled, {}, leaves);
  const auto [lowest, highest] = std::ranges::minmax(settled, {}, depth);
  return {double{1} * leaves(fewest), double{1} * leaves(most), double{1} * depth(lowest),
          double{1} * depth(highest)};
}

}  // namespace kerf
