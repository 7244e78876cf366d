#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>

#include "core/ids.h"

namespace kerf {

/// Values one after another. Kernels write behind the end and then say how many they wrote; memory is
/// initialised once at most and never given back.
template <class T>
class AppendBuffer {
 public:
  void clear() { size_ = 0; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::span<const T> all() const { return {data_.get(), size_}; }
  [[nodiscard]] std::span<T> all() { return {data_.get(), size_}; }

  /// Room for `count` more behind the end.
  T* reserve(std::size_t count) {
    if (capacity_ - size_ < count) grow(size_ + count);
    return data_.get() + size_;
  }
  /// The first `count` values behind the end are valid now.
  void commit(std::size_t count) { size_ += count; }
  void push_back(const T& value) {
    *reserve(1) = value;
    ++size_;
  }
  void append(std::span<const T> values) {
    std::copy(values.begin(), values.end(), reserve(values.size()));
    commit(values.size());
  }
  /// Forgets all but the first `size`.
  void truncate(std::size_t size) { size_ = size; }

 private:
  void grow(std::size_t least) {
    const std::size_t capacity = std::max(least, capacity_ + capacity_ / 2);
    auto data = std::make_unique_for_overwrite<T[]>(capacity);
    std::copy_n(data_.get(), size_, data.get());
    data_ = std::move(data);
    capacity_ = capacity;
  }

  std::unique_ptr<T[]> data_;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

using PairBuffer = AppendBuffer<Pair>;

}  // namespace kerf
