#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/scene/shape.h"

namespace kerf {

/// A table with a row for each shape of a recording, numbered from 0 in the order in which they came.
extern const char* const kShapeTable;

/// What is written of a shape.
struct ShapeText {
  std::string kind;
  Bytes data;
  friend auto operator<=>(const ShapeText&, const ShapeText&) = default;
};

template <int D>
ShapeText encode_shape(const Shape<D>& shape);
/// The reverse. Throws std::runtime_error for what is no shape: no kind of this dimension, sizes that are not
/// positive and finite, corners that are not finite or are missing.
template <int D>
Shape<D> decode_shape(std::string_view kind, std::span<const std::uint8_t> data);

/// How many there are of each kind: "2 balls, 1 surface".
template <int D>
std::string count_shapes(std::span<const Shape<D>> shapes);

/// Numbers shapes; equal ones have one number.
template <int D>
class ShapeNumbers {
 public:
  std::uint32_t number_of(const Shape<D>& shape);
  /// Those that are new since the last call.
  std::vector<std::pair<std::uint32_t, ShapeText>> take_new();
  [[nodiscard]] const Shape<D>& operator[](std::uint32_t number) const { return shapes_[number]; }

 private:
  std::vector<Shape<D>> shapes_;
  std::map<ShapeText, std::uint32_t> numbers_;
  std::vector<std::pair<std::uint32_t, ShapeText>> new_;
};

}  // namespace kerf
