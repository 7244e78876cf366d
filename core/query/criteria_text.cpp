#include "core/query/criteria_text.h"

#include <algorithm>

#include "core/base/counted.h"
#include "core/query/text.h"
#include "core/tree/criteria.h"

namespace kerf {
namespace {

std::string percent(double share) { return number_text(100 * share) + " %"; }

double share_of_straddlers(const Quality& q) {
  return q.population == 0 ? 0 : static_cast<double>(redundancy(q)) / q.population;
}

template <int D>
std::string leaf_wish(const Tree<D>& tree, NodeId id, const Config& config, const GivenNames& names) {
  const std::uint32_t threshold = split_threshold(tree.objects(), config);
  const std::string figures = counted(tree[id].population, "object") + ", and the threshold for " +
                              std::to_string(tree.objects()) + " in the scene is " +
                              std::to_string(threshold);
  if (!wants_split(tree, id, config)) return "a leaf that may stay: it has " + figures;
  std::string text = "a leaf that is crowded: it has " + figures;
  if (tree[id].refusals > 0)
    text += "; " + counted(tree[id].refusals, "split was", "splits were") +
            " refused, the next is tried from " + names.coming_step(tree[id].retry_step);
  return text;
}

template <int D>
std::string repair_wish(const Tree<D>& tree, NodeId id, const Config& config) {
  const Quality q = quality(tree, id);
  if (balance(q) < config.min_balance)
    return "unbalanced: its balance " + number_text(static_cast<double>(balance(q))) + " is below " +
           number_text(static_cast<double>(config.min_balance));
  return "cut through: " + percent(share_of_straddlers(q)) + " of its objects are on both sides, more than " +
         percent(static_cast<double>(repair_limit(tree, id, config)));
}

}  // namespace

std::string quality_text(const Quality& q) {
  return counted(q.population, "object") + " (" + std::to_string(q.left) + " | " + std::to_string(q.right) +
         "), balance " + number_text(static_cast<double>(balance(q))) + ", " +
         counted(redundancy(q), "straddler") + " (" + percent(share_of_straddlers(q)) + ")";
}

template <int D>
std::string criterion_text(const Tree<D>& tree, NodeId id, const Config& config, const GivenNames& names) {
  if (tree[id].is_leaf()) return leaf_wish(tree, id, config, names);
  if (wants_repair(tree, id, config)) return repair_wish(tree, id, config);
  const std::uint32_t least = merge_threshold(tree.objects(), config);
  if (wants_merge(tree, id, config))
    return "thin: " + counted(tree[id].population, "object is", "objects are") + " fewer than the " +
           std::to_string(least) + " below which nodes are merged";
  return "good as it is";
}

template <int D>
std::string wish_text(const Tree<D>& tree, NodeId id, const Config& config, const GivenNames& names) {
  std::string text = criterion_text(tree, id, config, names);
  if (!config.swap || !wants_repair(tree, id, config) || wants_swap(tree, id, config)) return text;
  const Quality q = quality(tree, id);
  const std::uint32_t heavy = std::max(q.left, q.right);
  return text + "; if no shift of its partitioner is good it stays, since a swap would insert " +
         std::to_string(q.population - heavy) + " objects beside " + std::to_string(heavy) + ", more than " +
         percent(static_cast<double>(config.swap_share));
}

#define KERF_INSTANTIATE(D)                                                                         \
  template std::string criterion_text<D>(const Tree<D>&, NodeId, const Config&, const GivenNames&); \
  template std::string wish_text<D>(const Tree<D>&, NodeId, const Config&, const GivenNames&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
