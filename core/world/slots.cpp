#include "core/world/slots.h"

#include <algorithm>
#include <utility>

namespace kerf {

Handle Slots::peek() {
  if (!free_.empty()) {
    const Handle last = handle(free_.back());
    return make_handle(last.index(), last.generation() + 1, tag_);
  }
  if (keys_.size() >= Handle::kMaxIndex) return {};
  const std::size_t count = keys_.size() + 1;
  if (count > keys_.capacity()) {
    // Room for every index in each list: no `release` allocates.
    const std::size_t room = 2 * count;
    free_.reserve(room);
    leaving_.reserve(room);
    seen_.reserve(room);
    keys_.reserve(room);
  }
  return make_handle(static_cast<std::uint32_t>(keys_.size()), 1, tag_);
}

void Slots::take() {
  const Handle given = peek();
  if (free_.empty()) {
    keys_.push_back(given.value);
    seen_.push_back(0);
  } else {
    free_.pop_back();
    keys_[given.index()] = given.value;
    seen_[given.index()] = 0;
  }
  ++alive_;
}

void Slots::release(Handle handle) {
  const std::uint32_t index = handle.index();
  keys_[index] = ~handle.value;
  --alive_;
  if (seen_[index] != 0) {
    leaving_.push_back(index);
  } else if (handle.generation() < Handle::kMaxGeneration) {
    free_.push_back(index);
  }
}

void Slots::finish_step() {
  for (const std::uint32_t index : leaving_)
    if (handle(index).generation() < Handle::kMaxGeneration) free_.push_back(index);
  leaving_.clear();
  std::ranges::fill(seen_, std::uint8_t{1});
}

bool Slots::restore(std::vector<std::uint64_t> keys, std::vector<std::uint32_t> free) {
  if (keys.size() > Handle::kMaxIndex || free.size() > keys.size()) return false;
  Slots restored(tag_);
  restored.keys_ = std::move(keys);
  for (std::uint32_t i = 0; i < restored.keys_.size(); ++i) {
    const Handle handle = restored.handle(i);
    if (handle.index() != i || handle.generation() == 0 || handle.tag() != tag_) return false;
    if (restored.is_alive(i)) ++restored.alive_;
  }
  std::vector<std::uint8_t> is_free(restored.keys_.size(), 0);
  for (const std::uint32_t i : free) {
    if (i >= is_free.size() || is_free[i] != 0 || restored.is_alive(i)) return false;
    if (restored.handle(i).generation() >= Handle::kMaxGeneration) return false;
    is_free[i] = 1;
  }
  for (std::uint32_t i = 0; i < is_free.size(); ++i)
    if (is_free[i] == 0 && !restored.is_alive(i) && restored.handle(i).generation() < Handle::kMaxGeneration)
      return false;
  restored.seen_.assign(restored.keys_.size(), 1);
  free.reserve(restored.keys_.capacity());
  restored.leaving_.reserve(restored.keys_.capacity());
  restored.seen_.reserve(restored.keys_.capacity());
  restored.free_ = std::move(free);
  *this = std::move(restored);
  return true;
}

}  // namespace kerf
