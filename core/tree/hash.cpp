#include "core/tree/hash.h"

#include <xxhash.h>

#include <bit>
#include <memory>

namespace kerf {
namespace {

/// Numbers one after another, no more than were announced; structs are never hashed whole, since their
/// padding says nothing.
class Words {
 public:
  explicit Words(std::size_t most) : words_(std::make_unique_for_overwrite<std::uint64_t[]>(most)) {}
  void add(std::uint64_t word) { words_[size_++] = word; }
  void add(Scalar x, Scalar y) {
    add((std::uint64_t{std::bit_cast<std::uint32_t>(x)} << 32U) | std::bit_cast<std::uint32_t>(y));
  }
  void add(std::uint32_t x, std::uint32_t y) { add((std::uint64_t{x} << 32U) | y); }
  [[nodiscard]] std::uint64_t hash() const { return XXH3_64bits(words_.get(), size_ * sizeof(words_[0])); }

 private:
  std::unique_ptr<std::uint64_t[]> words_;
  std::size_t size_ = 0;
};

/// As many words as a tree can give: see `add_node` and `hash`.
template <int D>
std::size_t most_words(const Tree<D>& tree) {
  const auto extra = static_cast<std::size_t>(extra_size<D>(tree.table.kind()));
  std::size_t most = (1 + D + extra) * tree.table.bound();
  for_each_node(tree, tree.root(), [&](NodeId id) { most += 4 + 3 * tree[id].entries.size(); });
  return most;
}

template <int D>
void add_node(Words& words, const Tree<D>& tree, NodeId id) {
  const Node<D>& node = tree[id];
  words.add(id.value, node.generation);
  words.add(node.direction, node.population);
  words.add(node.retry_step, node.refusals);
  if (!node.is_leaf()) {
    words.add(node.plane.offset, Scalar{0});
    return;
  }
  words.add(node.entries.size());
  for (const Entry& entry : node.entries) {
    words.add(entry.key.lo, entry.key.hi);
    words.add(entry.straddle);
    words.add(entry.object.value);
  }
}

}  // namespace

template <int D>
std::uint64_t hash(const Tree<D>& tree) {
  Words words(most_words(tree));
  for_each_node(tree, tree.root(), [&](NodeId id) { add_node(words, tree, id); });
  for (std::uint32_t id = 0; id < tree.table.bound(); ++id) {
    const ObjectId object{id};
    const auto state = static_cast<std::uint32_t>(tree.table.state(object));
    words.add(state, tree.table.is_fixed(object) ? 1U : 0U);
    if (!tree.table.is_placed(object)) continue;
    for (int axis = 0; axis < D; ++axis)
      words.add(tree.table.box(object).min[axis], tree.table.box(object).max[axis]);
    for (int k = 0; k < extra_size<D>(tree.table.kind()); ++k)
      words.add(tree.table.extra(object)[k], Scalar{0});
  }
  return words.hash();
}

template std::uint64_t hash<2>(const Tree<2>&);
template std::uint64_t hash<3>(const Tree<3>&);

}  // namespace kerf
