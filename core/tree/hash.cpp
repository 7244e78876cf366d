#include "core/tree/hash.h"

#include <xxhash.h>

#include <array>
#include <bit>
#include <memory>
#include <new>

namespace kerf {
namespace {

/// Numbers one after another; structs are never hashed whole, since their padding says nothing.
class Words {
 public:
  Words() : state_(XXH3_createState()) {
    if (state_ == nullptr) throw std::bad_alloc();
    XXH3_64bits_reset(state_.get());
  }
  void add(std::uint64_t word) {
    if (size_ == words_.size()) digest_words();
    words_[size_++] = word;
  }
  void add(Scalar x, Scalar y) {
    add((std::uint64_t{std::bit_cast<std::uint32_t>(x)} << 32U) | std::bit_cast<std::uint32_t>(y));
  }
  void add(std::uint32_t x, std::uint32_t y) { add((std::uint64_t{x} << 32U) | y); }
  [[nodiscard]] std::uint64_t hash() {
    digest_words();
    return XXH3_64bits_digest(state_.get());
  }

 private:
  struct Free {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
  };

  void digest_words() {
    XXH3_64bits_update(state_.get(), words_.data(), size_ * sizeof(words_[0]));
    size_ = 0;
  }

  std::unique_ptr<XXH3_state_t, Free> state_;
  std::array<std::uint64_t, 512> words_;
  std::size_t size_ = 0;
};

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
  Words words;
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
