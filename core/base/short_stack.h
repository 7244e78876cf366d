#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

namespace kerf {

/// A stack whose lowest elements need no memory of the heap. What is still to be visited on a walk down a
/// tree has one element for each level, so that only a damaged tree needs more.
template <class T>
class ShortStack {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  explicit ShortStack(const T& first) { push(first); }
  void push(const T& value) {
    if (size_ < kRoom) {
      std::memcpy(room_ + size_ * sizeof(T), &value, sizeof(T));
    } else {
      above_.push_back(value);
    }
    ++size_;
  }
  T pop() {
    T value{};
    if (--size_ < kRoom) {
      std::memcpy(&value, room_ + size_ * sizeof(T), sizeof(T));
    } else {
      value = above_.back();
      above_.pop_back();
    }
    return value;
  }
  [[nodiscard]] bool empty() const { return size_ == 0; }

 private:
  static constexpr std::size_t kRoom = 66;  // a tree has 64 levels, and a walk pushes two children at once

  std::size_t size_ = 0;
  std::byte room_[kRoom * sizeof(T)];  // unused places have no value: most walks are short
  std::vector<T> above_;
};

}  // namespace kerf
