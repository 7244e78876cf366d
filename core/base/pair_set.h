#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/base/ids.h"

namespace kerf {

/// A set of pairs that can be read as a list. Adding or removing a pair twice has the effect of once.
class PairSet {
 public:
  void add(const Pair& pair) {
    if (places_.emplace(key(pair), static_cast<std::uint32_t>(pairs_.size())).second) pairs_.push_back(pair);
  }
  void remove(const Pair& pair) {
    const auto found = places_.find(key(pair));
    if (found == places_.end()) return;
    const std::uint32_t place = found->second;
    places_.erase(found);
    if (place + 1 < pairs_.size()) {
      pairs_[place] = pairs_.back();
      places_[key(pairs_[place])] = place;
    }
    pairs_.pop_back();
  }
  /// Removes each pair for which `is_gone(pair)` holds.
  template <class Predicate>
  void remove_if(Predicate is_gone) {
    for (std::size_t k = pairs_.size(); k-- > 0;) {
      const Pair pair = pairs_[k];
      if (is_gone(pair)) remove(pair);
    }
  }

  /// The order depends on earlier additions and removals.
  [[nodiscard]] std::span<const Pair> pairs() const { return pairs_; }

 private:
  static std::uint64_t key(const Pair& pair) { return std::uint64_t{pair.a.value} << 32U | pair.b.value; }

  std::vector<Pair> pairs_;
  std::unordered_map<std::uint64_t, std::uint32_t> places_;
};

}  // namespace kerf
