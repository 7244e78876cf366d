#include "core/broad_phase/pair_changes.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace kerf {

void PairChanges::update(std::span<const Pair> pairs) {
  std::swap(before_, now_);
  order(pairs);
  begun_.clear();
  ended_.clear();
  std::set_difference(now_.begin(), now_.end(), before_.begin(), before_.end(), std::back_inserter(begun_));
  std::set_difference(before_.begin(), before_.end(), now_.begin(), now_.end(), std::back_inserter(ended_));
}

/// By the second object, then, stably, by the first.
void PairChanges::order(std::span<const Pair> pairs) {
  sort_.items.clear();
  for (const Pair& pair : pairs) sort_.items.push_back({pair.b.value, pair.a.value});
  sort_.sort();
  for (RadixSort::Item& item : sort_.items) std::swap(item.key, item.value);
  sort_.sort();
  now_.clear();
  for (const RadixSort::Item& item : sort_.items) now_.push_back({{item.key}, {item.value}});
}

}  // namespace kerf
