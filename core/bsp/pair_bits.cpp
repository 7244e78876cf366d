#include "core/bsp/pair_bits.h"

#include <bit>

#include "core/kernels/overlap_rows.h"

namespace kerf {
namespace {

constexpr std::size_t kWordBits = 64;

constexpr std::uint64_t bit(std::size_t object) { return std::uint64_t{1} << object % kWordBits; }

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
  words_ = (blocks_.size() * kBlockWidth + kWordBits - 1) / kWordBits;
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
void PairBits<D>::note(std::span<const ObjectId> changed) {
  if (known_) changed_.insert(changed_.end(), changed.begin(), changed.end());
}

template <int D>
void PairBits<D>::find(const ObjectTable<D>& table, PairBuffer& pairs) {
  bool differs = pairs.size() != listed_;
  if (changed_.empty() && !differs) return;
  for (const ObjectId object : changed_) write_box(table, object);
  fresh_.resize(changed_.size() * words_);
  overlap_rows<D>(blocks_, changed_, fresh_.data());
  for (std::size_t k = 0; k < changed_.size(); ++k)
    differs |= take_row(table, changed_[k], fresh_.data() + k * words_);
  changed_.clear();
  if (differs) list(table.bound(), pairs);
}

template <int D>
void PairBits<D>::write_box(const ObjectTable<D>& table, ObjectId object) {
  const bool is_placed = table.is_placed(object);
  WideBlock<D>& block = blocks_[object.index() / kBlockWidth];
  const std::size_t slot = object.index() % kBlockWidth;
  is_placed ? block.set(slot, table.box(object)) : block.set(slot, WideBlock<D>::no_box());
  if (table.has_fixed()) set(fixed_.data(), object.index(), is_placed && table.is_fixed(object));
}

/// Returns whether it differs from the object's row before.
template <int D>
bool PairBits<D>::take_row(const ObjectTable<D>& table, ObjectId object, std::uint64_t* fresh) {
  set(fresh, object.index(), false);
  const bool is_fixed = table.has_fixed() && table.is_fixed(object);
  std::uint64_t* const own = row(object.index());
  std::uint64_t any = 0;
  for (std::size_t word = 0; word < words_; ++word) {
    if (is_fixed) fresh[word] &= ~fixed_[word];
    std::uint64_t differs = own[word] ^ fresh[word];
    any |= differs;
    own[word] = fresh[word];
    for (; differs != 0; differs &= differs - 1) {
      const std::size_t other = word * kWordBits + static_cast<std::size_t>(std::countr_zero(differs));
      row(other)[object.index() / kWordBits] ^= bit(object.index());
    }
  }
  return any != 0;
}

template <int D>
void PairBits<D>::list(std::size_t objects, PairBuffer& pairs) {
  pairs.clear();
  for (std::uint32_t a = 0; a < objects; ++a) {
    const std::uint64_t* const own = row(a);
    const std::size_t first = a / kWordBits;
    const std::uint64_t behind = own[first] & ~(bit(a) | (bit(a) - 1));
    if (behind != 0) append_pairs({a}, first * kWordBits, behind, pairs);
    for (std::size_t word = first + 1; word < words_; ++word)
      if (own[word] != 0) append_pairs({a}, word * kWordBits, own[word], pairs);
  }
  listed_ = pairs.size();
}

template class PairBits<2>;
template class PairBits<3>;

}  // namespace kerf
