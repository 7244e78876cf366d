#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/world/handle.h"

namespace kerf {

/// Gives indices and handles, and knows which of them live. The index of an object that a step has seen is
/// given again after the next step only, so that a step can report pairs of both lives; that of any other
/// object at once. The index freed last is given first.
class Slots {
 public:
  explicit Slots(std::uint8_t tag = 0) : tag_(tag) {}

  [[nodiscard]] bool contains(Handle handle) const {
    return handle.index() < keys_.size() && keys_[handle.index()] == handle.value;
  }
  [[nodiscard]] bool is_alive(std::uint32_t index) const {
    return (keys_[index] & Handle::kMaxIndex) == index;
  }
  /// Of the object that has the index, or had it last.
  [[nodiscard]] Handle handle(std::uint32_t index) const {
    return {is_alive(index) ? keys_[index] : ~keys_[index]};
  }
  /// Alive or not.
  [[nodiscard]] std::size_t size() const { return keys_.size(); }
  [[nodiscard]] std::size_t alive() const { return alive_; }
  template <class Visit>
  void for_each(Visit visit) const {
    for (std::uint32_t i = 0; i < keys_.size(); ++i)
      if (is_alive(i)) visit(Handle{keys_[i]});
  }

  /// The handle that `take` gives next; none if there is no index left. Makes room for it.
  [[nodiscard]] Handle peek();
  /// The handle that `peek` gave is alive now.
  void take();
  /// The object of the handle, which is alive, lives no more.
  void release(Handle handle);
  /// A step has seen all objects.
  void finish_step();

  /// As numbers for a state between two steps: handles by index, complemented for the dead, and the free
  /// indices.
  [[nodiscard]] std::span<const std::uint64_t> keys() const { return keys_; }
  [[nodiscard]] std::span<const std::uint32_t> free() const { return free_; }
  /// Whether these numbers can be a state; takes them if so.
  [[nodiscard]] bool restore(std::vector<std::uint64_t> keys, std::vector<std::uint32_t> free);

 private:
  std::vector<std::uint64_t> keys_;  ///< by index: the handle; complemented if dead, so that none is equal
  std::vector<std::uint8_t> seen_;   ///< by index: by a step
  std::vector<std::uint32_t> free_;
  std::vector<std::uint32_t> leaving_;  ///< free after the next step
  std::size_t alive_ = 0;
  std::uint8_t tag_;
};

}  // namespace kerf
