#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/base/ids.h"
#include "core/geometry/box.h"
#include "core/scene/scene.h"
#include "core/trace/event.h"
#include "core/trace/statistics.h"
#include "core/tree/tree.h"
#include "viz/draw/draw_list.h"
#include "viz/draw/layers.h"
#include "viz/gl/backend.h"
#include "viz/image/image.h"

namespace kerf {

/// The words and numbers of a frame. Those of the tree are shown only when a tree is drawn.
struct Caption {
  std::string scene;  ///< empty, as the broad phase: not shown
  std::string broad_phase;
  std::uint32_t step = 0;
  std::uint32_t objects = 0;
  std::uint32_t moving = 0;
  std::uint64_t pairs = 0;
  std::uint64_t contacts = 0;
  Statistics statistics;
  std::string step_name{};  ///< what an import calls the step; empty: its number
  std::string note{};       ///< free text, one line, may be empty
  bool knows_contacts = true;
  bool knows_pairs = true;
  bool is_run = true;  ///< false: boxes as such, which have no step and do not move
  struct Theirs {
    std::uint64_t missed = 0;
    std::uint64_t extra = 0;
  };
  std::optional<Theirs> theirs{};  ///< another engine's errors in this step; none: none were judged
};

/// The number of steps for which an operator stays highlighted, unless a frame says otherwise.
inline constexpr std::uint32_t kHighlightSteps = 10;

/// One moment of a scene. It need not outlive the call.
template <int D>
struct FrameInput {
  std::span<const Body<D>> bodies;  ///< body k is object k
  const Tree<D>* tree = nullptr;    ///< none: a broad phase without a tree
  std::span<const Pair> pairs;
  std::span<const Pair> contacts;  ///< those of `pairs` that touch, sorted
  /// Recent events. Operators fade with their age in steps against `caption.step`; for a film, pass the
  /// events of the last `highlight_steps` steps.
  std::span<const Event> events;
  Caption caption;
  std::uint32_t highlight_steps = kHighlightSteps;
  std::span<const Pair> missed{};  ///< overlaps that another engine did not report
  std::span<const Pair> extra{};   ///< what it reported, and is no pair
};

/// From this number of bodies on, edges are drawn jagged unless the options say otherwise.
inline constexpr std::size_t kManyBodies = 2000;

inline constexpr int kMinFrameSide = 64;
inline constexpr int kMaxFrameSide = 8192;

/// Pixels at the edges of a picture that the scene leaves free.
struct Margins {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};

struct FrameOptions {
  int width = 1280;  ///< kMinFrameSide to kMaxFrameSide, as height
  int height = 720;
  LayerSet layers = LayerSet::all();
  std::string camera;  ///< see `parse_camera`; empty: everything in view
  /// Of each pixel. 4: smooth edges; 1: jagged ones, about three times faster; 0: smooth up to kManyBodies.
  int samples = 0;
  bool ids = false;           ///< also record what was drawn and where, see `FrameIds`
  std::string camera_path{};  ///< see CameraPath; empty: the camera stands still
  GlBackend backend = GlBackend::any;
  int letters = 0;    ///< their height in pixels; 0: that for the height of the picture
  Margins margins{};  ///< for pictures without caption and legend, which would keep the whole width
};

struct View;
struct Overlay;
class Font;

/// Draws into a picture what lies above its scene, for example in its margins.
using Sketch = std::function<void(const View& view, const Font& font, Overlay& overlay)>;

/// Called with the triangles of a scene (back, glass, lines, front) before they are drawn. Tests plant bugs
/// with it.
using Tamper = std::function<void(std::span<Batch> batches, const DrawList& list)>;

template <int D>
struct FramePlan;
template <int D>
struct CameraChoice;

/// Draws frames with a GL context of its own; the same inputs in the same order give the same pixels on every
/// run and for every number of rasteriser threads.
///
/// The view contains everything seen so far and does not follow single objects: it grows in large steps only.
/// To draw frames out of order (or in several processes), plan them in order with a FramePlanner.
template <int D>
class FrameRenderer {
 public:
  /// Throws std::invalid_argument for a bad size or camera, std::runtime_error if there is no GL.
  explicit FrameRenderer(const FrameOptions& options);
  ~FrameRenderer();
  FrameRenderer(FrameRenderer&&) noexcept;
  FrameRenderer& operator=(FrameRenderer&&) noexcept;

  /// The picture is valid until the next call. Throws std::runtime_error on a GL error.
  const Image& render(const FrameInput<D>& input);
  /// The same for a frame that a FramePlanner has planned, maybe in another process. The input's tree and
  /// events are not read: the plan has what follows from them.
  const Image& render(const FrameInput<D>& input, const FramePlan<D>& plan);

  /// From now on the view is exactly this box. Throws std::invalid_argument unless it is valid.
  void set_view_box(const Box<D>& box);
  void set_layers(LayerSet layers);
  /// From now on this is the camera, where no path moves it.
  void set_camera(const CameraChoice<D>& camera);
  /// What the next frames have above their scene.
  void set_sketch(Sketch sketch);

  /// Of the last frame; empty unless the options ask for it.
  [[nodiscard]] const FrameIds& ids() const;
  /// Renderers with the same text here draw the same pixels.
  [[nodiscard]] std::string rasterizer() const;
  void set_tamper(Tamper tamper);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace kerf
