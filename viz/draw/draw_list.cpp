#include "viz/draw/draw_list.h"

#include <algorithm>
#include <array>

#include "core/trace/event.h"

namespace kerf {
namespace {

constexpr std::array<std::string_view, kDrawnKindCount> kKindNames{"object", "leaf", "plane", "pair",
                                                                   "operator"};

/// Glass is up to 0.18 opaque, outlines and cells from 0.25.
constexpr std::uint8_t kLeastAlpha = 56;

/// The sum over the corners of an item.
struct Sum {
  std::array<std::uint64_t, 4> color{};
  std::uint64_t corners = 0;
};

void take_in(Drawn& drawn, Sum& sum, const Vertex& vertex, int width, int height) {
  const Color color = vertex.color;
  sum.color[0] += color.r;
  sum.color[1] += color.g;
  sum.color[2] += color.b;
  sum.color[3] += color.a;
  ++sum.corners;
  if (!(vertex.w > 0)) return;
  const float x = std::clamp(0.5F * (vertex.x / vertex.w + 1), 0.0F, 1.0F) * static_cast<float>(width);
  const float y = std::clamp(0.5F * (vertex.y / vertex.w + 1), 0.0F, 1.0F) * static_cast<float>(height);
  drawn.left = std::min(drawn.left, x);
  drawn.top = std::min(drawn.top, y);
  drawn.right = std::max(drawn.right, x);
  drawn.bottom = std::max(drawn.bottom, y);
}

Color mean_of(const Sum& sum) {
  if (sum.corners == 0) return {0, 0, 0, 0};
  const auto mean = [&](std::size_t c) {
    return static_cast<std::uint8_t>((sum.color[c] + sum.corners / 2) / sum.corners);
  };
  return {mean(0), mean(1), mean(2), mean(3)};
}

}  // namespace

std::string_view to_string(DrawnKind kind) { return kKindNames[static_cast<std::size_t>(kind)]; }

std::string name_of(const Drawn& drawn) {
  std::string kind(to_string(drawn.kind));
  const std::string a = std::to_string(drawn.a);
  switch (drawn.kind) {
    case DrawnKind::object:
      return kind + " " + a;
    case DrawnKind::leaf:
    case DrawnKind::plane:
      return kind + " n" + a;
    case DrawnKind::pair:
      return kind + " " + a + "-" + std::to_string(drawn.b);
    case DrawnKind::operation:
      return kind + " " + std::string(to_string(static_cast<Operator>(drawn.b))) + " n" + a;
  }
  return kind;
}

void measure_items(std::span<const Batch> batches, int width, int height, DrawList& list) {
  std::vector<Sum> sums(list.items.size());
  for (Drawn& drawn : list.items) {
    drawn.left = static_cast<float>(width);
    drawn.top = static_cast<float>(height);
    drawn.right = drawn.bottom = -1;
  }
  for (const Batch& batch : batches) {
    for (const std::uint32_t index : batch.indices) {
      const std::uint32_t item = batch.items[index];
      if (item > 0) take_in(list.items[item - 1], sums[item - 1], batch.vertices[index], width, height);
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) list.items[i].color = mean_of(sums[i]);
}

void make_id_batch(const Batch& batch, Batch& ids) {
  ids.clear();
  ids.vertices = batch.vertices;
  for (std::size_t i = 0; i < ids.vertices.size(); ++i) ids.vertices[i].color = id_color(batch.items[i]);
  for (std::size_t i = 0; i + 2 < batch.indices.size(); i += 3) {
    const auto triangle = batch.indices.begin() + static_cast<std::ptrdiff_t>(i);
    if (batch.vertices[triangle[2]].color.a >= kLeastAlpha)
      ids.indices.insert(ids.indices.end(), triangle, triangle + 3);
  }
}

std::uint32_t item_of(const std::uint8_t* rgba) {
  return std::uint32_t{rgba[0]} << 16U | std::uint32_t{rgba[1]} << 8U | rgba[2];
}

Color id_color(std::uint32_t item) {
  return {static_cast<std::uint8_t>(item >> 16U), static_cast<std::uint8_t>(item >> 8U),
          static_cast<std::uint8_t>(item), 255};
}

void count_pixels(const Image& ids, DrawList& list) {
  for (Drawn& drawn : list.items) drawn.pixels = 0;
  for (std::size_t i = 0; i < ids.rgba.size(); i += 4) {
    const std::uint32_t item = item_of(ids.rgba.data() + i);
    if (item > 0 && item <= list.items.size()) ++list.items[item - 1].pixels;
  }
}

}  // namespace kerf
