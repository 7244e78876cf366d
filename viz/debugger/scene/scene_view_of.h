#pragma once

#include <array>
#include <optional>
#include <vector>

#include "viz/debugger/model/run_of.h"
#include "viz/debugger/scene/orbit.h"
#include "viz/debugger/scene/run_survey.h"
#include "viz/debugger/scene/scene_painter.h"
#include "viz/debugger/scene/scene_view.h"
#include "viz/debugger/scene/visibility.h"
#include "viz/draw/draw_context.h"
#include "viz/draw/highlights.h"
#include "viz/draw/overlay.h"
#include "viz/draw/painter.h"

namespace kerf {

/// A view of a run of one dimension.
template <int D>
class SceneViewOf final : public SceneView {
 public:
  SceneViewOf(const GlFunctions& gl, RunOf<D>& run);

  [[nodiscard]] SceneViewOfEitherDimension self() const override { return this; }
  void update(const DebuggerModel& model, int width, int height, double tint_end) override;
  [[nodiscard]] const NodeTints& tints(Tint tint) override;
  void copy_to(const Framebuffer& target, int x, int y) const override {
    if (framebuffer_) framebuffer_->copy_to(target, x, y);
  }
  [[nodiscard]] const ShownCounts& counts() const override { return counts_; }
  [[nodiscard]] const std::vector<SceneLabel>& labels() const override { return labels_; }
  [[nodiscard]] std::uint64_t drawn() const override { return drawn_; }
  [[nodiscard]] Selection pick(double x, double y, bool node_wanted) const override;
  [[nodiscard]] std::string query_at(double x, double y) const override;
  [[nodiscard]] std::optional<Pair> pick_pair(double x, double y) const override;
  [[nodiscard]] std::optional<SceneLabel> place_of(const Selection& selection) const override;
  void turn(double dx, double dy) override { orbit_.turn(dx, dy, width_, height_); }
  void move(double dx, double dy) override { orbit_.move(dx, dy, width_, height_); }
  void zoom(double clicks, double x, double y) override { orbit_.zoom(clicks, x, y, width_, height_); }
  void focus(const Selection& selection) override;
  void look_like(const SceneView& other) override;
  [[nodiscard]] AnyCamera camera() const override { return orbit_.choice(); }
  void set_camera(const AnyCamera& camera) override {
    const auto set = [this]<int OtherD>(const CameraChoice<OtherD>& choice) {
      if constexpr (OtherD == D) orbit_.choose(choice);
    };
    std::visit(set, camera);
    faced_.reset();
  }

 private:
  /// Everything that decides the picture.
  struct Seen {
    Position position;
    ViewSettings settings;
    Selection selection;
    std::optional<NodeId> hovered;
    std::optional<std::size_t> candidate;
    View view;
    double tint_end = 1;
    int width = 0;
    int height = 0;
    SceneLook look;
    friend bool operator==(const Seen& a, const Seen& b) {
      return a.position == b.position && a.settings == b.settings && a.selection == b.selection &&
             a.hovered == b.hovered && a.candidate == b.candidate && a.tint_end == b.tint_end &&
             a.view.clip_from_world == b.view.clip_from_world && a.width == b.width && a.height == b.height &&
             a.look == b.look;
    }
  };

  /// What decides which objects and pairs are drawn, and their colours: not the camera.
  struct Choice {
    Position position;
    ViewSettings settings;
    double tint_end = 1;
    bool brief = false;
    friend bool operator==(const Choice&, const Choice&) = default;
  };

  void take_moment();
  [[nodiscard]] Color color_of_leaf(NodeId leaf) const;
  /// While the camera turns, many objects are drawn with less detail.
  [[nodiscard]] bool is_brief() const { return seen_->look.brief && counts_.all_objects >= kManyBodies; }
  void choose_bodies();
  void choose_colors();
  void draw(const DebuggerModel& model);
  void draw_nodes(const DrawContext<D>& frame, Batch& cells, Batch& planes);
  void draw_theirs(const DrawContext<D>& frame, Batch& cells, Batch& outlines, Batch& front);
  void draw_recent(const DrawContext<D>& frame, Batch& batch);
  void draw_event(const DrawContext<D>& frame, Batch& batch);
  void draw_selection(const DrawContext<D>& frame, Batch& batch);
  void draw_asked(const DrawContext<D>& frame, Batch& batch);
  void draw_object(const DrawContext<D>& frame, ObjectId id, Batch& batch);
  void draw_candidate(const DrawContext<D>& frame, std::size_t candidate, Batch& batch);
  void add_label(const Eigen::Vector3d& point, std::string text);
  void draw_pair(const DrawContext<D>& frame, const Pair& pair, Batch& batch);
  [[nodiscard]] std::optional<Box<D>> box_of(const Selection& selection) const;
  [[nodiscard]] Eigen::Vector3d middle_of(NodeId id) const;

  const GlFunctions& gl_;
  RunOf<D>& run_;
  ScenePainter painter_;
  RunSurvey<D> survey_;
  Box<D> box_;
  Orbit<D> orbit_;
  /// How many wishes of the model for a direction have been met; none: all, since the camera was set later.
  std::optional<std::uint32_t> faced_ = 0;
  int width_ = 1;
  int height_ = 1;
  int samples_ = 0;
  std::optional<Framebuffer> framebuffer_;
  std::optional<Seen> seen_;
  std::uint64_t drawn_ = 0;
  ShownCounts counts_;
  std::optional<Choice> chosen_;
  ShownCounts chosen_counts_;  ///< without what is counted in drawing
  std::vector<SceneLabel> labels_;

  // Of the last drawing.
  std::optional<Position> moment_;
  std::vector<Body<D>> all_bodies_;
  std::vector<Box<D>> crowds_;   ///< by node; empty in 2D
  std::vector<Body<D>> bodies_;  ///< objects that are not shown are absent
  TreeSnapshotOf<D> snapshot_;
  Visibility visible_;
  std::vector<NodeId> partitioners_;  ///< those drawn
  NodeTints tints_;
  std::optional<std::pair<Position, Tint>> tinted_;  ///< of `tints_`
  std::vector<Color> colors_;
  std::vector<Pair> pairs_;
  std::vector<Pair> missed_;  ///< by another engine
  std::vector<Pair> extra_;
  std::array<Batch, 5> batches_;  ///< back, glass, lines, planes, front
  Batch shadows_;
  Overlay triad_;
};

}  // namespace kerf
