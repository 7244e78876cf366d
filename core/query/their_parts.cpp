#include "core/query/their_parts.h"

#include <algorithm>
#include <map>
#include <utility>

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
    for (const ObjectId object : told.objects) made_.parts.members.push_back({cell, object});
  }

  void add_circle(std::uint32_t node) {
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
std::vector<KnownObject<D>> objects_for(const TheirStructure<D>& structure, const ObjectTable<D>& objects) {
  const bool has_fixed = std::ranges::any_of(structure.nodes, [&](const TheirNode<D>& node) {
    return std::ranges::any_of(
        node.objects, [&](ObjectId object) { return objects.is_placed(object) && objects.is_fixed(object); });
  });
  std::vector<KnownObject<D>> known;
  for (std::uint32_t id = 0; id < objects.bound(); ++id)
    if (objects.is_placed({id}) && (has_fixed || !objects.is_fixed({id})))
      known.push_back({{id}, objects.box({id})});
  return known;
}

template <int D>
std::vector<StructureFault> check_theirs(const TheirStructure<D>& structure, const ObjectTable<D>& objects,
                                         const GivenNames& names, StructureLimits limits) {
  TheirParts<D> theirs = parts_of(structure);
  limits.margins = std::move(theirs.margins);
  limits.rounding = kSixDigits;
  const StructureNames called{[&](ObjectId object) { return names.object(object); },
                              [&](std::uint32_t place) { return node_name(structure, place); }};
  std::vector<StructureFault> faults = std::move(theirs.faults);
  std::ranges::move(check_structure<D>(theirs.parts, objects_for(structure, objects), {}, limits, called),
                    std::back_inserter(faults));
  return faults;
}

#define KERF_INSTANTIATE(D)                                                                          \
  template std::string node_name(const TheirStructure<D>&, std::uint32_t);                           \
  template TheirParts<D> parts_of(const TheirStructure<D>&);                                         \
  template std::vector<KnownObject<D>> objects_for(const TheirStructure<D>&, const ObjectTable<D>&); \
  template std::vector<StructureFault> check_theirs(const TheirStructure<D>&, const ObjectTable<D>&, \
                                                    const GivenNames&, StructureLimits);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
