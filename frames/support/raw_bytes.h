#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace kerf {

/// Appends values as they lie in memory, for another process of the same program. What is written and read is
/// named once, by a function that gives its fields to either: `fields(bytes, caption)`.
class RawWriter {
 public:
  template <class... T>
  void operator()(const T&... values) {
    (put(values), ...);
  }
  /// Calls `with(value)` for each value of a list.
  template <class T>
  void each(const std::vector<T>& list, auto with) {
    put(list.size());
    for (const T& value : list) with(value);
  }
  /// The same for a value that may be missing.
  template <class T>
  void maybe(const std::optional<T>& value, auto with) {
    put(value.has_value());
    if (value) with(*value);
  }
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  template <class T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    append(&value, sizeof value);
  }
  template <class T>
  void put(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    put(values.size());
    append(values.data(), values.size_bytes());
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(std::span<const T>(values));
  }
  void put(const std::string& text) { put(std::span<const char>(text)); }
  void append(const void* data, std::size_t size) {
    if (size == 0) return;
    const std::size_t at = bytes_.size();
    bytes_.resize(at + size);
    std::memcpy(bytes_.data() + at, data, size);
  }

  std::vector<std::uint8_t> bytes_;
};

/// Reads what RawWriter wrote. Throws std::runtime_error where the bytes end too soon.
class RawReader {
 public:
  explicit RawReader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  template <class... T>
  void operator()(T&... values) {
    (get(values), ...);
  }
  template <class T>
  void each(std::vector<T>& list, auto with) {
    list.resize(get<std::size_t>());
    for (T& value : list) with(value);
  }
  template <class T>
  void maybe(std::optional<T>& value, auto with) {
    if (get<bool>()) with(value.emplace());
  }
  template <class T>
  T get() {
    T value{};
    get(value);
    return value;
  }

 private:
  template <class T>
  void get(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    copy(&value, sizeof value);
  }
  template <class T>
  void get(std::vector<T>& values) {
    const auto size = get<std::size_t>();
    if (size > rest_.size() / sizeof(T)) throw std::runtime_error("a frame's data ends too soon");
    values.resize(size);
    copy(values.data(), size * sizeof(T));
  }
  void get(std::string& text) {
    const auto letters = get<std::vector<char>>();
    text.assign(letters.begin(), letters.end());
  }
  void copy(void* to, std::size_t size) {
    if (size > rest_.size()) throw std::runtime_error("a frame's data ends too soon");
    if (size > 0) std::memcpy(to, rest_.data(), size);
    rest_ = rest_.subspan(size);
  }

  std::span<const std::uint8_t> rest_;
};

}  // namespace kerf
