#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

#include "core/base/ids.h"

namespace kerf {

/// Contiguous values. A kernel writes behind the end and then commits the number written. Memory is
/// initialised at most once and never given back. Long buffers grow by moving their pages (realloc), so that
/// no second copy exists meanwhile.
template <class T>
class AppendBuffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  AppendBuffer() = default;
  AppendBuffer(AppendBuffer&& other) noexcept
      : data_(std::move(other.data_)),
        size_(std::exchange(other.size_, 0)),
        capacity_(std::exchange(other.capacity_, 0)) {}
  AppendBuffer& operator=(AppendBuffer&& other) noexcept {
    data_ = std::move(other.data_);
    size_ = std::exchange(other.size_, 0);
    capacity_ = std::exchange(other.capacity_, 0);
    return *this;
  }
  ~AppendBuffer() = default;
  AppendBuffer(const AppendBuffer&) = delete;
  AppendBuffer& operator=(const AppendBuffer&) = delete;

  void clear() { size_ = 0; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::span<const T> all() const { return {data_.get(), size_}; }
  [[nodiscard]] std::span<T> all() { return {data_.get(), size_}; }

  /// Room for `count` more values behind the end.
  T* reserve(std::size_t count) {
    if (capacity_ - size_ < count) grow(size_ + count);
    return data_.get() + size_;
  }
  /// Makes the first `count` values behind the end valid.
  void commit(std::size_t count) { size_ += count; }
  void push_back(const T& value) {
    *reserve(1) = value;
    ++size_;
  }
  void append(std::span<const T> values) {
    std::copy(values.begin(), values.end(), reserve(values.size()));
    commit(values.size());
  }
  /// Drops all but the first `size` values.
  void truncate(std::size_t size) { size_ = size; }

 private:
  void grow(std::size_t least) {
    const std::size_t capacity = std::max(least, capacity_ + capacity_ / 2);
    T* const data = move_to(capacity * sizeof(T));
    if (data == nullptr) throw std::bad_alloc();
    (void)data_.release();
    data_.reset(data);
    capacity_ = capacity;
  }

  /// Moves the data to larger memory and frees the old.
  T* move_to(std::size_t bytes) {
    if constexpr (alignof(T) <= alignof(std::max_align_t)) {
      return static_cast<T*>(std::realloc(data_.get(), bytes));
    } else {
      auto* const data = static_cast<T*>(std::aligned_alloc(alignof(T), bytes));
      if (data == nullptr) return nullptr;
      std::copy_n(data_.get(), size_, data);
      data_.reset();
      return data;
    }
  }

  struct Free {
    void operator()(T* data) const { std::free(data); }
  };

  std::unique_ptr<T[], Free> data_;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

using PairBuffer = AppendBuffer<Pair>;

}  // namespace kerf
