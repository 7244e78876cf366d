#pragma once

#include <compare>
#include <cstdint>
#include <functional>

namespace kerf {

/// Names one object of a World for as long as it lives. A world gives handles and checks each that it gets:
/// the handle of a removed object never names a later one. 64 bits, so that it fits where a pointer does.
///
/// `value` is index | generation << 28 | tag << 56. Indices are dense: those of removed objects are used
/// again. One that a step has seen is given only after the next step: read `ended()` before you insert.
struct Handle {
  static constexpr unsigned kIndexBits = 28;
  static constexpr unsigned kGenerationBits = 28;
  static constexpr std::uint32_t kMaxIndex = (1U << kIndexBits) - 1;
  static constexpr std::uint32_t kMaxGeneration = (1U << kGenerationBits) - 1;

  std::uint64_t value = 0;  ///< 0 names nothing

  [[nodiscard]] constexpr bool is_none() const { return value == 0; }
  /// For arrays of the caller's, one element an object. Less than World::bound().
  [[nodiscard]] constexpr std::uint32_t index() const {
    return static_cast<std::uint32_t>(value) & kMaxIndex;
  }
  /// Counts the lives of the index, from 1.
  [[nodiscard]] constexpr std::uint32_t generation() const {
    return static_cast<std::uint32_t>(value >> kIndexBits) & kMaxGeneration;
  }
  /// WorldOptions::tag of the world that gave it.
  [[nodiscard]] constexpr std::uint8_t tag() const {
    return static_cast<std::uint8_t>(value >> (kIndexBits + kGenerationBits));
  }
  friend constexpr auto operator<=>(Handle, Handle) = default;
};

constexpr Handle make_handle(std::uint32_t index, std::uint32_t generation, std::uint8_t tag) {
  constexpr unsigned kTagShift = Handle::kIndexBits + Handle::kGenerationBits;
  return {index | std::uint64_t{generation} << Handle::kIndexBits | std::uint64_t{tag} << kTagShift};
}

}  // namespace kerf

template <>
struct std::hash<kerf::Handle> {
  std::size_t operator()(kerf::Handle handle) const noexcept {
    return std::hash<std::uint64_t>{}(handle.value);
  }
};
