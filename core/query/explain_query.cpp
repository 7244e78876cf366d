#include "core/query/explain_query.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/counted.h"
#include "core/base/float_mode.h"
#include "core/base/overloaded.h"
#include "core/query/text.h"

namespace kerf {
namespace {

/// Where a ray is between the ends of a box on one axis.
struct AxisStay {
  std::string text;  ///< "x [0, 2]"
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
};

std::string axis_text(int axis, const Interval& ends) {
  return std::string(1, "xyz"[axis]) + " " + interval_text(ends);
}

/// Which axis it has left, or does not come to, before another.
template <int D>
std::string apart_text(const Ray<D>& ray, const Box<D>& box) {
  std::vector<AxisStay> stays;
  for (int i = 0; i < D; ++i) {
    AxisStay stay{axis_text(i, {box.min[i], box.max[i]})};
    const auto origin = static_cast<double>(ray.origin[i]);
    const auto direction = static_cast<double>(ray.direction[i]);
    const double low = static_cast<double>(box.min[i]) - origin;
    const double high = static_cast<double>(box.max[i]) - origin;
    if (direction == 0 && (low > 0 || high < 0))
      return std::string(1, "xyz"[i]) + " stays " + number_text(origin) + ", beside " + stay.text;
    if (direction == 0) continue;
    stay.from = std::min(low / direction, high / direction);
    stay.to = std::max(low / direction, high / direction);
    if (stay.to < 0) return stay.text + " lies behind it";
    if (stay.from > static_cast<double>(ray.max_t)) return "it ends before " + stay.text;
    stays.push_back(stay);
  }
  if (stays.empty()) return "it does not move";
  const AxisStay& last = *std::ranges::max_element(stays, {}, &AxisStay::from);
  const AxisStay& first = *std::ranges::min_element(stays, {}, &AxisStay::to);
  return "it leaves " + first.text + " at t = " + number_text(first.to) + " and comes to " + last.text +
         " at t = " + number_text(last.from);
}

/// An axis on which the two lie beside each other.
template <int D>
std::string apart_text(const Box<D>& asked, const Box<D>& box) {
  for (int i = 0; i < D; ++i)
    if (box.min[i] > asked.max[i] || box.max[i] < asked.min[i])
      return axis_text(i, {box.min[i], box.max[i]}) + " lies beside " +
             interval_text({asked.min[i], asked.max[i]});
  return "they do not touch";
}

template <int D>
std::string apart_text(const Sphere<D>& sphere, const Box<D>& box) {
  double squared = 0;
  for (int i = 0; i < D; ++i) {
    const auto center = static_cast<double>(sphere.center[i]);
    const double beside =
        std::max({static_cast<double>(box.min[i]) - center, center - static_cast<double>(box.max[i]), 0.0});
    squared += beside * beside;
  }
  return "its bounds are " + number_text(std::sqrt(squared)) + " away";
}

template <int D>
std::string apart_text(const Nearest<D>& /*nearest*/, const Box<D>& /*box*/) {
  return "its bounds are farther than may be";
}

/// Where the bounds of a node begin: of a query about a region they are reached or not.
template <int D>
std::string begin_text(const AskedQuery<D>& query, double key) {
  return std::visit(
      Overloaded{
          [&](const Ray<D>&) { return ", its bounds begin at t = " + number_text(key); },
          [&](const Nearest<D>&) { return ", its bounds are " + number_text(std::sqrt(key)) + " away"; },
          [](const Box<D>&) { return std::string(); }, [](const Sphere<D>&) { return std::string(); }},
      query);
}

/// What is said of the queries of a kind only.
struct QueryWords {
  const char* aim;    ///< what nodes are looked at for
  const char* later;  ///< why a node is pruned that the query reaches
  const char* found;  ///< what is counted in a leaf
  const char* all;    ///< what is counted in all
};

template <int D>
QueryWords words_of(const AskedQuery<D>& query) {
  constexpr QueryWords kRegion{"", "", " found", " found, "};
  return std::visit(
      Overloaded{
          [](const Ray<D>&) {
            return QueryWords{" to find the first", ", after what is hit already", " nearer", " hit, "};
          },
          [](const Nearest<D>&) {
            return QueryWords{"", ", farther than what is found already", " nearer", " found, "};
          },
          [&](const Box<D>&) { return kRegion; }, [&](const Sphere<D>&) { return kRegion; }},
      query);
}

template <int D>
std::string pruned_text(const QueryExplanation<D>& e, const QueryVisit<D>& v) {
  if (v.bounds.min[0] > v.bounds.max[0]) return "pruned, nothing is stored there";
  if (v.visit.fate == NodeFate::apart)
    return "pruned, " + std::visit([&](const auto& query) { return apart_text(query, v.bounds); }, e.query);
  return "pruned" + begin_text<D>(e.query, v.visit.key) + words_of<D>(e.query).later;
}

template <int D>
std::string fate_text(const QueryExplanation<D>& e, const QueryVisit<D>& v) {
  if (v.visit.fate != NodeFate::visited) return pruned_text(e, v);
  std::string text = "visited" + begin_text<D>(e.query, v.visit.key);
  if (!v.is_leaf) return text;
  text += ": " + counted(v.visit.tested, "box", "boxes") + " tested";
  const std::uint32_t found = v.visit.found;
  return text + (found == 0 ? ", none" : ", " + std::to_string(found)) + words_of<D>(e.query).found;
}

template <int D>
std::string visit_text(const QueryExplanation<D>& e, const QueryVisit<D>& v) {
  return "  " + std::string(std::size_t{2} * v.depth, ' ') + node_text(v.visit.node) +
         (v.is_leaf ? ", a leaf: " : ", " + plane_text(v.plane) + ": ") + fate_text(e, v) + "\n";
}

template <int D>
std::string visits_text(const QueryExplanation<D>& e) {
  std::string text = "the tree looks at " + counted(e.visits.size(), "node") + words_of<D>(e.query).aim +
                     ", and prunes " + std::to_string(e.pruned()) + " of them:\n";
  if (e.waiting > 0)
    text =
        counted(e.waiting, "object") + " changed since the tree was made, and are tested one by one\n" + text;
  for (const QueryVisit<D>& v : e.visits) text += visit_text(e, v);
  return text;
}

std::string at_text(const FoundObject& found, const GivenNames& names, const char* by) {
  return names.object(found.object) + by + number_text(found.key);
}

/// "1, 5 and 12", the first few of many.
std::string names_text(const std::vector<FoundObject>& found, const GivenNames& names) {
  constexpr std::size_t kMost = 20;
  std::string text;
  for (std::size_t k = 0; k < std::min(found.size(), kMost); ++k)
    text += (k == 0 ? "" : ", ") + names.object(found[k].object);
  return found.size() > kMost ? text + " and " + std::to_string(found.size() - kMost) + " more" : text;
}

template <int D>
std::string ray_text(const QueryExplanation<D>& e, const GivenNames& names) {
  std::string text = " hits " + std::to_string(e.found.size()) + " of " + counted(e.objects, "object");
  text += e.found.empty() ? "\n" : ", the first is " + at_text(e.found.front(), names, " at t = ") + "\n";
  text += visits_text(e);
  if (e.found.size() > 1) text += "behind the first it hits:\n";
  for (std::size_t k = 1; k < e.found.size(); ++k)
    text += "  " + at_text(e.found[k], names, " at t = ") + "\n";
  return text;
}

template <int D>
bool is_point(const AskedQuery<D>& query) {
  return std::visit(Overloaded{[](const Sphere<D>& sphere) { return sphere.radius == 0; },
                               [](const auto&) { return false; }},
                    query);
}

template <int D>
std::string region_text(const QueryExplanation<D>& e, const GivenNames& names) {
  const std::string found = std::to_string(e.found.size()) + " of ";
  return (is_point<D>(e.query) ? " lies in " + found + counted(e.objects, "box", "boxes")
                               : " overlaps " + found + counted(e.objects, "object")) +
         (e.found.empty() ? "" : ": " + names_text(e.found, names)) + "\n" + visits_text(e);
}

template <int D>
std::string nearest_text(const QueryExplanation<D>& e, const GivenNames& names) {
  std::string text = " is nearest to";
  if (e.found.empty()) text += " nothing: there is no object";
  for (std::size_t k = 0; k < e.found.size(); ++k)
    text += (k == 0 ? " " : ", ") + at_text(e.found[k], names, " at ");
  return text + "\n" + visits_text(e);
}

template <int D>
QueryStatus ask(TreeWalk<D>& walk, const Ray<D>& ray, std::vector<FoundObject>& found) {
  std::vector<Hit> hits;
  const QueryStatus status = walk.hits(ray, hits);
  for (const Hit& hit : hits) found.push_back({hit.object, static_cast<double>(hit.t)});
  Hit first;
  return status == QueryStatus::ok ? walk.first_hit(ray, first) : status;
}

template <int D>
QueryStatus ask(TreeWalk<D>& walk, const Nearest<D>& nearest, std::vector<FoundObject>& found) {
  std::vector<Neighbour> neighbours;
  const QueryStatus status = walk.nearest(nearest, neighbours);
  for (const Neighbour& one : neighbours) found.push_back({one.object, std::sqrt(one.squared_distance)});
  return status;
}

/// A box or a sphere.
template <int D, class Region>
QueryStatus ask(TreeWalk<D>& walk, const Region& region, std::vector<FoundObject>& found) {
  std::vector<ObjectId> objects;
  const QueryStatus status = walk.overlaps(region, objects);
  for (const ObjectId object : objects) found.push_back({object, 0});
  return status;
}

}  // namespace

template <int D>
std::size_t QueryExplanation<D>::pruned() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      visits, [](const QueryVisit<D>& v) { return v.visit.fate != NodeFate::visited; }));
}

template <int D>
std::size_t QueryExplanation<D>::tested() const {
  std::size_t sum = 0;
  for (const QueryVisit<D>& v : visits) sum += v.visit.tested;
  return sum;
}

template <int D>
QueryExplanation<D> explain_query(const Tree<D>& tree, const ObjectTable<D>& objects,
                                  const AskedQuery<D>& query) {
  const DefaultFloats floats;
  QueryExplanation<D> result;
  result.query = query;
  TreeWalk<D> walk(tree, objects);
  result.objects = tree.objects();
  result.waiting = static_cast<std::uint32_t>(walk.waiting().size());
  result.status = std::visit([&](const auto& asked) { return ask<D>(walk, asked, result.found); }, query);
  if (result.status != QueryStatus::ok) return result;
  for (const NodeVisit& visit : walk.visits()) {
    const Node<D>& node = tree[visit.node];
    result.visits.push_back({visit, node.depth, node.is_leaf(), node.plane, walk.bounds(visit.node)});
  }
  return result;
}

template <int D>
QueryExplanation<D> explain_query(Replayer<D>& replayer, std::uint32_t step, const AskedQuery<D>& query) {
  replayer.seek(step);
  QueryExplanation<D> result = explain_query(replayer.tree().tree(), replayer.tree().objects(), query);
  result.at = Position::end_of(step);
  return result;
}

template <int D>
std::string to_text(const QueryExplanation<D>& e, const GivenNames& names) {
  const DefaultFloats floats;
  std::string text = "after " + to_string(e.at, names) + ", " + to_text(e.query);
  if (e.status != QueryStatus::ok)
    return text + " cannot be asked: " + std::string(to_string(e.status)) + "\n";
  return text + std::visit(Overloaded{[&](const Ray<D>&) { return ray_text(e, names); },
                                      [&](const Nearest<D>&) { return nearest_text(e, names); },
                                      [&](const Box<D>&) { return region_text(e, names); },
                                      [&](const Sphere<D>&) { return region_text(e, names); }},
                           e.query);
}

template <int D>
std::string summary(const QueryExplanation<D>& e) {
  const DefaultFloats floats;
  const std::string kind =
      (is_point<D>(e.query) ? "point" : std::string(kQueryKindNames[e.query.index()])) + ": ";
  if (e.status != QueryStatus::ok) return kind + std::string(to_string(e.status));
  return kind + std::to_string(e.found.size()) + words_of<D>(e.query).all +
         std::to_string(e.visits.size() - e.pruned()) + " of " + counted(e.visits.size(), "node") +
         " visited, " + counted(e.tested(), "box", "boxes") + " tested";
}

#define KERF_INSTANTIATE(D)                                                                         \
  template struct QueryExplanation<D>;                                                              \
  template QueryExplanation<D> explain_query<D>(const Tree<D>&, const ObjectTable<D>&,              \
                                                const AskedQuery<D>&);                              \
  template QueryExplanation<D> explain_query<D>(Replayer<D>&, std::uint32_t, const AskedQuery<D>&); \
  template std::string to_text<D>(const QueryExplanation<D>&, const GivenNames&);                   \
  template std::string summary<D>(const QueryExplanation<D>&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
