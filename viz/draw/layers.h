#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace kerf {

/// The layers of a frame, from back to front. Each can be switched.
enum class Layer : std::uint8_t {
  objects,
  partitioners,
  leaves,
  pairs,  ///< candidates; contacts are drawn as such when `contacts` is shown, too
  contacts,
  operators,
  legend,
  caption,
};
inline constexpr int kLayerCount = 8;
std::string_view to_string(Layer layer);

/// A set of layers.
class LayerSet {
 public:
  static constexpr LayerSet all() { return LayerSet((1U << kLayerCount) - 1U); }
  static constexpr LayerSet none() { return LayerSet(0); }

  /// From "objects,pairs", "all", "none", or changes to `base` such as "+leaves,-legend". "all" and "none"
  /// may come first and be changed: "all,-caption". Throws std::invalid_argument that lists the valid names.
  static LayerSet parse(std::string_view text, LayerSet base = all());

  [[nodiscard]] constexpr bool has(Layer layer) const {
    return ((bits_ >> static_cast<int>(layer)) & 1U) != 0;
  }
  constexpr void set(Layer layer, bool shown) {
    const std::uint32_t bit = 1U << static_cast<int>(layer);
    bits_ = shown ? bits_ | bit : bits_ & ~bit;
  }
  [[nodiscard]] constexpr LayerSet with(Layer layer, bool shown) const {
    LayerSet copy = *this;
    copy.set(layer, shown);
    return copy;
  }
  friend constexpr bool operator==(LayerSet, LayerSet) = default;

 private:
  constexpr explicit LayerSet(std::uint32_t bits) : bits_(bits) {}
  std::uint32_t bits_;
};

/// "objects,pairs", or "none": `parse` reads it back as the same set.
std::string to_string(LayerSet layers);

}  // namespace kerf
