#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/append_buffer.h"
#include "core/kernels/wide_block.h"
#include "core/objects/object_table.h"

namespace kerf {

/// The pairs of a small world as bits: a row for each object, and in it a bit for each other that overlaps
/// it. An object that moves is tested against all others by vectors, and the list of pairs is written anew
/// only if a bit changed. The pairs are those of the table's boxes, whatever the tree is like.
template <int D>
class PairBits {
 public:
  /// Whether the pairs are known, and there is room for all objects.
  [[nodiscard]] bool have_room(const ObjectTable<D>& table) const {
    return known_ && table.bound() <= blocks_.size() * kBlockWidth;
  }
  void forget() { known_ = false; }
  /// The pairs of the table's boxes are these.
  void take(const ObjectTable<D>& table, std::span<const Pair> pairs);
  /// The boxes of these objects change before the pairs are found next, or they come or go.
  void expect_changes(std::span<const ObjectId> changed);
  /// Makes `pairs`, those of the last step or none, the pairs of the table's boxes.
  void find(const ObjectTable<D>& table, PairBuffer& pairs);

 private:
  [[nodiscard]] std::uint64_t* row(std::size_t object) { return bits_.data() + object * words_; }
  [[nodiscard]] bool write_boxes(const ObjectTable<D>& table);
  bool write_box(const ObjectTable<D>& table, ObjectId object);
  [[nodiscard]] bool take_row(const ObjectTable<D>& table, ObjectId object, bool only_later,
                              std::uint64_t* fresh);
  void change_row(ObjectId object, std::size_t word, const std::uint64_t* fresh);
  void list(std::size_t objects, PairBuffer& pairs);

  bool known_ = false;
  std::size_t words_ = 0;             ///< of a row
  std::vector<WideBlock<D>> blocks_;  ///< the boxes by id
  std::vector<std::uint64_t> bits_;   ///< the rows; those of two objects agree
  std::vector<std::uint64_t> fixed_;  ///< a row: the fixed objects
  std::vector<std::uint64_t> fresh_;  ///< the rows of the changed objects, as they are now
  std::vector<ObjectId> changed_;
  std::size_t listed_ = 0;  ///< pairs in the list that was written last
};

}  // namespace kerf
