#include "tests/images/plants.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "viz/draw/palette.h"

namespace kerf::test {
namespace {

DrawnKind kind_of(Plant plant, const DrawList& list) {
  switch (plant) {
    case Plant::missing_plane:
    case Plant::moved_plane:
      return DrawnKind::plane;
    case Plant::missing_pair:
    case Plant::recolored_pair:
      return DrawnKind::pair;
    case Plant::missing_box:
      return DrawnKind::object;
    case Plant::leaf_tint:
      break;
  }
  const bool has_leaves =
      std::ranges::any_of(list.items, [](const Drawn& drawn) { return drawn.kind == DrawnKind::leaf; });
  return has_leaves ? DrawnKind::leaf : DrawnKind::object;
}

void drop(Batch& batch, std::uint32_t item) {
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i + 2 < batch.indices.size(); i += 3) {
    if (batch.items[batch.indices[i]] == item) continue;
    for (std::size_t k = 0; k < 3; ++k) kept.push_back(batch.indices[i + k]);
  }
  batch.indices = std::move(kept);
}

template <class Change>
void change(Batch& batch, std::uint32_t item, Change how) {
  for (std::size_t i = 0; i < batch.vertices.size(); ++i)
    if (batch.items[i] == item) how(batch.vertices[i]);
}

void tint(Vertex& vertex) {
  const Color full = vertex.color;
  vertex.color = mix(full, {0, 0, 0, full.a}, 0.04);
}

void recolor(Vertex& vertex) {
  const std::uint8_t alpha = vertex.color.a;
  vertex.color = palette::kSeries[2];
  vertex.color.a = alpha;
}

void spoil(Plant plant, const Drawn& victim, Batch& batch, std::uint32_t item, int width, int height) {
  const bool is_flat = victim.right - victim.left > victim.bottom - victim.top;
  const float dx = is_flat ? 0 : 2.0F / static_cast<float>(width);
  const float dy = is_flat ? 2.0F / static_cast<float>(height) : 0;
  switch (plant) {
    case Plant::missing_plane:
    case Plant::missing_pair:
    case Plant::missing_box:
      return drop(batch, item);
    case Plant::moved_plane:
      return change(batch, item, [&](Vertex& vertex) {
        vertex.x += dx * vertex.w;
        vertex.y += dy * vertex.w;
      });
    case Plant::recolored_pair:
      return change(batch, item, recolor);
    case Plant::leaf_tint:
      return change(batch, item, tint);
  }
}

}  // namespace

std::string_view describe(Plant plant) {
  switch (plant) {
    case Plant::missing_plane:
      return "a missing plane";
    case Plant::moved_plane:
      return "a plane moved by one pixel";
    case Plant::missing_pair:
      return "a missing pair line";
    case Plant::recolored_pair:
      return "a recoloured pair";
    case Plant::leaf_tint:
      return "a leaf tinted by 4 %";
    case Plant::missing_box:
      return "a missing box";
  }
  return "";
}

Drawn victim(Plant plant, const FrameIds& ids) {
  const DrawnKind kind = kind_of(plant, ids.list);
  std::vector<Drawn> seen;
  for (const Drawn& drawn : ids.list.items)
    if (drawn.kind == kind && drawn.pixels > 0) seen.push_back(drawn);
  if (seen.empty()) throw std::runtime_error("nothing to plant a bug into");
  std::ranges::stable_sort(seen, {}, &Drawn::pixels);
  return seen[seen.size() / 2];
}

Tamper tamper(Plant plant, const Drawn& victim, int width, int height) {
  return [=](std::span<Batch> batches, const DrawList& list) {
    for (std::uint32_t i = 0; i < list.items.size(); ++i) {
      const Drawn& drawn = list.items[i];
      if (drawn.kind != victim.kind || drawn.a != victim.a || drawn.b != victim.b) continue;
      for (Batch& batch : batches) spoil(plant, victim, batch, i + 1, width, height);
    }
  };
}

}  // namespace kerf::test
