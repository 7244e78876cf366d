#include "core/query/their_parts.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "core/base/float_mode.h"

namespace kerf {
namespace {

template <int D>
class PartsMaker {
 public:
  explicit PartsMaker(const TheirStructure<D>& structure) : structure_(structure) {}

  TheirParts<D> run() {
    made_.parts.kind = "tree of boxes of another engine";
    made_.parts.unseen = "which boxes it compares is not known";
    find_parents();
    for (std::uint32_t node = 0; node < count(); ++node)
      if (parents_[node] == kNoPart) add_below(node);
    for (std::uint32_t node = 0; node < count(); ++node)
      if (cells_[node] == kNoPart) add_circle(node);
    check_leaves();
    return std::move(made_);
  }

 private:
  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(structure_.nodes.size()); }

  void add_fault(StructureFaultKind kind, std::uint32_t node, std::string text) {
    made_.faults.push_back({kind, first_[structure_.nodes[node].name], {}, std::move(text)});
  }

  void find_parents() {
    for (std::uint32_t node = 0; node < count(); ++node) first_.emplace(structure_.nodes[node].name, node);
    parents_.assign(count(), kNoPart);
    children_.resize(count());
    cells_.assign(count(), kNoPart);
    for (std::uint32_t node = 0; node < count(); ++node) {
      const auto& parent = structure_.nodes[node].parent;
      if (!parent) continue;
      const auto found = first_.find(*parent);
      if (found != first_.end()) {
        parents_[node] = found->second;
        children_[found->second].push_back(node);
      } else {
        add_fault(
            StructureFaultKind::node_lost, node,
            node_name(structure_, node) + " is lost: its parent n" + to_string(*parent) + " is no node");
      }
    }
  }

  /// Each node once: the second of a name has no children of its own.
  void add_below(std::uint32_t root) {
    std::vector<std::uint32_t> todo{root};
    while (!todo.empty()) {
      const std::uint32_t node = todo.back();
      todo.pop_back();
      if (cells_[node] != kNoPart) continue;
      add_cell(node);
      todo.insert(todo.end(), children_[node].rbegin(), children_[node].rend());
    }
  }

  void add_cell(std::uint32_t node) {
    const TheirNode<D>& told = structure_.nodes[node];
    const auto cell = static_cast<std::uint32_t>(made_.parts.cells.size());
    cells_[node] = cell;
    const std::uint32_t parent = parents_[node] == kNoPart ? kNoPart : cells_[parents_[node]];
    const std::uint32_t depth = parent == kNoPart ? 0 : made_.parts.cells[parent].depth + 1;
    made_.parts.cells.push_back({told.box, first_[told.name], parent, depth, kNoPart});
    made_.margins.push_back(told.margin);
    std::vector<ObjectId> objects = told.objects;  // one that is named twice is there once
    std::ranges::sort(objects);
    objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
    for (const ObjectId object : objects) made_.parts.members.push_back({cell, object});
  }

  /// A node of the circle becomes a root; what hangs below the circle stays there.
  void add_circle(std::uint32_t node) {
    for (std::set<std::uint32_t> seen; seen.insert(node).second;) node = parents_[node];
    add_fault(
        StructureFaultKind::node_lost, node,
        node_name(structure_, node) + " is lost: it hangs below itself, and no way leads to it from a root");
    parents_[node] = kNoPart;
    add_below(node);
  }

  void check_leaves() {
    for (std::uint32_t node = 0; node < count(); ++node)
      if (structure_.nodes[node].leaf.value_or(false) && !children_[node].empty())
        add_fault(StructureFaultKind::leaf_with_children, node,
                  node_name(structure_, node) + " is called a leaf, and has the child " +
                      node_name(structure_, children_[node].front()));
  }

  const TheirStructure<D>& structure_;
  std::map<GivenId, std::uint32_t> first_;
  std::vector<std::uint32_t> parents_;  ///< by node
  std::vector<std::vector<std::uint32_t>> children_;
  std::vector<std::uint32_t> cells_;
  TheirParts<D> made_;
};

/// Without fixed ones where engines keep these apart.
template <int D>
std::vector<KnownObject<D>> objects_for(const ObjectTable<D>& objects, bool with_fixed) {
  std::vector<KnownObject<D>> known;
  for_each_placed(objects, [&](ObjectId object) {
    if (with_fixed || !objects.is_fixed(object)) known.push_back({object, objects.box(object)});
  });
  return known;
}

/// By cell. A leaf is the same as before if its name and its objects are.
template <int D>
std::vector<Scalar> margins_to_judge(const TheirStructure<D>& structure, const TheirParts<D>& theirs,
                                     const TheirPast<D>& past, Scalar asked) {
  if (!(asked > 0) && std::ranges::all_of(theirs.margins, [](Scalar claimed) { return !(claimed > 0); }))
    return {};
  std::map<GivenId, const TheirNode<D>*> before;
  if (past.structure != nullptr)
    for (const TheirNode<D>& node : past.structure->nodes) before.emplace(node.name, &node);
  std::vector<Scalar> margins;
  for (std::uint32_t cell = 0; cell < theirs.parts.cells.size(); ++cell) {
    const StructureCell<D>& told = theirs.parts.cells[cell];
    const TheirNode<D>& node = structure.nodes[told.name];
    const auto found = before.find(node.name);
    const bool is_new = found == before.end() || found->second->objects != node.objects;
    const bool is_placed_anew = !is_new && found->second->box != told.box;
    const Scalar claimed = is_placed_anew && past.is_next ? theirs.margins[cell] : 0;
    margins.push_back(std::max(claimed, is_new || is_placed_anew ? asked : 0));
  }
  return margins;
}

template <int D>
bool most_leaves_hold(const StructureParts<D>& parts) {
  std::vector<std::uint8_t> is_leaf(parts.cells.size(), 1);
  for (const StructureCell<D>& cell : parts.cells)
    if (cell.parent != kNoPart) is_leaf[cell.parent] = 0;
  const auto leaves = std::ranges::count(is_leaf, 1);
  for (const CellMember& member : parts.members) is_leaf[member.cell] = 0;
  return 2 * std::ranges::count(is_leaf, 1) < leaves;
}

/// Whether it is wrong that a leaf holds no object. A root alone is an empty tree.
template <int D>
bool must_hold(const TheirNode<D>& leaf, bool most_leaves_do) {
  return leaf.leaf ? *leaf.leaf : leaf.parent.has_value() && most_leaves_do;
}

}  // namespace

template <int D>
std::string node_name(const TheirStructure<D>& structure, std::uint32_t place) {
  return "n" + to_string(structure.nodes[place].name);
}

template <int D>
TheirParts<D> parts_of(const TheirStructure<D>& structure) {
  return PartsMaker<D>(structure).run();
}

template <int D>
bool holds_fixed(const TheirStructure<D>& structure, const ObjectTable<D>& objects) {
  return std::ranges::any_of(structure.nodes, [&](const TheirNode<D>& node) {
    return std::ranges::any_of(
        node.objects, [&](ObjectId object) { return objects.is_placed(object) && objects.is_fixed(object); });
  });
}

StructureTolerance tolerance_of(const std::optional<TheirDigits>& digits) {
  constexpr BoundTolerance kSixDigits{1e-5, 0};
  constexpr double kUlps = 2;
  if (!digits) return {kSixDigits, kSixDigits};
  return {{0, kUlps}, {0, kUlps, digits->nodes, digits->boxes}};
}

template <int D>
std::vector<StructureFault> check_theirs(const TheirStructure<D>& structure, const ObjectTable<D>& objects,
                                         const GivenNames& names, const TheirPast<D>& past,
                                         StructureLimits limits) {
  const DefaultFloats floats;
  const TheirParts<D> theirs = parts_of(structure);
  limits.margins = margins_to_judge(structure, theirs, past, limits.margin);
  limits.margin = 0;
  limits.tolerance = tolerance_of(structure.digits);
  const StructureNames called{[&](ObjectId object) { return names.object(object); },
                              [&](std::uint32_t place) { return node_name(structure, place); }};
  const auto known = objects_for(objects, past.held_fixed || holds_fixed(structure, objects));
  std::vector<StructureFault> faults = theirs.faults;
  std::ranges::move(check_structure<D>(theirs.parts, known, {}, limits, called), std::back_inserter(faults));
  if (structure.nodes.empty())
    for (const KnownObject<D>& one : known)
      faults.push_back({StructureFaultKind::object_in_no_cell, kNoPart, one.object,
                        "object " + names.object(one.object) + " is in no cell"});
  const bool most_hold = most_leaves_hold(theirs.parts);
  std::erase_if(faults, [&](const StructureFault& fault) {
    if (fault.kind == StructureFaultKind::unknown_object)
      return objects.state(fault.object) != ObjectState::absent;  // it has no box that could be compared
    return fault.kind == StructureFaultKind::leaf_without_object &&
           !must_hold(structure.nodes[fault.cell], most_hold);
  });
  return faults;
}

#define KERF_INSTANTIATE(D)                                                                          \
  template std::string node_name(const TheirStructure<D>&, std::uint32_t);                           \
  template TheirParts<D> parts_of(const TheirStructure<D>&);                                         \
  template bool holds_fixed(const TheirStructure<D>&, const ObjectTable<D>&);                        \
  template std::vector<StructureFault> check_theirs(const TheirStructure<D>&, const ObjectTable<D>&, \
                                                    const GivenNames&, const TheirPast<D>&,          \
                                                    StructureLimits);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
