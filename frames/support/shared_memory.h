#pragma once

#include <cstddef>

namespace kerf {

/// Memory that this process shares with children forked later, zeroed. Throws std::runtime_error if there is
/// none.
class SharedMemory {
 public:
  explicit SharedMemory(std::size_t bytes);
  ~SharedMemory();
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  [[nodiscard]] std::byte* data() const { return data_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Maps all of it into this process now, so that no timing includes it later.
  void touch() const;

 private:
  std::byte* data_;
  std::size_t size_;
};

}  // namespace kerf
