#include <box2d/b2_broad_phase.h>
#include <box2d/b2_dynamic_tree.h>

#include <algorithm>

#include "frames/rivals/box_tree.h"
#include "frames/rivals/makers.h"
#include "frames/rivals/rival_base.h"

namespace kerf {
namespace {

b2AABB to_box2d(const Box<2>& box) {
  b2AABB aabb;
  aabb.lowerBound.Set(box.min[0], box.min[1]);
  aabb.upperBound.Set(box.max[0], box.max[1]);
  return aabb;
}

void* to_user(ObjectId object) { return reinterpret_cast<void*>(std::uintptr_t{object.value}); }
ObjectId to_object(const void* user) {
  return {static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(user))};
}

Box<2> from_box2d(const b2AABB& aabb) {
  return {{{aabb.lowerBound.x, aabb.lowerBound.y}}, {{aabb.upperBound.x, aabb.upperBound.y}}};
}

// Box2D's headers lay its tree open, but no function returns a node. Access is not checked where a template
// is instantiated explicitly, so that these functions may name the members; they only read.
const b2TreeNode* nodes_of(const b2DynamicTree& tree);
int32 root_of(const b2DynamicTree& tree);
int32 count_of(const b2DynamicTree& tree);
const b2DynamicTree& tree_of(const b2BroadPhase& broad_phase);
template <auto Nodes, auto Root, auto Count>
struct TreeAccess {
  friend const b2TreeNode* nodes_of(const b2DynamicTree& tree) { return tree.*Nodes; }
  friend int32 root_of(const b2DynamicTree& tree) { return tree.*Root; }
  friend int32 count_of(const b2DynamicTree& tree) { return tree.*Count; }
};
template struct TreeAccess<&b2DynamicTree::m_nodes, &b2DynamicTree::m_root, &b2DynamicTree::m_nodeCapacity>;
template <auto TreePart>
struct BroadPhaseAccess {
  friend const b2DynamicTree& tree_of(const b2BroadPhase& broad_phase) { return broad_phase.*TreePart; }
};
template struct BroadPhaseAccess<&b2BroadPhase::m_tree>;
const b2DynamicTree& tree_of(const b2DynamicTree& tree) { return tree; }

/// Objects as proxies of a tree or broad phase of Box2D's.
template <class Holder>
class Box2dRival : public RivalBase<2> {
 public:
  Box2dRival(const RivalHints<2>& hints, Intake intake) : RivalBase<2>(hints, intake) {
    proxies_.reserve(hints.capacity);
  }

 protected:
  void add(ObjectId object, const Box<2>& box, bool /*fixed*/) override {
    if (proxies_.size() <= object.index()) proxies_.resize(object.index() + 1, kNone);
    proxies_[object.index()] = holder_.CreateProxy(to_box2d(box), to_user(object));
  }
  void change(ObjectId object, const Box<2>& box) override {
    // Without a displacement: the tree then fattens evenly.
    holder_.MoveProxy(proxies_[object.index()], to_box2d(box), b2Vec2_zero);
  }
  void drop(ObjectId object) override {
    holder_.DestroyProxy(proxies_[object.index()]);
    proxies_[object.index()] = kNone;
  }

  void tell_structure(StructureParts<2>& parts) const override {
    const b2DynamicTree& tree = tree_of(holder_);
    const b2TreeNode* const nodes = nodes_of(tree);
    const auto look = [nodes](int32 id) -> BoxTreeNode<2, int32> {
      const b2TreeNode& node = nodes[id];
      return {from_box2d(node.aabb), node.IsLeaf(), to_object(node.userData),
              node.child1,           node.child2,   static_cast<std::uint32_t>(id)};
    };
    parts.kind = "tree of boxes";
    if (root_of(tree) != kNone) tell_box_tree(root_of(tree), look, parts);
    tell_candidates(parts);
    parts.bytes = static_cast<std::uint64_t>(count_of(tree)) * sizeof(b2TreeNode);
  }

  static constexpr int32 kNone = -1;
  Holder holder_;
  std::vector<int32> proxies_;
};

class TreeRival final : public Box2dRival<b2DynamicTree> {
 public:
  using Box2dRival::Box2dRival;
  [[nodiscard]] std::string_view name() const override { return "box2d-tree"; }
  bool QueryCallback(int32 proxy) {  // NOLINT(readability-identifier-naming): Box2D's name
    const ObjectId other = to_object(holder_.GetUserData(proxy));
    // Of two moving objects the one with the smaller id reports the pair.
    if (asking_ < other || (is_fixed(other) && asking_ != other)) report_candidate(asking_, other);
    return true;
  }

 private:
  void find_pairs() override {
    for (std::uint32_t id = 0; id < proxies_.size(); ++id) {
      asking_ = {id};
      if (proxies_[id] != kNone && !is_fixed(asking_)) holder_.Query(this, to_box2d(shown(asking_)));
    }
  }
  ObjectId asking_;
};

class BroadPhaseRival final : public Box2dRival<b2BroadPhase> {
 public:
  using Box2dRival::Box2dRival;
  [[nodiscard]] std::string_view name() const override { return "box2d-broad-phase"; }
  void AddPair(void* user_a, void* user_b) {  // NOLINT(readability-identifier-naming): Box2D's name
    const ObjectId a = to_object(user_a);
    const ObjectId b = to_object(user_b);
    if (is_fixed(a) && is_fixed(b)) return;
    // As Box2D does it: the shorter of the two lists of partners is searched.
    const bool fewer = partners_[a.index()].size() <= partners_[b.index()].size();
    const std::vector<ObjectId>& list = partners_[(fewer ? a : b).index()];
    if (std::find(list.begin(), list.end(), fewer ? b : a) != list.end()) return;
    partners_[a.index()].push_back(b);
    partners_[b.index()].push_back(a);
  }

 private:
  void add(ObjectId object, const Box<2>& box, bool fixed) override {
    Box2dRival::add(object, box, fixed);
    if (partners_.size() <= object.index()) partners_.resize(object.index() + 1);
  }
  void drop(ObjectId object) override {
    for (const ObjectId partner : partners_[object.index()]) forget(partner, object);
    partners_[object.index()].clear();
    Box2dRival::drop(object);
  }
  void find_pairs() override { holder_.UpdatePairs(this); }
  void collect_pairs() override {
    for (std::uint32_t id = 0; id < partners_.size(); ++id) report_partners({id});
  }
  /// Reports the overlaps with later objects and drops the partners that have moved far enough away.
  void report_partners(ObjectId object) {
    std::vector<ObjectId>& list = partners_[object.index()];
    for (std::size_t k = 0; k < list.size();) {
      const ObjectId other = list[k];
      if (other < object || holder_.TestOverlap(proxies_[object.index()], proxies_[other.index()])) {
        if (object < other) report_candidate(object, other);
        ++k;
        continue;
      }
      forget(other, object);
      list[k] = list.back();
      list.pop_back();
    }
  }
  void forget(ObjectId of, ObjectId partner) {
    std::vector<ObjectId>& list = partners_[of.index()];
    const auto place = std::find(list.begin(), list.end(), partner);
    *place = list.back();
    list.pop_back();
  }

  std::vector<std::vector<ObjectId>> partners_;  ///< per object: those with fat boxes that overlap its own
};

}  // namespace

std::unique_ptr<BroadPhase<2>> make_box2d_tree(const RivalHints<2>& hints, Intake intake) {
  return std::make_unique<TreeRival>(hints, intake);
}

std::unique_ptr<BroadPhase<2>> make_box2d_broad_phase(const RivalHints<2>& hints, Intake intake) {
  return std::make_unique<BroadPhaseRival>(hints, intake);
}

}  // namespace kerf
