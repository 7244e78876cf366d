#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include <utility>

#include "frames/rivals/box_tree.h"
#include "frames/rivals/makers.h"
#include "frames/rivals/rival_base.h"

namespace kerf {
namespace {

btVector3 to_bullet(const Vector<3>& v) { return {v[0], v[1], v[2]}; }
Box<3> from_bullet(const btDbvtVolume& volume) {
  const btVector3& low = volume.Mins();
  const btVector3& high = volume.Maxs();
  return {{{round_down(low.x()), round_down(low.y()), round_down(low.z())}},
          {{round_up(high.x()), round_up(high.y()), round_up(high.z())}}};
}
ObjectId object_of(const btBroadphaseProxy& proxy) {
  return {static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(proxy.m_clientObject))};
}

/// Bullet keeps its pairs from step to step and adds to them while boxes are set; its boxes are fat or
/// quantised.
class BulletRival : public RivalBase<3> {
 public:
  BulletRival(std::string_view name, std::unique_ptr<btBroadphaseInterface> broad_phase,
              const RivalHints<3>& hints, Intake intake)
      : RivalBase<3>(hints, intake), name_(name), broad_phase_(std::move(broad_phase)) {
    proxies_.reserve(hints.capacity);
  }
  ~BulletRival() override {
    for (btBroadphaseProxy* proxy : proxies_)
      if (proxy != nullptr) broad_phase_->destroyProxy(proxy, nullptr);
  }
  [[nodiscard]] std::string_view name() const override { return name_; }

 protected:
  [[nodiscard]] const btBroadphaseInterface& broad_phase() const { return *broad_phase_; }
  [[nodiscard]] std::uint64_t bytes_of_pairs() const {
    return sizeof(btBroadphasePair) *
           static_cast<std::uint64_t>(broad_phase_->getOverlappingPairCache()->getNumOverlappingPairs());
  }

 private:
  void add(ObjectId object, const Box<3>& box, bool fixed) override {
    constexpr int kStatic = btBroadphaseProxy::StaticFilter;
    constexpr int kAll = btBroadphaseProxy::AllFilter;
    if (proxies_.size() <= object.index()) proxies_.resize(object.index() + 1, nullptr);
    proxies_[object.index()] = broad_phase_->createProxy(
        to_bullet(box.min), to_bullet(box.max), 0, reinterpret_cast<void*>(std::uintptr_t{object.value}),
        fixed ? kStatic : btBroadphaseProxy::DefaultFilter, fixed ? kAll ^ kStatic : kAll, nullptr);
  }
  void change(ObjectId object, const Box<3>& box) override {
    broad_phase_->setAabb(proxies_[object.index()], to_bullet(box.min), to_bullet(box.max), nullptr);
  }
  void drop(ObjectId object) override {
    broad_phase_->destroyProxy(proxies_[object.index()], nullptr);
    proxies_[object.index()] = nullptr;
  }
  void find_pairs() override { broad_phase_->calculateOverlappingPairs(nullptr); }
  void collect_pairs() override {
    const btBroadphasePairArray& found = broad_phase_->getOverlappingPairCache()->getOverlappingPairArray();
    for (int i = 0; i < found.size(); ++i)
      report_candidate(object_of(*found[i].m_pProxy0), object_of(*found[i].m_pProxy1));
  }

  std::string_view name_;
  std::unique_ptr<btBroadphaseInterface> broad_phase_;
  std::vector<btBroadphaseProxy*> proxies_;
};

/// Its two trees: of what moved lately, and of what has been at rest for two steps.
class DbvtRival final : public BulletRival {
 public:
  DbvtRival(std::unique_ptr<btDbvtBroadphase> dbvt, const RivalHints<3>& hints, Intake intake)
      : BulletRival("bullet-dbvt", std::move(dbvt), hints, intake) {}

 private:
  void tell_structure(StructureParts<3>& parts) const override {
    parts.kind = "two trees of boxes";
    for (const btDbvt& tree : static_cast<const btDbvtBroadphase&>(broad_phase()).m_sets)
      if (tree.m_root != nullptr) tell_box_tree(static_cast<const btDbvtNode*>(tree.m_root), look, parts);
    tell_candidates(parts);
    parts.bytes = parts.cells.size() * sizeof(btDbvtNode) + bytes_of_pairs();
  }
  static BoxTreeNode<3, const btDbvtNode*> look(const btDbvtNode* node) {
    if (node->isinternal()) return {from_bullet(node->volume), false, {}, node->childs[0], node->childs[1]};
    return {from_bullet(node->volume), true, object_of(*static_cast<const btBroadphaseProxy*>(node->data))};
  }
};

/// Its lists are seen by a class of its kind.
class SeenAxisSweep final : public bt32BitAxisSweep3 {
 public:
  using bt32BitAxisSweep3::bt32BitAxisSweep3;

  [[nodiscard]] AxisList list(int axis) const {
    AxisList told{axis, {}};
    const Edge* const edges = m_pEdges[axis];
    // A sentinel at either end.
    for (unsigned k = 1; k <= 2 * m_numHandles; ++k) {
      const double place =
          double{1} * edges[k].m_pos / double{m_quantize[axis]} + double{m_worldAabbMin[axis]};
      told.ends.push_back(
          {static_cast<Scalar>(place), object_of(*getHandle(edges[k].m_handle)), edges[k].IsMax() != 0});
    }
    return told;
  }
  [[nodiscard]] std::uint64_t bytes() const {
    return std::uint64_t{m_maxHandles} * (sizeof(Handle) + 6 * sizeof(Edge));
  }
};

class AxisSweepRival final : public BulletRival {
 public:
  AxisSweepRival(std::unique_ptr<SeenAxisSweep> sweep, const RivalHints<3>& hints, Intake intake)
      : BulletRival("bullet-axis-sweep", std::move(sweep), hints, intake) {}

 private:
  void tell_structure(StructureParts<3>& parts) const override {
    const auto& sweep = static_cast<const SeenAxisSweep&>(broad_phase());
    parts.kind = "lists along axes";
    for (int axis = 0; axis < 3; ++axis) parts.lists.push_back(sweep.list(axis));
    tell_candidates(parts);
    parts.bytes = sweep.bytes() + bytes_of_pairs();
  }
};

}  // namespace

std::unique_ptr<BroadPhase<3>> make_bullet_dbvt(const RivalHints<3>& hints, Intake intake) {
  return std::make_unique<DbvtRival>(std::make_unique<btDbvtBroadphase>(), hints, intake);
}

std::unique_ptr<BroadPhase<3>> make_bullet_axis_sweep(const RivalHints<3>& hints, Intake intake) {
  // One handle more: the lists have a sentinel. Without the tree for rays.
  auto sweep = std::make_unique<SeenAxisSweep>(to_bullet(hints.bounds.min), to_bullet(hints.bounds.max),
                                               hints.capacity + 1, nullptr, true);
  return std::make_unique<AxisSweepRival>(std::move(sweep), hints, intake);
}

}  // namespace kerf
