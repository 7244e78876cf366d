#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/kernels/search_blocks.h"

namespace kerf {

/// How soon a search hands on what it finds.
enum class HandOn : std::uint8_t { at_once, in_bulk };

/// Room for what a search finds, on the stack: it is handed on whenever it is full, and in the end.
template <class Number, class Take, class Confirm>
class FoundNumbers : public FoundRoom<Number> {
 public:
  using Room = FoundRoom<Number>;
  FoundNumbers(HandOn when, Take hand_on, Confirm asks) : take_(hand_on), confirm_(asks) {
    Room::next = numbers_.data();
    Room::limit = Room::next + (when == HandOn::at_once ? kBlockWidth : kMost);
    Room::make_room = [](Room& room) { return static_cast<FoundNumbers&>(room).flush(); };
    Room::confirm = [](Room& room, std::uint32_t slot) {
      return static_cast<FoundNumbers&>(room).confirm_(slot);
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
  Confirm confirm_;
  std::array<Number, kMost> numbers_;  // written before it is read
};

/// Where a search confirms nothing.
struct ConfirmNone {
  bool operator()(std::uint32_t /*slot*/) const { return false; }
};

/// Calls `find(room)`, then `take(numbers)` with what it found, part by part, until that returns false.
template <class Number, class Find, class Take, class Confirm = ConfirmNone>
void find_numbers(HandOn when, Find find, Take take, Confirm confirm = {}) {
  FoundNumbers<Number, Take, Confirm> room(when, take, confirm);
  find(room);
  room.flush();
}

/// Appends numbers as values of the same bits.
template <class Number, class Value>
void append_as(std::span<const Number> numbers, std::vector<Value>& values) {
  static_assert(sizeof(Number) == sizeof(Value));
  const std::size_t before = values.size();
  values.resize(before + numbers.size());
  std::ranges::transform(numbers, values.begin() + static_cast<std::ptrdiff_t>(before),
                         [](Number number) { return std::bit_cast<Value>(number); });
}

}  // namespace kerf
