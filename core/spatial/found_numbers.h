#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/kernels/search_blocks.h"

namespace kerf {

/// How soon a search hands on what it finds.
enum class HandOn : std::uint8_t { at_once, in_bulk };

/// Room for what a search finds, on the stack: it is handed on whenever it is full, and in the end.
template <class Take>
class FoundNumbers : public FoundRoom {
 public:
  FoundNumbers(HandOn when, Take take) : take_(take) {
    next = numbers_.data();
    limit = next + (when == HandOn::at_once ? kBlockWidth : kMost);
    make_room = [](FoundRoom& room) { return static_cast<FoundNumbers&>(room).flush(); };
  }
  bool flush() {
    const bool goes_on = take_(std::span<const std::uint32_t>(numbers_.data(), next));
    next = numbers_.data();
    return goes_on;
  }

 private:
  static constexpr std::size_t kMost = 512;
  Take take_;
  std::array<std::uint32_t, kMost> numbers_;  // written before it is read
};

/// Calls `find(room)`, then `take(number)` for each number found, until it returns false.
template <class Find, class Take>
void find_numbers(HandOn when, Find find, Take take) {
  FoundNumbers room(
      when, [&](std::span<const std::uint32_t> numbers) { return std::ranges::all_of(numbers, take); });
  find(room);
  room.flush();
}

/// Appends what `find(room)` finds as objects.
template <class Find>
void append_numbers(Find find, std::vector<ObjectId>& objects) {
  FoundNumbers room(HandOn::in_bulk, [&](std::span<const std::uint32_t> numbers) {
    const std::size_t before = objects.size();
    objects.resize(before + numbers.size());
    std::ranges::transform(numbers, objects.begin() + static_cast<std::ptrdiff_t>(before),
                           [](std::uint32_t id) { return ObjectId{id}; });
    return true;
  });
  find(room);
  room.flush();
}

}  // namespace kerf
