#include "core/tree/hash.h"

#if defined(__x86_64__)
#include <xxh_x86dispatch.h>  // the same functions for the processor's vectors
#else
#include <xxhash.h>
#endif

#include <array>
#include <bit>
#include <memory>
#include <new>

namespace kerf {
namespace {

/// Numbers one after another; structs are never hashed whole, since their padding is undefined.
class Words {
 public:
  Words() : state_(XXH3_createState()) {
    if (state_ == nullptr) throw std::bad_alloc();
    XXH3_64bits_reset(state_.get());
  }
  /// Words that belong together: there is room for all of them or for none.
  template <class... Word>
  void add(Word... words) {
    if (size_ + sizeof...(words) > words_.size()) digest_words();
    std::uint64_t* end = words_.data() + size_;
    ((*end++ = words), ...);
    size_ += sizeof...(words);
  }
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

std::uint64_t word(std::uint32_t x, std::uint32_t y) { return (std::uint64_t{x} << 32U) | y; }
std::uint64_t word(Scalar x, Scalar y) {
  return word(std::bit_cast<std::uint32_t>(x), std::bit_cast<std::uint32_t>(y));
}

/// Minimum and maximum of each axis, as bits of the packed box: through floats they would wait for one
/// another.
template <int D>
void add_box(Words& words, const PackedBox<D>& box) {
  constexpr std::uint32_t kSign = 1U << 31U;
  const auto bits = [&box](std::size_t lane) { return std::bit_cast<std::uint32_t>(box.lane[lane]); };
  for (std::size_t axis = 0; axis < D; ++axis)
    words.add(word(bits(axis), bits(PackedBox<D>::kHalf + axis) ^ kSign));
}

template <int D>
void add_node(Words& words, const Tree<D>& tree, NodeId id) {
  const Node<D>& node = tree[id];
  words.add(word(id.value, node.generation), word(node.direction, node.population),
            word(node.retry_step, node.refusals));
  if (!node.is_leaf()) {
    words.add(word(node.plane.offset, Scalar{0}));
    return;
  }
  words.add(node.entries.size());
  for (const Entry& entry : node.entries)
    words.add(word(entry.key.lo, entry.key.hi), entry.straddle, entry.object.value);
}

}  // namespace

template <int D>
std::uint64_t hash(const Tree<D>& tree) {
  Words words;
  for_each_node(tree, tree.root(), [&](NodeId id) { add_node(words, tree, id); });
  for (std::uint32_t id = 0; id < tree.table.bound(); ++id) {
    const ObjectId object{id};
    const auto state = static_cast<std::uint32_t>(tree.table.state(object));
    words.add(word(state, tree.table.is_fixed(object) ? 1U : 0U));
    if (!tree.table.is_placed(object)) continue;
    add_box(words, tree.table.packed(object));
    for (int k = 0; k < extra_size<D>(tree.table.kind()); ++k)
      words.add(word(tree.table.extra(object)[k], Scalar{0}));
  }
  return words.hash();
}

template std::uint64_t hash<2>(const Tree<2>&);
template std::uint64_t hash<3>(const Tree<3>&);

}  // namespace kerf
