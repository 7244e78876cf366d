#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/kernels/wide_block.h"
#include "core/objects/object_table.h"
#include "core/spatial/divide_objects.h"

namespace kerf {

/// The boxes of a table's objects in a hierarchy of blocks: each block but a few is full, and all objects lie
/// equally deep. It is built from above by medians; then motion only makes the bounds follow.
template <int D>
class BlockHierarchy {
 public:
  /// What an update had to do.
  enum class Update : std::uint8_t { refit, built };

  BlockHierarchy() { add_block({}, kBlockWidth, 0); }

  /// Takes the boxes of all placed objects. Builds the hierarchy anew if there are new ones, if most of the
  /// old ones have gone, or if motion made the bounds too large.
  Update update(const ObjectTable<D>& objects);
  /// The next update builds.
  void forget() { built_cost_ = 0; }

  [[nodiscard]] BlockView<D> view() const { return {blocks_.data(), root()}; }
  /// All of them: those whose items are objects, too.
  [[nodiscard]] std::span<const WideBlock<D>> blocks() const { return blocks_; }
  [[nodiscard]] bool has_objects(std::size_t block) const { return is_inner_[block] == 0; }
  /// Objects that are placed.
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] std::uint32_t root() const { return is_inner_.empty() ? 0 : is_inner_[0]; }
  void build(const ObjectTable<D>& objects);
  std::uint32_t add_block(std::span<CenteredObject<D>> objects, std::size_t room, std::uint32_t above);
  void add_children(std::span<CenteredObject<D>> objects, std::size_t room, std::size_t children,
                    std::uint32_t slot);
  std::size_t take_boxes(const ObjectTable<D>& objects, std::size_t block);
  void join_upwards();
  bool refit(const ObjectTable<D>& objects);

  std::vector<WideBlock<D>> blocks_;  ///< parents before children
  std::vector<std::uint32_t> above_;  ///< by block: the slot of its box in the parent
  std::vector<std::uint8_t> is_inner_;
  std::size_t size_ = 0;
  std::size_t slots_ = 0;  ///< objects when it was built
  double cost_ = 0;
  double built_cost_ = 0;
};

}  // namespace kerf
