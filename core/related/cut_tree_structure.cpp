#include "core/related/cut_tree_structure.h"

#include <cmath>
#include <limits>
#include <vector>

namespace kerf {
namespace {

/// What lies in front of a cut begins before it, and so at the last number before it or earlier.
template <int D>
Plane<D> plane_of(const typename CutTree<D>::Node& node) {
  Plane<D> plane;
  plane.normal[node.axis] = 1;
  plane.offset = std::nextafter(node.cut, -std::numeric_limits<Scalar>::infinity());
  return plane;
}

template <int D>
class CutTreeTeller {
 public:
  CutTreeTeller(const CutTree<D>& tree, StructureParts<D>& parts) : tree_(tree), parts_(parts) {}

  void tell(typename CutTree<D>::Index index, std::uint32_t parent, std::uint32_t cut) {
    const auto& node = tree_[index];
    const auto cell = static_cast<std::uint32_t>(parts_.cells.size());
    parts_.cells.push_back({node.region, index, parent, node.depth, cut});
    if (node.is_leaf()) return tell_entries(node.entries, cell);
    tell(node.below, cell, add_cut({plane_of<D>(node), false}));
    tell(node.above, cell, add_cut({plane_of<D>(node), true}));
  }

 private:
  std::uint32_t add_cut(const Cut<D>& cut) {
    parts_.cuts.push_back(cut);
    return static_cast<std::uint32_t>(parts_.cuts.size() - 1);
  }

  void tell_entries(const std::vector<ObjectId>& entries, std::uint32_t cell) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      parts_.members.push_back({cell, entries[i]});
      for (std::size_t k = i + 1; k < entries.size(); ++k) parts_.tell_tested(entries[i], entries[k]);
    }
  }

  const CutTree<D>& tree_;
  StructureParts<D>& parts_;
};

}  // namespace

template <int D>
void describe_cut_tree(const CutTree<D>& tree, StructureParts<D>& parts) {
  parts.kind = "tree of cuts along the axes";
  parts.holding = Holding::reaching;
  CutTreeTeller<D>(tree, parts).tell(tree.root(), kNoPart, kNoPart);
  parts.end_tested();
  parts.bytes = tree.bytes();
}

template void describe_cut_tree(const CutTree<2>&, StructureParts<2>&);
template void describe_cut_tree(const CutTree<3>&, StructureParts<3>&);

}  // namespace kerf
