#include "viz/draw/highlights.h"

#include <algorithm>

#include "core/trace/event_facts.h"
#include "viz/draw/palette.h"
#include "viz/draw/strokes.h"

namespace kerf {
namespace {

/// More cells than this would only hide the scene; the newest are kept.
constexpr std::size_t kMostHighlights = 8;

template <int D>
void find_cell(Highlight& highlight, const DrawnTree<D>& tree, const DirectionSet<D>& directions,
               const Box<D>& bounds) {
  const OperatorActed& acted = highlight.acted;
  const NodeId id = acted.node.node;
  const Box<D>& space = crowd_of(tree.crowds, id, bounds);
  highlight.faces = cell_faces(tree.snapshot, id, space);
  if (acted.direction >= directions.size()) return;
  const Vector<D>& normal = directions[acted.direction];
  const auto in_cell = [&](Scalar offset) {
    return partitioner_in_cell(tree.snapshot, id, Plane<D>{normal, offset}, space);
  };
  const bool has_new = acted.op != Operator::merge && acted.op != Operator::swap;
  const bool has_old = acted.op != Operator::split && acted.op != Operator::shift_split;
  if (has_new) highlight.partitioner = in_cell(acted.new_offset);
  if (has_old) highlight.old_partitioner = in_cell(acted.old_offset);
}

std::optional<Eigen::Vector3d> find_anchor(const Highlight& highlight) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0;
  const auto add = [&](const Polygon& polygon) {
    for (const Eigen::Vector3d& p : polygon) sum += p;
    count += static_cast<double>(polygon.size());
  };
  add(highlight.partitioner);
  if (count == 0) add(highlight.old_partitioner);
  if (count == 0) std::ranges::for_each(highlight.faces, add);
  if (count == 0) return std::nullopt;
  return sum / count;
}

bool same_node(const Highlight& a, const Highlight& b) { return a.acted.node == b.acted.node; }

}  // namespace

double Highlight::strength() const { return 1.0 - 0.75 * std::min(age, lifetime) / lifetime; }

std::string Highlight::sentence() const {
  const std::string name = "n" + std::to_string(acted.node.node.value);
  const auto halves = [](const Quality& q, const char* between) {
    return std::to_string(q.left) + between + std::to_string(q.right);
  };
  switch (acted.op) {
    case Operator::split:
      return "leaf " + name + " got crowded: split into " + halves(acted.after, " and ");
    case Operator::shift_split:
      return "leaf " + name + " got crowded: split parallel to its parent's plane into " +
             halves(acted.after, " and ");
    case Operator::merge:
      return "node " + name + " was dissolved into a leaf of " + std::to_string(acted.after.population);
    case Operator::balance:
      return "node " + name + " divided badly (" + halves(acted.before, " | ") + "): its plane moved, " +
             (age == 0 ? "now " : "then ") + halves(acted.after, " | ");
    case Operator::swap:
      return "node " + name + " divided badly (" + halves(acted.before, " | ") + "): its plane was removed";
  }
  return "";
}

std::string Highlight::label() const {
  return std::string(to_string(acted.op)) + " n" + std::to_string(acted.node.node.value);
}

template <int D>
void Highlights<D>::update(const FrameInput<D>& input, const DrawnTree<D>& now, const DrawnTree<D>& before,
                           const Box<D>& bounds) {
  highlights_.clear();
  std::map<std::uint64_t, Highlight> still_remembered;
  for (auto event = input.events.rbegin(); event != input.events.rend(); ++event) {
    const auto* const acted = acted_of(*event);
    if (acted == nullptr || input.tree == nullptr || highlights_.size() == kMostHighlights) continue;
    const std::uint32_t age = input.caption.step > event->step ? input.caption.step - event->step : 0;
    if (age > input.highlight_steps) continue;
    Highlight highlight{event->id, *acted, age, input.highlight_steps, {}, {}, {}, {}};
    const auto known = remembered_.find(event->id);
    if (now.snapshot.is_alive(acted->node)) {
      find_cell(highlight, now, input.tree->directions(), bounds);
    } else if (known != remembered_.end()) {
      highlight = known->second;
      highlight.age = age;
    } else if (before.snapshot.is_alive(acted->node)) {
      find_cell(highlight, before, input.tree->directions(), bounds);
    }
    if (known != remembered_.end()) highlight.anchor = known->second.anchor;
    if (!highlight.anchor) highlight.anchor = find_anchor(highlight);
    still_remembered.emplace(event->id, highlight);
    const auto same = [&](const Highlight& other) { return same_node(highlight, other); };
    if (std::ranges::none_of(highlights_, same)) highlights_.push_back(std::move(highlight));
  }
  remembered_ = std::move(still_remembered);
}

void draw_highlights(const View& view, double line_scale, const std::vector<Highlight>& highlights,
                     Batch& batch, DrawList* list) {
  // The newest comes first in the list and is drawn last, on top.
  for (auto h = highlights.rbegin(); h != highlights.rend(); ++h) {
    const Color color = with_alpha(palette::kOperator, h->strength());
    if (list != nullptr)
      batch.item =
          list->add(DrawnKind::operation, h->acted.node.node.value, static_cast<std::uint32_t>(h->acted.op));
    const double width = (1.2 + 1.8 * h->strength()) * line_scale;
    // The twelve edges of a cell in space hide what is in it: where there are many, planes must do.
    const bool is_solid = h->faces.size() > 1;
    const Stroke edge{color, (is_solid ? 0.5 : 1) * width};
    if (!is_solid || h + 1 == highlights.rend())
      for (const Polygon& face : h->faces) add_outline(batch, view, face, edge);
    add_outline(batch, view, h->old_partitioner, {color, width, 7 * line_scale, 5 * line_scale});
    add_polygon(batch, view, h->partitioner, with_alpha(palette::kOperator, 0.16 * h->strength()));
    add_outline(batch, view, h->partitioner, {color, width});
  }
}

template class Highlights<2>;
template class Highlights<3>;

}  // namespace kerf
