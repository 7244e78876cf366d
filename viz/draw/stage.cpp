#include <Eigen/Geometry>
#include <algorithm>
#include <utility>
#include <vector>

#include "viz/draw/draw_context.h"
#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"

namespace kerf {
namespace {

constexpr double kTileTint = 0.24;      ///< of the leaf's colour in that of the ground
constexpr double kJointAlpha = 0.2;     ///< of the lines between tiles
constexpr double kAtTheBack = 0.99999;  ///< of the depths that the rasteriser compares

/// A rectangle of the bounds behind everything in them, seen from the eye.
std::vector<Polygon> far_walls(const Box<3>& bounds, const Eigen::Vector3d& eye) {
  std::vector<Polygon> walls;
  for (const HalfSpace& side : half_spaces(bounds))
    if (side.normal.dot(eye) < side.offset) walls.push_back(plane_within(side, bounds, {}));
  return walls;
}

/// Fills a polygon behind everything that is drawn with its true depth, also behind what lies outside of the
/// bounds.
void add_tile(Batch& batch, const View& view, const Polygon& tile, Color color) {
  thread_local std::vector<Eigen::Vector4d> clip;
  clip.clear();
  for (const Eigen::Vector3d& corner : tile) {
    Eigen::Vector4d at = view.clip_from_world * corner.homogeneous();
    at.z() = kAtTheBack * at.w();
    clip.push_back(at);
  }
  batch.add_fan(clip, color);
}

struct Tile {
  NodeId leaf;
  Polygon polygon;
};

/// Cuts a wall along the planes of the tree: each leaf that reaches it has one tile.
void divide_wall(const TreeSnapshotOf<3>& tree, Polygon wall, std::vector<Tile>& tiles) {
  std::vector<Tile> todo{{tree.root(), std::move(wall)}};
  while (!todo.empty()) {
    Tile left = std::move(todo.back());
    todo.pop_back();
    if (left.polygon.empty()) continue;
    const TreeSnapshot::Node& node = tree[left.leaf];
    if (node.is_leaf()) {
      tiles.push_back(std::move(left));
      continue;
    }
    const Plane<3>& plane = tree.plane(left.leaf);
    Tile right{node.right, left.polygon};
    left.leaf = node.left;
    clip(left.polygon, half_space(plane, false));
    clip(right.polygon, half_space(plane, true));
    todo.push_back(std::move(right));
    todo.push_back(std::move(left));
  }
}

}  // namespace

void draw_stage(const DrawContext<3>& context, std::span<const Color> leaf_colors, Batch& back,
                Batch& lines) {
  if (context.snapshot.empty()) return;
  std::vector<Tile> tiles;
  for (const Polygon& wall : far_walls(context.bounds, context.view.eye))
    divide_wall(context.snapshot, wall, tiles);
  std::ranges::stable_sort(tiles, {}, [](const Tile& tile) { return tile.leaf.value; });
  const Stroke joint{with_alpha(palette::kPartitioner, kJointAlpha), 0.8 * context.line_scale};
  NodeId last = NodeId::none();
  for (const auto& [leaf, polygon] : tiles) {
    const Color color = leaf_colors[leaf.index()];
    if (color.a == 0) continue;
    if (leaf != last) context.begin(back, DrawnKind::leaf, leaf.value);
    last = leaf;
    lines.item = back.item;
    add_tile(back, context.view, polygon, mix(context.ground, color, kTileTint));
    add_outline(lines, context.view, polygon, joint);
  }
}

void draw_space(const DrawContext<3>& context, std::span<const Color> leaf_colors, SpaceBatches to) {
  to.shadows.clear();
  if (context.has(Layer::leaves)) draw_stage(context, leaf_colors, to.back, to.glass);
  if (!context.has(Layer::objects)) return;
  draw_objects(context, to.back, to.glass);
  if (!context.brief) draw_shadows(context, to.shadows);
}

}  // namespace kerf
