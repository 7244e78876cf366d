#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "viz/draw/batch.h"
#include "viz/draw/color.h"
#include "viz/image/image.h"

namespace kerf {

/// The meaning of a part of a picture.
enum class DrawnKind : std::uint8_t { object, leaf, plane, pair, operation };
inline constexpr int kDrawnKindCount = 5;
std::string_view to_string(DrawnKind kind);

/// One thing in a picture.
struct Drawn {
  DrawnKind kind = DrawnKind::object;
  std::uint32_t a = 0;                             ///< the object, the node, the first object of the pair
  std::uint32_t b = 0;                             ///< the second object of the pair, the operator's kind
  Color color{};                                   ///< mean of its corners
  std::uint32_t pixels = 0;                        ///< of the id image
  float left = 0, top = 0, right = 0, bottom = 0;  ///< its bounds in the picture, in pixels
  friend bool operator==(const Drawn&, const Drawn&) = default;
};

/// "object 5", "leaf n9", "plane n17", "pair 12-77", "operator split n3": the same in every picture.
std::string name_of(const Drawn& drawn);

/// A line of text with its upper left corner.
struct DrawnText {
  int x = 0;
  int y = 0;
  std::string text;
  friend bool operator==(const DrawnText&, const DrawnText&) = default;
};

/// The items of a picture. Item k is `items[k - 1]`; 0 is the ground.
struct DrawList {
  std::vector<Drawn> items;
  std::vector<DrawnText> texts;

  std::uint32_t add(DrawnKind kind, std::uint32_t a, std::uint32_t b) {
    items.push_back({kind, a, b, {}, 0, 0, 0, 0, 0});
    return static_cast<std::uint32_t>(items.size());
  }
  void clear() {
    items.clear();
    texts.clear();
  }
};

/// The draw list and the id image of a picture.
struct FrameIds {
  DrawList list;
  Image image;  ///< for each pixel the number of its item: see `item_of`
};

/// Computes colours and bounds from the triangles of the items. Items without triangles keep no size, right <
/// left.
void measure_items(std::span<const Batch> batches, int width, int height, DrawList& list);

/// The batch with each triangle in the colour of its item's number. Nearly transparent triangles (glass) are
/// left out, so that things behind them keep their pixels.
void make_id_batch(const Batch& batch, Batch& ids);

/// The item's number of a pixel of an id image, and the colour that stands for it.
std::uint32_t item_of(const std::uint8_t* rgba);
Color id_color(std::uint32_t item);

/// Counts the pixels of each item.
void count_pixels(const Image& ids, DrawList& list);

}  // namespace kerf
