#include "core/query/explain_ray.h"

#include <algorithm>
#include <limits>

#include "core/base/counted.h"
#include "core/query/text.h"

namespace kerf {
namespace {

/// Where the ray is between the ends of a box on one axis.
struct AxisStay {
  char axis = 'x';
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  Interval ends;
};

std::string stay_text(const AxisStay& stay) {
  return std::string(1, stay.axis) + " " + interval_text(stay.ends);
}

template <int D>
std::string vector_text(const Vector<D>& v) {
  std::string text = "(";
  for (int i = 0; i < D; ++i) text += (i == 0 ? "" : ", ") + number_text(static_cast<double>(v[i]));
  return text + ")";
}

std::string hit_text(const Hit& hit, const GivenNames& names) {
  return names.object(hit.object) + " at t = " + number_text(static_cast<double>(hit.t));
}

template <int D>
std::string fate_text(const RayExplanation<D>& e, const RayVisit<D>& v) {
  const NodeVisit& visit = v.visit;
  switch (visit.fate) {
    case NodeFate::apart:
      return "pruned, " + apart_text(e.ray, v.bounds);
    case NodeFate::later:
      return "pruned, its bounds begin at t = " + number_text(visit.key) + ", after what is hit already";
    case NodeFate::visited:
      break;
  }
  std::string text = "visited, its bounds begin at t = " + number_text(visit.key);
  if (!v.is_leaf) return text;
  text += ": " + counted(visit.tested, "box", "boxes") + " tested";
  return text + (visit.found == 0 ? ", none nearer" : ", " + std::to_string(visit.found) + " nearer");
}

template <int D>
std::string visit_text(const RayExplanation<D>& e, const RayVisit<D>& v) {
  return "  " + std::string(std::size_t{2} * v.depth, ' ') + node_text(v.visit.node) +
         (v.is_leaf ? ", a leaf: " : ", " + plane_text(v.plane) + ": ") + fate_text(e, v) + "\n";
}

template <int D>
std::string visits_text(const RayExplanation<D>& e) {
  const auto pruned =
      std::ranges::count_if(e.visits, [](const RayVisit<D>& v) { return v.visit.fate != NodeFate::visited; });
  std::string text = "the tree looks at " + counted(e.visits.size(), "node") +
                     " to find the first, and prunes " + std::to_string(pruned) + " of them:\n";
  for (const RayVisit<D>& v : e.visits) text += visit_text(e, v);
  return text;
}

}  // namespace

template <int D>
std::string apart_text(const Ray<D>& ray, const Box<D>& box) {
  if (box.min[0] > box.max[0]) return "nothing is stored there";
  std::vector<AxisStay> stays;
  for (int i = 0; i < D; ++i) {
    AxisStay stay{"xyz" [i], 0, 0, { box.min[i], box.max[i] }};
    const auto origin = static_cast<double>(ray.origin[i]);
    const auto direction = static_cast<double>(ray.direction[i]);
    const double low = static_cast<double>(box.min[i]) - origin;
    const double high = static_cast<double>(box.max[i]) - origin;
    if (direction == 0 && (low > 0 || high < 0))
      return std::string(1, stay.axis) + " stays " + number_text(origin) + ", beside " + stay_text(stay);
    if (direction == 0) continue;
    stay.from = std::min(low / direction, high / direction);
    stay.to = std::max(low / direction, high / direction);
    if (stay.to < 0) return stay_text(stay) + " lies behind it";
    if (stay.from > static_cast<double>(ray.max_t)) return "it ends before " + stay_text(stay);
    stays.push_back(stay);
  }
  if (stays.empty()) return "it does not move";
  const AxisStay& last = *std::ranges::max_element(stays, {}, &AxisStay::from);
  const AxisStay& first = *std::ranges::min_element(stays, {}, &AxisStay::to);
  return "it leaves " + stay_text(first) + " at t = " + number_text(first.to) + " and comes to " +
         stay_text(last) + " at t = " + number_text(last.from);
}

template <int D>
RayExplanation<D> explain_ray(Replayer<D>& replayer, std::uint32_t step, const Ray<D>& ray) {
  RayExplanation<D> result;
  result.step = step;
  result.ray = ray;
  replayer.seek(step);
  const Tree<D>& tree = replayer.tree().tree();
  TreeWalk<D> walk(tree, replayer.tree().objects());
  result.objects = tree.objects();
  result.status = walk.hits(ray, result.hits);
  Hit first;
  if (result.status != QueryStatus::ok || walk.first_hit(ray, first) != QueryStatus::ok) return result;
  for (const NodeVisit& visit : walk.visits()) {
    const Node<D>& node = tree[visit.node];
    result.visits.push_back({visit, node.depth, node.is_leaf(), node.plane, walk.bounds(visit.node)});
  }
  return result;
}

template <int D>
std::string to_text(const RayExplanation<D>& e, const GivenNames& names) {
  std::string text = "after step " + names.step(e.step) + ", the ray from " + vector_text(e.ray.origin) +
                     " along " + vector_text(e.ray.direction);
  if (e.status != QueryStatus::ok) return text + " is no ray: " + std::string(to_string(e.status)) + "\n";
  text += " hits " + std::to_string(e.hits.size()) + " of " + counted(e.objects, "object");
  text += e.hits.empty() ? "\n" : ", the first is " + hit_text(e.hits.front(), names) + "\n";
  text += visits_text(e);
  if (e.hits.size() > 1) text += "behind the first it hits:\n";
  for (std::size_t k = 1; k < e.hits.size(); ++k) text += "  " + hit_text(e.hits[k], names) + "\n";
  return text;
}

#define KERF_INSTANTIATE(D)                                                              \
  template RayExplanation<D> explain_ray<D>(Replayer<D>&, std::uint32_t, const Ray<D>&); \
  template std::string apart_text<D>(const Ray<D>&, const Box<D>&);                      \
  template std::string to_text<D>(const RayExplanation<D>&, const GivenNames&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
