#include <fcl/broadphase/broadphase_SaP.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/broadphase_interval_tree.h>
#include <fcl/broadphase/broadphase_spatialhash.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "frames/rivals/box_tree.h"
#include "frames/rivals/fastest_way.h"
#include "frames/rivals/makers.h"
#include "frames/rivals/rival_base.h"

namespace kerf {
namespace {

using FclObject = fcl::CollisionObject<double>;
using FclManager = fcl::BroadPhaseCollisionManager<double>;

fcl::Vector3<double> to_fcl(const Vector<3>& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// A geometry that is only its box, so that no centre and extent round it.
class BareBox final : public fcl::CollisionGeometry<double> {
 public:
  explicit BareBox(const Box<3>& box) { set(box); }
  void set(const Box<3>& box) {
    aabb_local.min_ = to_fcl(box.min);
    aabb_local.max_ = to_fcl(box.max);
  }
  void computeLocalAABB() override {}
};

struct FclBody {
  explicit FclBody(ObjectId id, const Box<3>& box)
      : geometry(std::make_shared<BareBox>(box)), object(geometry) {
    object.setUserData(reinterpret_cast<void*>(std::uintptr_t{id.value}));
  }
  void set(const Box<3>& box) {
    geometry->set(box);
    object.computeAABB();
  }
  std::shared_ptr<BareBox> geometry;
  FclObject object;
  bool registered = false;
};

Scalar from_fcl(double x, bool up) { return up ? round_up(x) : round_down(x); }

using FclTree = fcl::DynamicAABBTreeCollisionManager<double>;
using FclNode = fcl::detail::NodeBase<fcl::AABB<double>>;

/// A call that updates a manager after objects moved. The fastest one depends on the manager and on the
/// scene: the dynamic tree's `update()` keeps its form, which is the best for a heap at rest and many times
/// slower than the others where objects leave their neighbours.
enum class FclUpdate : std::uint8_t {
  listed,  ///< update(list of those that moved)
  anew,    ///< clear() and registerObjects
  all      ///< update()
};

/// Boxes change only in `find_pairs`: a manager removes an object by its present box.
class FclRival final : public RivalBase<3> {
 public:
  FclRival(std::string_view name, std::unique_ptr<FclManager> manager, std::vector<FclUpdate> updates,
           const RivalHints<3>& hints, Intake intake)
      : RivalBase<3>(hints, intake), name_(name), manager_(std::move(manager)), updates_(std::move(updates)) {
    if (hints.may_try) trials_.emplace(updates_.size());
    bodies_.reserve(hints.capacity);
  }
  [[nodiscard]] std::string_view name() const override { return name_; }

 private:
  void add(ObjectId object, const Box<3>& box, bool /*fixed*/) override {
    if (bodies_.size() <= object.index()) bodies_.resize(object.index() + 1);
    bodies_[object.index()] = std::make_unique<FclBody>(object, box);
    arriving_.push_back(object);
  }
  void change(ObjectId object, const Box<3>& /*box*/) override { changed_.push_back(object); }
  void drop(ObjectId object) override {
    FclBody& body = *bodies_[object.index()];
    if (body.registered) manager_->unregisterObject(&body.object);
    bodies_[object.index()].reset();
  }
  void find_pairs() override {
    if (!trials_) return follow_objects();
    using Clock = std::chrono::steady_clock;
    const auto from = trials_->is_timed() ? Clock::now() : Clock::time_point{};
    follow_objects();
    const auto spent = trials_->is_timed() ? Clock::now() - from : Clock::duration{};
    trials_->end_step(static_cast<std::uint64_t>(std::chrono::nanoseconds(spent).count()));
  }
  void follow_objects() {
    update();
    enter();
    manager_->setup();
    manager_->collide(this, [](FclObject* a, FclObject* b, void* self) {
      static_cast<FclRival*>(self)->report_candidate(object_of(*a), object_of(*b));
      return false;
    });
  }
  /// Without trials by a rule: the list of those that moved, or all at once if many did.
  [[nodiscard]] FclUpdate way() const {
    constexpr std::size_t kManyOneIn = 8;
    if (trials_) return updates_[trials_->way()];
    return batch_.size() > manager_->size() / kManyOneIn ? updates_.back() : updates_.front();
  }
  void update() {
    batch_.clear();
    for (const ObjectId object : changed_) {
      FclBody* body = bodies_[object.index()].get();
      if (body == nullptr || !body->registered) continue;
      body->set(shown(object));
      batch_.push_back(&body->object);
    }
    changed_.clear();
    if (batch_.empty()) return;
    switch (way()) {
      case FclUpdate::listed:
        return manager_->update(batch_);
      case FclUpdate::anew:
        return register_anew();
      case FclUpdate::all:
        return manager_->update();
    }
  }
  void register_anew() {
    batch_.clear();
    for (const auto& body : bodies_)
      if (body != nullptr && body->registered) batch_.push_back(&body->object);
    manager_->clear();
    manager_->registerObjects(batch_);
  }
  void enter() {
    batch_.clear();
    for (const ObjectId object : arriving_) {
      FclBody* body = bodies_[object.index()].get();
      if (body == nullptr || std::exchange(body->registered, true)) continue;
      body->set(shown(object));
      batch_.push_back(&body->object);
    }
    arriving_.clear();
    manager_->registerObjects(batch_);
  }
  void tell_structure(StructureParts<3>& parts) const override {
    tell_candidates(parts);
    const auto* const tree = dynamic_cast<const FclTree*>(manager_.get());
    if (tree == nullptr) {
      parts.unseen = "this manager of FCL keeps its structure to itself";
      return;
    }
    parts.kind = "tree of boxes";
    if (!tree->empty()) tell_box_tree(static_cast<const FclNode*>(tree->getTree().getRoot()), look, parts);
    parts.bytes = parts.cells.size() * sizeof(FclNode);
  }
  static BoxTreeNode<3, const FclNode*> look(const FclNode* node) {
    BoxTreeNode<3, const FclNode*> told;
    for (int axis = 0; axis < 3; ++axis) {
      told.box.min[axis] = from_fcl(node->bv.min_[axis], false);
      told.box.max[axis] = from_fcl(node->bv.max_[axis], true);
    }
    told.is_leaf = node->isLeaf();
    if (told.is_leaf) {
      told.object = object_of(*static_cast<const FclObject*>(node->data));
    } else {
      told.left = node->children[0];
      told.right = node->children[1];
    }
    return told;
  }
  static ObjectId object_of(const FclObject& object) {
    return {static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(object.getUserData()))};
  }

  std::string_view name_;
  std::vector<std::unique_ptr<FclBody>> bodies_;
  std::unique_ptr<FclManager> manager_;
  std::vector<ObjectId> arriving_;
  std::vector<ObjectId> changed_;
  std::vector<FclObject*> batch_;
  std::vector<FclUpdate> updates_;
  std::optional<FastestWay> trials_;  ///< among them; none: there must be none (RivalHints)
};

std::vector<FclUpdate> any_update() { return {FclUpdate::listed, FclUpdate::anew, FclUpdate::all}; }

}  // namespace

std::unique_ptr<BroadPhase<3>> make_fcl_dynamic_tree(const RivalHints<3>& hints, Intake intake) {
  return std::make_unique<FclRival>("fcl-dynamic-tree",
                                    std::make_unique<fcl::DynamicAABBTreeCollisionManager<double>>(),
                                    any_update(), hints, intake);
}

std::unique_ptr<BroadPhase<3>> make_fcl_sweep_and_prune(const RivalHints<3>& hints, Intake intake) {
  return std::make_unique<FclRival>("fcl-sap", std::make_unique<fcl::SaPCollisionManager<double>>(),
                                    any_update(), hints, intake);
}

std::unique_ptr<BroadPhase<3>> make_fcl_interval_tree(const RivalHints<3>& hints, Intake intake) {
  // Its update(list) looks for the end of an interval by the mark of a beginning (FCL 0.7) and loses pairs.
  return std::make_unique<FclRival>("fcl-interval-tree",
                                    std::make_unique<fcl::IntervalTreeCollisionManager<double>>(),
                                    std::vector{FclUpdate::all}, hints, intake);
}

std::unique_ptr<BroadPhase<3>> make_fcl_spatial_hash(const RivalHints<3>& hints, Intake intake) {
  // FCL's table is as long as it was made, by default 1,000 buckets for any number of objects. Of its updates
  // only update() was never seen to take seconds a step.
  auto manager = std::make_unique<fcl::SpatialHashingCollisionManager<double>>(
      static_cast<double>(hints.box_size), to_fcl(hints.bounds.min), to_fcl(hints.bounds.max),
      std::max(1000U, 4 * hints.capacity));
  return std::make_unique<FclRival>("fcl-spatial-hash", std::move(manager), std::vector{FclUpdate::all},
                                    hints, intake);
}

}  // namespace kerf
