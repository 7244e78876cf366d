#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "viz/draw/batch.h"
#include "viz/draw/camera.h"
#include "viz/draw/cells.h"
#include "viz/draw/crowds.h"
#include "viz/draw/draw_list.h"
#include "viz/draw/frame_renderer.h"
#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"

namespace kerf {

/// Where an object is stored in the tree.
struct Placement {
  std::uint32_t leaves = 0;      ///< that contain it
  std::uint32_t population = 0;  ///< of the fullest of them
};

/// The properties of a frame that the functions for single layers need.
template <int D>
struct DrawContext {
  const FrameInput<D>& input;
  const View& view;
  const TreeSnapshotOf<D>& snapshot;
  const std::vector<Placement>& placements;  ///< by object; empty: objects are not tinted
  const Box<D>& bounds;                      ///< of the cells
  LayerSet layers;
  double line_scale = 1;                 ///< widths are given for a picture of 720 rows
  std::uint32_t largest_population = 1;  ///< end of the ramp
  DrawList* list = nullptr;              ///< null: no record of what is drawn
  std::span<const Color> colors{};       ///< by object, instead of those by population; empty: none
  std::span<const Box<D>> crowds{};      ///< by node, see `find_crowds`; empty: `bounds` for each
  Color ground = palette::kGround;       ///< that lies behind everything
  bool brief = false;  ///< no shadows, edges or dashes, small objects as patches: the camera turns

  [[nodiscard]] bool has(Layer layer) const { return layers.has(layer); }
  /// Where a node's partitioner and cell are drawn.
  [[nodiscard]] const Box<D>& space_of(NodeId node) const { return crowd_of(crowds, node, bounds); }
  /// Everything added to `batch` from now on belongs to this item.
  void begin(Batch& batch, DrawnKind kind, std::uint32_t a, std::uint32_t b = 0) const {
    if (list != nullptr) batch.item = list->add(kind, a, b);
  }
};

/// A body that can be drawn: every number finite.
template <int D>
bool is_drawable(const Body<D>& body);

/// The fill of an object that nothing else colours: the given one, or that of its mobility.
Color own_color(Mobility mobility, const std::optional<Rgb>& given);

/// Fill of an object, before light falls on it: the tree's where it is tinted, else its own.
template <int D>
Color object_color(const DrawContext<D>& context, std::size_t object);

/// Objects by their true shapes. 3D: opaque faces go to `solid`, the walls of fixed objects to `glass`.
void draw_objects(const DrawContext<2>& context, Batch& flat);
void draw_objects(const DrawContext<3>& context, Batch& solid, Batch& glass);

/// Cells filled by population.
void draw_leaves(const DrawContext<2>& context, Batch& batch);
/// The far walls of the bounds, in tiles: where the cells of the leaves reach them. `leaf_colors`: by node;
/// nothing is drawn where one is transparent. First into `back`, since all else lies before it.
void draw_stage(const DrawContext<3>& context, std::span<const Color> leaf_colors, Batch& back, Batch& lines);

/// Shadows of moving objects on the ground below them. Draw them so that they darken: where they overlap, the
/// darkest remains, and none is lighter than a floor in the colours of its leaves.
void draw_shadows(const DrawContext<3>& context, Batch& shadows);

/// The passes of a scene in 3D, but for its lines.
struct SpaceBatches {
  Batch& back;
  Batch& glass;
  Batch& shadows;  ///< to be drawn between the others
};
/// Stage, objects and shadows, as far as their layers are shown.
void draw_space(const DrawContext<3>& context, std::span<const Color> leaf_colors, SpaceBatches to);

/// A partitioner clipped to its cell.
template <int D>
void draw_partitioner(const DrawContext<D>& context, NodeId id, Batch& batch);
/// The edges of a node's cell.
template <int D>
void outline_cell(const DrawContext<D>& context, NodeId id, const Stroke& stroke, Batch& batch);
/// All of them; 3D: back to front.
template <int D>
void draw_partitioners(const DrawContext<D>& context, Batch& batch);

/// The line of a pair that `draw_pairs` draws, in the scene.
template <int D>
std::pair<Eigen::Vector3d, Eigen::Vector3d> pair_line(const View& view, const Body<D>& a, const Body<D>& b);

/// Candidate pairs and contacts.
template <int D>
void draw_pairs(const DrawContext<D>& context, Batch& batch);

}  // namespace kerf
