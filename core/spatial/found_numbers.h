#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "core/kernels/search_blocks.h"

namespace kerf {

/// How soon a search hands on what it finds.
enum class HandOn : std::uint8_t { at_once, in_bulk };

/// Where a search has nothing to confirm.
struct NothingToConfirm {};

/// Room for what a search finds, on the stack: it is handed on whenever a block might not find room in it,
/// and in the end.
template <class Number, class Take, class Confirm>
class FoundNumbers : public FoundRoom<Number> {
 public:
  using Room = FoundRoom<Number>;
  FoundNumbers(HandOn when, Take take, Confirm confirms) : take_(take), confirms_(confirms) {
    Room::next = numbers_.data();
    Room::limit = Room::next + (when == HandOn::at_once ? kBlockWidth : kMost);
    Room::make_room = [](Room& room) { return static_cast<FoundNumbers&>(room).flush(); };
    if constexpr (!std::is_same_v<Confirm, NothingToConfirm>)
      Room::confirm = [](Room& room, std::uint32_t slot) {
        return static_cast<FoundNumbers&>(room).confirms_(slot);
      };
  }
  bool flush() {
    const bool goes_on = take_(std::span<const Number>(numbers_.data(), Room::next));
    Room::next = numbers_.data();
    return goes_on;
  }

 private:
  static constexpr std::size_t kMost = 512;
  Take take_;
  Confirm confirms_;
  std::array<Number, kMost> numbers_;  // written before it is read
};

/// Calls `find(room)`, then `take(numbers)` with what it found, part by part, until that returns false.
template <class Number, class Find, class Take, class Confirm = NothingToConfirm>
void find_numbers(HandOn when, Find find, Take take, Confirm confirms = {}) {
  FoundNumbers<Number, Take, Confirm> room(when, take, confirms);
  find(room);
  room.flush();
}

}  // namespace kerf
