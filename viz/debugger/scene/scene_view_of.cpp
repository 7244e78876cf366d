#include "viz/debugger/scene/scene_view_of.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "core/base/overloaded.h"
#include "core/query/text.h"
#include "viz/debugger/model/recent_operators.h"
#include "viz/debugger/scene/body_colors.h"
#include "viz/debugger/scene/node_marks.h"
#include "viz/debugger/scene/outline_box.h"
#include "viz/debugger/scene/pick.h"
#include "viz/debugger/scene/query_view.h"
#include "viz/debugger/scene/ray.h"
#include "viz/debugger/scene/selected_box.h"
#include "viz/debugger/scene/their_nodes_view.h"
#include "viz/draw/palette.h"
#include "viz/draw/recorded_bodies.h"
#include "viz/draw/strokes.h"
#include "viz/draw/structure_draw.h"
#include "viz/draw/themed_batch.h"
#include "viz/draw/triad.h"
#include "viz/draw/wrong_pair_lines.h"

namespace kerf {
namespace {

// More would make a picture slow, and could not be distinguished.
constexpr std::size_t kMostObjects = 10'000;
constexpr std::size_t kMostPartitioners = 1'500;
constexpr std::size_t kMostPairs = 20'000;
constexpr std::size_t kMostPairsInBrief = 1'500;
constexpr double kCellAlpha = 0.5;
constexpr double kTriad = 26;    // pixels of an axis
constexpr double kNarrow = 540;  // in a narrower view text reaches the axes, which then stand above it

}  // namespace

template <int D>
SceneViewOf<D>::SceneViewOf(const GlFunctions& gl, RunOf<D>& run)
    : gl_(gl), run_(run), painter_(gl), survey_(survey(run)), box_(survey_.box) {
  orbit_.set_box(box_);
}

template <int D>
const NodeTints& SceneViewOf<D>::tints(Tint tint) {
  const std::pair wanted{run_.position(), tint};
  if (tinted_ == wanted) return tints_;
  const TreeSnapshot& tree = run_.tree();
  std::vector<std::uint32_t> changes;
  if (tint == Tint::age) changes = last_changes(run_.operators(), run_.position(), tree.nodes().size());
  tints_ = find_tints({tree, run_.position().step, changes}, tint);
  if (tint == Tint::population) tints_.end = survey_.population_end;
  if (tint == Tint::cost) tints_.end = survey_.cost_end;
  tinted_ = wanted;
  return tints_;
}

template <int D>
Color SceneViewOf<D>::color_of_leaf(NodeId leaf) const {
  return tints_.color(leaf, seen_->tint_end);
}

template <int D>
void SceneViewOf<D>::update(const DebuggerModel& model, int width, int height, double tint_end) {
  const ViewFacing& facing = model.view.facing;
  if (std::exchange(faced_, facing.times).value_or(facing.times) != facing.times)
    orbit_.face(facing.direction);
  width_ = std::max(width, 16);
  height_ = std::max(height, 16);
  orbit_.leave_free(look.above, look.below);
  const Seen seen{run_.position(),
                  model.view,
                  model.selection(),
                  model.hovered_node,
                  model.hovered_candidate,
                  orbit_.view(width_, height_),
                  tint_end,
                  width_,
                  height_,
                  look};
  if (seen_ && *seen_ == seen) return;
  if (!moment_ || *moment_ != seen.position) take_moment();
  const bool resized = !seen_ || seen_->width != width_ || seen_->height != height_;
  seen_ = seen;
  const Choice choice{seen.position, seen.settings, seen.tint_end, seen.look.brief};
  if (std::exchange(chosen_, choice) != choice) {
    choose_bodies();
    choose_colors();
    chosen_counts_ = counts_;
  }
  counts_ = chosen_counts_;
  const int samples = counts_.objects < kManyBodies ? 4 : 1;
  if (resized || samples != samples_) framebuffer_.emplace(gl_, width_, height_, samples);
  samples_ = samples;
  painter_.set_scale(look.scale);
  draw(model);
  ++drawn_;
}

template <int D>
void SceneViewOf<D>::take_moment() {
  moment_ = run_.position();
  all_bodies_ = run_.bodies();
  snapshot_ = run_.tree();
  if constexpr (D == 3) crowds_ = find_crowds<D>(run_.state().tree, all_bodies_, box_);
}

template <int D>
void SceneViewOf<D>::choose_bodies() {
  visible_ = find_visible(run_.state().tree, all_bodies_.size(), seen_->settings);
  bodies_ = all_bodies_;
  counts_ = {};
  counts_.lacks_isolated = visible_.lacks_isolated;
  std::size_t wanted = 0;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    if (!is_drawable(all_bodies_[k])) continue;
    ++counts_.all_objects;
    wanted += visible_.objects[k];
  }
  const double share =
      wanted <= kMostObjects ? 1.0 : static_cast<double>(kMostObjects) / static_cast<double>(wanted);
  const bool wanted_objects = seen_->settings.layers.has(Layer::objects);
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    if (visible_.objects[k] == 0 || !is_sampled(k, share)) bodies_[k] = absent_body<D>();
    if (wanted_objects && is_drawable(bodies_[k])) ++counts_.objects;
  }
  const bool wanted_pairs = seen_->settings.layers.has(Layer::pairs);
  const auto drawable = [&](std::span<const Pair> pairs, std::span<const Body<D>> bodies, std::size_t most) {
    return wanted_pairs ? drawable_pairs(pairs, bodies, visible_.objects, most) : std::vector<Pair>();
  };
  pairs_ = drawable(run_.pairs(), bodies_, is_brief() ? kMostPairsInBrief : kMostPairs);
  // Errors are not left out where objects are too many to be drawn.
  const PairJudgement* const theirs = run_.their_judgement();
  missed_ = theirs == nullptr ? std::vector<Pair>() : drawable(theirs->missed, all_bodies_, kMostPairs);
  extra_ = theirs == nullptr ? std::vector<Pair>() : drawable(theirs->extra, all_bodies_, kMostPairs);
  counts_.all_pairs = run_.pairs().size();
  counts_.pairs_note = run_.note_on_pairs();
  counts_.pairs = pairs_.size();
  counts_.missed = missed_.size();
  counts_.extra = extra_.size();
}

template <int D>
void SceneViewOf<D>::choose_colors() {
  (void)tints(seen_->settings.tint);
  counts_.tint_end = seen_->tint_end;
  const bool tinted = seen_->settings.layers.has(Layer::leaves);
  counts_.theirs = seen_->settings.theirs;
  colors_ = counts_.theirs && tinted
                ? object_colors<D>(run_.their_parts(), bodies_)
                : body_colors<D>(bodies_, visible_, tints_, seen_->tint_end, tinted && !counts_.theirs);
}

template <int D>
void SceneViewOf<D>::draw(const DebuggerModel& model) {
  for (Batch& batch : batches_) batch.clear();
  labels_.clear();
  triad_.clear();
  auto& [back, glass, lines, planes, front] = batches_;
  LayerSet layers = seen_->settings.layers;
  if (D == 3 && counts_.theirs) layers = layers.with(Layer::leaves, false);  // these are ours
  const FrameInput<D> input{
      .bodies = bodies_, .tree = nullptr, .pairs = pairs_, .contacts = {}, .events = {}, .caption = {}};
  const std::vector<Placement> placements;
  const double line_scale = look.scale * std::clamp(height_ / (500.0 * look.scale), 0.7, 2.0);
  const DrawContext<D> frame{input,   seen_->view,       snapshot_, placements, box_,
                             layers,  line_scale,        1,         nullptr,    colors_,
                             crowds_, look.theme->scene, is_brief()};
  if (counts_.theirs) draw_theirs(frame, back, planes, front);
  if (!counts_.theirs) draw_nodes(frame, back, planes);
  if constexpr (D == 2) {
    if (layers.has(Layer::objects)) draw_objects(frame, back);
  } else {
    draw_space(frame, leaf_colors(visible_, tints_, seen_->tint_end), {back, glass, shadows_});
    const double below = width_ < kNarrow * look.scale ? look.below : 0;
    draw_triad(frame.view, painter_.font(), {0, 0, double(width_), height_ - below}, Corner::right,
               kTriad * line_scale, triad_);
  }
  draw_pairs(frame, lines);
  if (layers.has(Layer::operators) && !counts_.theirs) draw_event(frame, front);
  draw_selection(frame, front);
  draw_asked(frame, front);
  draw_wrong_pairs<D>(frame, {all_bodies_, missed_, extra_}, front);
  if (model.hovered_candidate) draw_candidate(frame, *model.hovered_candidate, front);
  put_on(*look.theme, batches_);
  put_on(*look.theme, triad_);
  framebuffer_->bind();
  painter_->begin(look.theme->scene);
  painter_->draw(back, D == 3 ? Depth::test_and_write : Depth::ignore, D == 3 ? Blend::replace : Blend::over);
  painter_->draw(shadows_, Depth::test, Blend::replace);
  painter_->draw(glass, D == 3 ? Depth::test : Depth::ignore);
  painter_->draw(planes, D == 3 ? Depth::test : Depth::ignore);
  painter_->draw(lines, D == 3 ? Depth::test : Depth::ignore);
  painter_->draw(front, Depth::ignore);
  painter_->draw(triad_.shapes, Depth::ignore);
  painter_->draw(triad_.text, seen_->view);
}

/// Cells are filled in 2D; partitioners within the visible depths, as many as can be distinguished.
template <int D>
void SceneViewOf<D>::draw_nodes(const DrawContext<D>& frame, Batch& cells, Batch& planes) {
  const ViewSettings& settings = seen_->settings;
  partitioners_.clear();
  for (const NodeId id : back_to_front(snapshot_, seen_->view.eye)) {
    const TreeSnapshot::Node& node = snapshot_[id];
    const bool seen = visible_.nodes[id.index()] != 0;
    if (!node.is_leaf()) {
      ++counts_.all_partitioners;
      const auto depth = static_cast<int>(node.depth);
      const bool wanted = settings.layers.has(Layer::partitioners) && depth >= settings.least_depth &&
                          depth <= settings.greatest_depth && counts_.partitioners < kMostPartitioners;
      if (!seen || !wanted) continue;
      draw_partitioner(frame, id, planes);
      partitioners_.push_back(id);
      ++counts_.partitioners;
    } else if (D == 2 && seen && settings.layers.has(Layer::leaves)) {
      for (const Polygon& cell : cell_faces(snapshot_, id, box_))
        add_polygon(cells, frame.view, cell, with_alpha(color_of_leaf(id), kCellAlpha));
    }
  }
}

template <int D>
void SceneViewOf<D>::draw_theirs(const DrawContext<D>& frame, Batch& cells, Batch& outlines, Batch& front) {
  partitioners_.clear();
  counts_.their_nodes = run_.their_nodes();
  counts_.their_faults = run_.their_faults().size();
  const StructureParts<D>& parts = run_.their_parts();
  draw_their_nodes<D>(frame, parts, seen_->settings.layers, cells, outlines);
  for (auto& [point, text] : draw_their_faults<D>(frame, parts, run_.their_faults(), front))
    add_label(point, std::move(text));
}

template <int D>
void SceneViewOf<D>::add_label(const Eigen::Vector3d& point, std::string text) {
  const auto at = seen_->view.project(point);
  if (at) labels_.push_back({static_cast<float>(at->x()), static_cast<float>(at->y()), std::move(text)});
}

/// At the end of a step: the cells of the nodes on which operators acted in it, and paler those of the steps
/// before.
template <int D>
void SceneViewOf<D>::draw_recent(const DrawContext<D>& frame, Batch& batch) {
  for (const auto& [node, strength] : recent_operators(run_)) {
    if (visible_.nodes[node.index()] == 0) continue;
    const Color color = mix(look.theme->scene, look.theme->mark(palette::kOperator), strength);
    outline_cell(frame, node, {color, (0.5 + 1.5 * strength) * frame.line_scale}, batch);
  }
}

/// Marks the place of the event that has just happened. A swap has removed its node.
template <int D>
void SceneViewOf<D>::draw_event(const DrawContext<D>& frame, Batch& batch) {
  const auto event = run_.event();
  const auto node = run_.event_node();
  if (!event) return draw_recent(frame, batch);
  if (!node) return;
  const auto top = snapshot_.is_alive(*node) ? mark_acted(frame, *node, batch)
                                             : mark_removed(frame, run_.tree_before(event->id), *node, batch);
  if (top) add_label(*top, "e" + std::to_string(event->id) + "  n" + std::to_string(node->value));
}

template <int D>
void SceneViewOf<D>::draw_selection(const DrawContext<D>& frame, Batch& batch) {
  std::visit(Overloaded{
                 [](std::monostate) {},
                 [&](NodeId node) { mark_selected(frame, node, batch); },
                 [&](ObjectId object) { draw_object(frame, object, batch); },
                 [&](const Pair& pair) { draw_pair(frame, pair, batch); },
             },
             seen_->selection);
  if (seen_->hovered && node_in(seen_->selection) != seen_->hovered)
    mark_hovered(frame, *seen_->hovered, batch);
}

template <int D>
void SceneViewOf<D>::draw_asked(const DrawContext<D>& frame, Batch& batch) {
  if (seen_->settings.query.empty()) return;
  const QueryExplanation<D>* const answer = run_.answer(seen_->settings.query);
  if (answer == nullptr) return;
  counts_.query = summary(*answer);
  for (auto& [point, text] : draw_query<D>(frame, *answer, all_bodies_, run_.info().names, batch))
    add_label(point, std::move(text));
}

template <int D>
void SceneViewOf<D>::draw_pair(const DrawContext<D>& frame, const Pair& pair, Batch& batch) {
  draw_object(frame, pair.a, batch);
  draw_object(frame, pair.b, batch);
  const auto a = box_of(pair.a);
  const auto b = box_of(pair.b);
  if (a && b)
    add_line(batch, frame.view, to_point(a->center()), to_point(b->center()),
             {palette::kOperator, 2.5 * frame.line_scale});
}

template <int D>
void SceneViewOf<D>::draw_object(const DrawContext<D>& frame, ObjectId id, Batch& batch) {
  const auto box = box_of(id);
  if (!box) return;
  outline_box(frame, *box, {palette::kOperator, 2 * frame.line_scale}, batch);
  const ObjectMark* const mark = run_.info().marks.find(id);
  const bool is_called = mark != nullptr && !mark->label.empty();
  add_label(to_point(box->max), is_called ? mark->label : run_.info().names.object(id));
}

template <int D>
void SceneViewOf<D>::draw_candidate(const DrawContext<D>& frame, std::size_t candidate, Batch& batch) {
  const auto node = run_.event_node();
  if (!node || candidate >= run_.ballot().size() || !snapshot_.is_alive(*node)) return;
  const Plane<D> plane = run_.plane(candidate);
  const Polygon polygon = partitioner_in_cell(snapshot_, *node, plane, frame.space_of(*node));
  add_polygon(batch, frame.view, polygon, with_alpha(palette::kCandidate, 0.3));
  add_outline(batch, frame.view, polygon, {palette::kCandidate, 4 * frame.line_scale});
  if (!polygon.empty()) add_label(polygon[0], plane_text(plane));
}

template <int D>
std::optional<Box<D>> SceneViewOf<D>::box_of(const Selection& selection) const {
  return kerf::box_of<D>(selection, {run_.state().latest, snapshot_, box_});
}

template <int D>
void SceneViewOf<D>::focus(const Selection& selection) {
  const auto box = box_of(selection);
  if (box) {
    orbit_.look_at(*box, width_, height_);
  } else {
    orbit_.frame_all();
  }
}

template <int D>
void SceneViewOf<D>::look_like(const SceneView& other) {
  std::visit(
      [this]<int OtherD>(const SceneViewOf<OtherD>* same) {
        if constexpr (OtherD == D) {
          orbit_ = same->orbit_;
          box_ = same->box_;
        }
      },
      other.self());
}

template <int D>
Selection SceneViewOf<D>::pick(double x, double y, bool node_wanted) const {
  if (!seen_) return {};
  const bool objects = !node_wanted && seen_->settings.layers.has(Layer::objects);
  if (objects)
    if (const auto object = pick_object<D>(bodies_, seen_->view, {x, y}, look.scale)) return *object;
  if (seen_->settings.theirs) return {};
  const auto node =
      pick_node<D>({snapshot_, partitioners_, visible_.nodes, box_, look.scale, crowds_}, seen_->view, x, y);
  return node ? Selection(*node) : Selection();
}

template <int D>
std::string SceneViewOf<D>::query_at(double x, double y) const {
  return seen_ ? query_through<D>(seen_->view, x, y) : "";
}

template <int D>
std::optional<Pair> SceneViewOf<D>::pick_pair(double x, double y) const {
  if (!seen_) return std::nullopt;
  for (const std::vector<Pair>* const pairs : {&missed_, &extra_, &pairs_})
    if (const auto pair = kerf::pick_pair<D>(*pairs, all_bodies_, seen_->view, {x, y}, look.scale))
      return pair;
  return std::nullopt;
}

/// For a partitioner the middle of its longest edge, since a point within may be hidden.
template <int D>
Eigen::Vector3d SceneViewOf<D>::middle_of(NodeId id) const {
  const TreeSnapshot::Node& node = snapshot_[id];
  if (!node.is_leaf()) {
    const Polygon plane = partitioner_in_cell(snapshot_, id, crowd_of<D>(crowds_, id, box_));
    if (plane.size() >= 2) return middle_of_longest_edge(plane);
  }
  return to_point(box_of(id)->center());
}

template <int D>
std::optional<SceneLabel> SceneViewOf<D>::place_of(const Selection& selection) const {
  const auto box = box_of(selection);
  if (!seen_ || !box) return std::nullopt;
  const auto node = node_in(selection);
  const auto at = seen_->view.project(node ? middle_of(*node) : to_point(box->center()));
  if (!at) return std::nullopt;
  return SceneLabel{static_cast<float>(at->x()), static_cast<float>(at->y()),
                    to_string(selection, run_.info().names)};
}

template class SceneViewOf<2>;
template class SceneViewOf<3>;

}  // namespace kerf
