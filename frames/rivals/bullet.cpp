#include "frames/rivals/bullet.h"

#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include <utility>

#include "frames/rivals/rival_base.h"

namespace kerf {
namespace {

btVector3 to_bullet(const Vector<3>& v) { return {v[0], v[1], v[2]}; }

/// Bullet keeps its pairs from step to step and adds to them while boxes are set; its boxes are fat or
/// quantised.
class BulletRival final : public RivalBase<3> {
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
  static ObjectId object_of(const btBroadphaseProxy& proxy) {
    return {static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(proxy.m_clientObject))};
  }

  std::string_view name_;
  std::unique_ptr<btBroadphaseInterface> broad_phase_;
  std::vector<btBroadphaseProxy*> proxies_;
};

}  // namespace

std::unique_ptr<BroadPhase<3>> make_bullet_dbvt(const RivalHints<3>& hints, Intake intake) {
  return std::make_unique<BulletRival>("bullet-dbvt", std::make_unique<btDbvtBroadphase>(), hints, intake);
}

std::unique_ptr<BroadPhase<3>> make_bullet_axis_sweep(const RivalHints<3>& hints, Intake intake) {
  // One handle more: the lists have a sentinel. Without the tree for rays.
  auto sweep = std::make_unique<bt32BitAxisSweep3>(to_bullet(hints.bounds.min), to_bullet(hints.bounds.max),
                                                   hints.capacity + 1, nullptr, true);
  return std::make_unique<BulletRival>("bullet-axis-sweep", std::move(sweep), hints, intake);
}

}  // namespace kerf
