#include "core/bsp/pair_bits.h"

#include <bit>

#include "core/kernels/overlap_rows.h"

namespace kerf {
namespace {

constexpr std::size_t kWordBits = 64;

constexpr std::uint64_t bit(std::size_t object) { return std::uint64_t{1} << object % kWordBits; }

/// The bits of the objects behind this one in its word.
constexpr std::uint64_t bits_behind(std::size_t object) { return ~(bit(object) | (bit(object) - 1)); }

void set(std::uint64_t* row, std::size_t object, bool on) {
  std::uint64_t& word = row[object / kWordBits];
  word = on ? word | bit(object) : word & ~bit(object);
}

/// Appends the pairs of an object with those whose bits are set; `base`: of which the first bit is.
void append_pairs(ObjectId object, std::size_t base, std::uint64_t bits, PairBuffer& pairs) {
  Pair* const out = pairs.reserve(kWordBits);
  std::size_t count = 0;
  for (; bits != 0; bits &= bits - 1)
    out[count++] = {object,
                    {static_cast<std::uint32_t>(base + static_cast<std::size_t>(std::countr_zero(bits)))}};
  pairs.commit(count);
}

}  // namespace

template <int D>
void PairBits<D>::take(const ObjectTable<D>& table, std::span<const Pair> pairs) {
  blocks_.resize((table.bound() + kBlockWidth - 1) / kBlockWidth);
  words_ = words_of_row(blocks_.size());
  fixed_.assign(words_, 0);
  bits_.assign(blocks_.size() * kBlockWidth * words_, 0);
  for (std::uint32_t id = 0; id < blocks_.size() * kBlockWidth; ++id) write_box(table, {id});
  for (const auto& [a, b] : pairs) {
    set(row(a.index()), b.index(), true);
    set(row(b.index()), a.index(), true);
  }
  changed_.clear();
  listed_ = pairs.size();
  known_ = true;
}

template <int D>
void PairBits<D>::expect_changes(std::span<const ObjectId> changed) {
  if (known_) changed_.insert(changed_.end(), changed.begin(), changed.end());
}

template <int D>
void PairBits<D>::find(const ObjectTable<D>& table, PairBuffer& pairs) {
  bool differs = pairs.size() != listed_;
  if (changed_.empty() && !differs) return;
  const bool only_later = write_boxes(table);
  fresh_.resize(changed_.size() * words_);
  overlap_rows<D>(blocks_, changed_, only_later, fresh_.data());
  for (std::size_t k = 0; k < changed_.size(); ++k)
    differs |= take_row(table, changed_[k], only_later, fresh_.data() + k * words_);
  changed_.clear();
  if (differs) list(table.bound(), pairs);
}

/// Those of the changed objects. Returns whether no placed object is missing among them: then each pair is
/// found by the earlier of its two.
template <int D>
bool PairBits<D>::write_boxes(const ObjectTable<D>& table) {
  std::size_t placed = 0;
  bool ascend = true;  // none is listed twice
  std::size_t least = 0;
  for (const ObjectId object : changed_) {
    placed += write_box(table, object) ? 1U : 0U;
    ascend &= object.index() >= least;
    least = object.index() + 1;
  }
  return ascend && placed == table.size();
}

/// Returns whether the object is placed.
template <int D>
bool PairBits<D>::write_box(const ObjectTable<D>& table, ObjectId object) {
  const bool is_placed = table.is_placed(object);
  WideBlock<D>& block = blocks_[object.index() / kBlockWidth];
  const std::size_t slot = object.index() % kBlockWidth;
  is_placed ? block.set(slot, table.box(object)) : block.set(slot, WideBlock<D>::no_box());
  if (table.has_fixed()) set(fixed_.data(), object.index(), is_placed && table.is_fixed(object));
  return is_placed;
}

/// Returns whether it differs from the object's row before. `only_later`: as far as it is behind the object.
template <int D>
bool PairBits<D>::take_row(const ObjectTable<D>& table, ObjectId object, bool only_later,
                           std::uint64_t* fresh) {
  std::uint64_t* const own = row(object.index());
  const std::size_t own_word = object.index() / kWordBits;
  const std::size_t first = only_later ? own_word : 0;
  const std::uint64_t asked = only_later ? bits_behind(object.index()) : ~bit(object.index());
  fresh[own_word] = (fresh[own_word] & asked) | (own[own_word] & ~asked);
  if (table.has_fixed() && table.is_fixed(object))
    for (std::size_t word = first; word < words_; ++word) fresh[word] &= ~fixed_[word];
  std::size_t word = first;
  while (word < words_ && own[word] == fresh[word]) ++word;
  if (word == words_) return false;
  change_row(object, word, fresh);
  return true;
}

/// From a word on. What changes in the object's row changes in the rows of the others.
template <int D>
void PairBits<D>::change_row(ObjectId object, std::size_t word, const std::uint64_t* fresh) {
  std::uint64_t* const own = row(object.index());
  for (; word < words_; ++word) {
    std::uint64_t differs = own[word] ^ fresh[word];
    own[word] = fresh[word];
    for (; differs != 0; differs &= differs - 1) {
      const std::size_t other = word * kWordBits + static_cast<std::size_t>(std::countr_zero(differs));
      row(other)[object.index() / kWordBits] ^= bit(object.index());
    }
  }
}

template <int D>
void PairBits<D>::list(std::size_t objects, PairBuffer& pairs) {
  pairs.clear();
  for (std::uint32_t a = 0; a < objects; ++a) {
    const std::uint64_t* const own = row(a);
    const std::size_t first = a / kWordBits;
    const std::uint64_t behind = own[first] & bits_behind(a);
    if (behind != 0) append_pairs({a}, first * kWordBits, behind, pairs);
    for (std::size_t word = first + 1; word < words_; ++word)
      if (own[word] != 0) append_pairs({a}, word * kWordBits, own[word], pairs);
  }
  listed_ = pairs.size();
}

template class PairBits<2>;
template class PairBits<3>;

}  // namespace kerf
