#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace kerf {

/// Every tunable of the tree, with the values of the paper (section 6.1) as defaults. Where the paper leaves
/// a number open, our reading stands beside it.
struct Config {
  // Choice of a partitioner (section 3.2).
  float candidate_factor = 2.0F;  ///< candidates tried at a split: factor * sqrt(objects of the leaf) (6.1)
  std::uint32_t sample = 256;     ///< objects projected and sorted for each candidate (4.1: "a subset")
  bool free_directions = true;    ///< false: only partitioners along the axes

  // Goodness (sections 3.2 and 6.1).
  float min_balance = 0.5F;       ///< below it a node is unbalanced (6.1)
  float max_redundancy = 0.025F;  ///< straddlers of a partitioner over its population (6.1)
  bool scene_redundancy = false;  ///< true: over the objects of the scene (6.1: "a 2.5% increase on the
                                  ///< number of objects")

  float repair_redundancy =
      0.5F;  ///< above it a node is repaired like an unbalanced one (ours: the paper names no cure)

  // Thresholds (6.1: "t from 16 to 128 ... depending on the number of objects").
  std::uint32_t min_threshold = 16;   ///< smallest split threshold; t = clamp(sqrt(objects), min, max)
  std::uint32_t max_threshold = 128;  ///< largest split threshold
  float merge_fraction = 0.5F;  ///< nodes below merge_fraction * t are merged; the gap is the hysteresis

  // Scheduling (section 5.2 and 6.1).
  std::uint32_t event_capacity = 64;  ///< largest size of the event list
  std::uint32_t budget_divisor = 16;  ///< events a step: ceil(list size / divisor); 0 switches operators off
  std::uint32_t schedule_interval = 10;  ///< steps between two traversals of Algorithm 1

  // Which operators may act: all do in the paper; to see what each of them earns, switch one off.
  bool split = true;        ///< without it, nothing is ever divided
  bool shift_split = true;  ///< without it, a crowded leaf is split by a new direction at once
  bool merge = true;        ///< off: only entries beyond their cap are merged away
  bool balance = true;      ///< without it, an unbalanced node is swapped at once
  bool swap = true;         ///< without it, a node that cannot be balanced stays as it is

  // When a swap acts, and what follows it (4.5).
  float swap_share = 0.1F;  ///< objects that a swap may insert into the heavier subtree, over those that it
                            ///< has (4.5: the other one "is nearly empty"); 1: whenever balancing fails
  std::uint32_t swap_rest = 0;  ///< scheduling intervals in which a leaf that a swap moved up is not split

  // Limits that the paper asks for without a number (sections 6.2 and 7).
  std::uint32_t max_height = 40;   ///< no split at or below this depth; at most 63
  float max_entries = 4.0F;        ///< no split once entries exceed this many times the objects; beyond twice
                                   ///< as many, straddled nodes are merged at once
  std::uint32_t directions = 256;  ///< size of the direction set (3D; 2D uses a quarter)
  std::uint64_t seed = 1;          ///< of the direction set

  // Policies beyond the paper, all off by default. `tuned_config` switches them on.
  bool byte_sweep = false;  ///< leaves are swept by vectors of bytes instead of along ordered lists
  float skin = 0;           ///< with byte_sweep: steps of its own motion that an object's fat box allows for
  float stream_share = 1;   ///< with byte_sweep: when more objects than this share move in a step, all are
                           ///< placed anew in one pass; while pairs of fat boxes are kept, when four times as
                           ///< many leave theirs; 1: only when the mode changes
  float bulk_factor = 0;  ///< a leaf above so many times the threshold is divided at once, until none of its
                          ///< parts is above the threshold, whatever the budget; 0: never

  // Parts of these policies. Each is on, and is of use only with its policy; to see what it earns, switch it
  // off.
  bool restless = true;       ///< with skin: the tree follows objects that are too fast for a fat box; else
                              ///< each is placed anew in each step
  bool resting_pairs = true;  ///< with skin: pairs of objects without fat are reported without a test
  bool leaf_boxes = true;     ///< with byte_sweep: in large worlds leaves have copies of their boxes
  bool rows = true;           ///< with byte_sweep: a small world of which little moves has its pairs as bits
  bool dense = true;          ///< where boxes lie dense, bytes decide most pairs without a test of floats

  friend bool operator==(const Config&, const Config&) = default;
};

/// The fastest configuration that we know for boxes: axis directions, large leaves, all policies beyond the
/// paper.
Config tuned_config();

/// Throws std::invalid_argument, naming the parameter and its range, when a value cannot work.
void check(const Config& config);

/// The description of one parameter: name, meaning, and the range of its values.
struct ConfigField {
  std::string_view name;
  std::string_view meaning;
  double minimum;
  double maximum;
};

/// All parameters in the order of `Config`.
std::span<const ConfigField> config_fields();
/// The value of parameter `name` as text. Throws std::invalid_argument for an unknown name.
std::string get(const Config& config, std::string_view name);
/// Sets one parameter from text. Throws std::invalid_argument with a message that names the parameter, what
/// was given and what is allowed; `config` is then unchanged.
void set(Config& config, std::string_view name, std::string_view value);
/// Applies "K=V,K=V,..."; later ones win. All or nothing; throws std::invalid_argument as `set` does.
void apply(Config& config, std::string_view assignments);
/// All parameters as "K=V,K=V,...", such that `apply` on a default Config gives this one.
std::string to_string(const Config& config);

}  // namespace kerf
