#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "viz/debugger/model/debugger_model.h"
#include "viz/debugger/model/view_settings.h"
#include "viz/debugger/scene/tints.h"
#include "viz/draw/theme.h"
#include "viz/gl/framebuffer.h"

namespace kerf {

/// The shown part of the scene, and the range of its colours.
struct ShownCounts {
  std::size_t objects = 0;
  std::size_t all_objects = 0;
  std::size_t partitioners = 0;
  std::size_t all_partitioners = 0;
  std::size_t pairs = 0;
  std::size_t all_pairs = 0;
  std::string pairs_note;  ///< see `Run::note_on_pairs`
  std::size_t missed = 0;  ///< by another engine, and drawn
  std::size_t extra = 0;
  double tint_end = 1;  ///< the value of the brightest colour
  bool theirs = false;  ///< another engine's structure is shown
  std::size_t their_nodes = 0;
  std::size_t their_faults = 0;
  bool lacks_isolated = false;  ///< the node that is to be alone is not alive: all is shown
  std::string query;            ///< what it found, and what that took; empty: none is asked
};

/// What the window wants of a view.
struct SceneLook {
  double scale = 1;  ///< pixels in a unit of the panels: lines get thicker with it
  const Theme* theme = &theme_called(ThemeName::light);
  bool brief = false;  ///< many objects are drawn with less detail: the camera turns
  double above = 0;    ///< pixels at the top that text may cover, and at the bottom
  double below = 0;
  friend bool operator==(const SceneLook&, const SceneLook&) = default;
};

/// A label of something in the scene, at pixels of the view.
struct SceneLabel {
  float x = 0;
  float y = 0;
  std::string text;
};

template <int D>
class SceneViewOf;
using SceneViewOfEitherDimension = std::variant<const SceneViewOf<2>*, const SceneViewOf<3>*>;

/// The scene of a run at its moment, as the model's settings show it. All calls need the GL context to be
/// current.
class SceneView {
 public:
  SceneView() = default;
  SceneView(const SceneView&) = delete;
  SceneView& operator=(const SceneView&) = delete;
  virtual ~SceneView() = default;

  SceneLook look;  ///< for the next `update`

  [[nodiscard]] virtual SceneViewOfEitherDimension self() const = 0;

  /// Draws the scene again if anything visible has changed. The colours end at `tint_end`.
  virtual void update(const DebuggerModel& model, int width, int height, double tint_end) = 0;
  /// The values that colour the nodes at this moment; their end is for this run alone.
  [[nodiscard]] virtual const NodeTints& tints(Tint tint) = 0;
  /// Copies the picture, its top left corner to (x, y).
  virtual void copy_to(const Framebuffer& target, int x, int y) const = 0;
  [[nodiscard]] virtual const ShownCounts& counts() const = 0;
  [[nodiscard]] virtual const std::vector<SceneLabel>& labels() const = 0;
  /// The number of pictures drawn so far; an unchanged one is not drawn again.
  [[nodiscard]] virtual std::uint64_t drawn() const = 0;

  /// The item under a pixel of the view: an object if there is one and `node_wanted` is false, else a node.
  [[nodiscard]] virtual Selection pick(double x, double y, bool node_wanted) const = 0;
  /// The pair whose line is within a few pixels of one of the view.
  [[nodiscard]] virtual std::optional<Pair> pick_pair(double x, double y) const = 0;
  /// The place of the middle of an object or leaf, or of an edge of a partitioner.
  [[nodiscard]] virtual std::optional<SceneLabel> place_of(const Selection& selection) const = 0;

  /// What to ask about a pixel: in 3D the ray through it, in 2D the point.
  [[nodiscard]] virtual std::string query_at(double x, double y) const = 0;

  virtual void turn(double dx, double dy) = 0;
  virtual void move(double dx, double dy) = 0;
  virtual void zoom(double clicks, double x, double y) = 0;
  /// Looks at the selection; at everything if there is none.
  virtual void focus(const Selection& selection) = 0;
  /// Copies the camera of the other view, which must be of the same dimension.
  virtual void look_like(const SceneView& other) = 0;
  [[nodiscard]] virtual AnyCamera camera() const = 0;
  /// Of the other dimension: changes nothing.
  virtual void set_camera(const AnyCamera& camera) = 0;
};

/// A view of the run, which must outlive it.
std::unique_ptr<SceneView> make_scene_view(const GlFunctions& gl, Run& run);

}  // namespace kerf
