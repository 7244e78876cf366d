#pragma once

#include <cstdint>
#include <vector>

#include "core/base/config.h"
#include "viz/draw/draw_context.h"
#include "viz/draw/gliding_box.h"
#include "viz/draw/highlights.h"
#include "viz/draw/view_box.h"

namespace kerf {

/// Where the ramp of populations ends if there are so many objects at most: at four times the split
/// threshold, for the paper's tree often leaves a crowded leaf as it is. So the colours of a film never
/// change their scale.
std::uint32_t end_of_ramp(std::uint32_t objects, const Config& config);

/// The parts of a frame that follow from the tree and from earlier frames. With the plan any renderer, in any
/// process, draws the frame alike.
template <int D>
struct FramePlan {
  Box<D> bounds;                         ///< that is framed
  std::uint32_t outside = 0;             ///< bodies of which no part lies in it
  bool names_outside = false;            ///< the caption has the number, also 0: it must not jump
  bool has_tree = false;                 ///< caption and legend describe it
  TreeSnapshotOf<D> snapshot;            ///< of the tree
  std::vector<Placement> placements;     ///< by object; empty: objects are not tinted
  std::vector<Box<D>> crowds;            ///< by node, see `find_crowds`; empty in 2D
  std::vector<Highlight> highlights;     ///< newest first
  std::uint32_t largest_population = 0;  ///< end of the ramp
  bool ramp_is_fixed = false;            ///< a leaf may have more objects
  int samples = 0;                       ///< of a pixel; 0: not chosen yet
};

/// Keeps what must not jump from frame to frame: the view, the ramp of populations, smooth or jagged edges,
/// and the cells of nodes that have died since.
template <int D>
class FramePlanner {
 public:
  /// `layers` and `samples` as in FrameOptions.
  explicit FramePlanner(LayerSet layers, int samples, Framing framing = Framing::most)
      : layers_(layers), wanted_samples_(samples), view_box_(framing) {}

  /// The plan is valid until the next call.
  const FramePlan<D>& plan(const FrameInput<D>& input);
  /// A moment that is not drawn; its operators may be shown by a later frame. Its bodies belong to it: they
  /// say how large planes and cells are.
  void observe(const FrameInput<D>& input);
  /// Forgets all moments, but not what was fixed.
  void forget();

  /// From now on the view is exactly this box. Throws std::invalid_argument unless it is valid.
  void fix_view_box(const Box<D>& box);
  /// From now on the view goes over to a larger one in several frames: these follow each other in a film.
  void glide() { glides_ = true; }
  /// From now on the caption says how many bodies lie outside, also if none does.
  void name_outside() { plan_.names_outside = true; }
  /// From now on the ramp of populations ends here.
  void fix_largest_population(std::uint32_t population);
  void set_layers(LayerSet layers) { layers_ = layers; }

 private:
  [[nodiscard]] Box<D> framed() const { return glide_.box().value_or(view_box_.box()); }
  void choose_largest_population();
  void choose_samples(std::size_t bodies);

  LayerSet layers_;
  int wanted_samples_;
  ViewBox<D> view_box_;
  GlidingBox<D> glide_;  ///< towards it
  bool glides_ = false;
  TreeSnapshotOf<D> before_;
  std::vector<Box<D>> crowds_before_;
  Highlights<D> highlights_;
  FramePlan<D> plan_;
};

}  // namespace kerf
