#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>

#include <cmath>
#include <memory>

#include "frames/rivals/makers.h"
#include "frames/rivals/query_tests.h"

namespace kerf {
namespace {

using FclObject = fcl::CollisionObject<double>;

fcl::Vector3<double> to_fcl(const Vector<3>& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// A geometry that is only its box.
class OnlyBox final : public fcl::CollisionGeometry<double> {
 public:
  void set(const Box<3>& box) {
    aabb_local.min_ = to_fcl(box.min);
    aabb_local.max_ = to_fcl(box.max);
  }
  void computeLocalAABB() override {}
};

struct Body {
  Body() : geometry(std::make_shared<OnlyBox>()), object(geometry) {}
  void set(const Box<3>& box) {
    geometry->set(box);
    object.computeAABB();
  }
  std::shared_ptr<OnlyBox> geometry;
  FclObject object;
};

ObjectId object_of(const FclObject& object) {
  return {static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(object.getUserData()))};
}

class FclQueries final : public QueryRival<3> {
 public:
  [[nodiscard]] std::string_view name() const override { return "fcl"; }
  void build(std::span<const Box<3>> boxes) override {
    manager_ = std::make_unique<fcl::DynamicAABBTreeCollisionManager<double>>();
    bodies_.clear();
    std::vector<FclObject*> all;
    for (const Box<3>& box : boxes) {
      bodies_.push_back(std::make_unique<Body>());
      bodies_.back()->set(box);
      bodies_.back()->object.setUserData(reinterpret_cast<void*>(std::uintptr_t{all.size()}));
      all.push_back(&bodies_.back()->object);
    }
    boxes_.assign(boxes.begin(), boxes.end());
    manager_->registerObjects(all);
    manager_->setup();
  }
  void move(std::span<const Box<3>> boxes) override {
    boxes_.assign(boxes.begin(), boxes.end());
    for (std::size_t k = 0; k < boxes.size(); ++k) bodies_[k]->set(boxes[k]);
    manager_->update();
    manager_->setup();
  }
  bool overlaps(const Box<3>& box, std::vector<ObjectId>& found) override {
    query(box, [&](ObjectId object, const Box<3>& other) {
      if (kerf::overlaps(box, other)) found.push_back(object);
    });
    return true;
  }
  bool overlaps(const Sphere<3>& sphere, std::vector<ObjectId>& found) override {
    const Vector<3> reach{{sphere.radius, sphere.radius, sphere.radius}};
    query({sphere.center - reach, sphere.center + reach}, [&](ObjectId object, const Box<3>& box) {
      if (quick_distance(sphere.center, box) <= sphere.radius * sphere.radius) found.push_back(object);
    });
    return true;
  }
  bool nearest(const Nearest<3>& nearest, std::vector<Neighbour>& found) override {
    Search search{nearest.point, boxes_, {nearest.count, found}, &asking_.object};
    asking_.set({nearest.point, nearest.point});
    manager_->distance(
        &asking_.object, &search, [](FclObject* a, FclObject* b, void* self, double& distance) {
          auto& s = *static_cast<Search*>(self);
          const ObjectId object = object_of(a == s.asking ? *b : *a);
          s.best.take(object, static_cast<double>(quick_distance(s.point, s.boxes[object.index()])));
          // FCL leaves out what is as far as this.
          if (s.best.is_full()) distance = std::sqrt(s.best.squared_distance()) * (1 + 1e-6);
          return false;
        });
    return true;
  }

 private:
  struct Search {
    Vector<3> point;
    const std::vector<Box<3>>& boxes;
    QuickNearest best;
    const FclObject* asking;
  };
  template <class Take>
  void query(const Box<3>& box, Take take) {
    struct Context {
      Take& take;
      const std::vector<Box<3>>& boxes;
      const FclObject* asking;
    } context{take, boxes_, &asking_.object};
    asking_.set(box);
    manager_->collide(&asking_.object, &context, [](FclObject* a, FclObject* b, void* given) {
      auto& c = *static_cast<Context*>(given);
      const ObjectId object = object_of(a == c.asking ? *b : *a);
      c.take(object, c.boxes[object.index()]);
      return false;
    });
  }

  std::unique_ptr<fcl::DynamicAABBTreeCollisionManager<double>> manager_;
  std::vector<std::unique_ptr<Body>> bodies_;
  std::vector<Box<3>> boxes_;
  Body asking_;
};

}  // namespace

std::unique_ptr<QueryRival<3>> make_fcl_queries() { return std::make_unique<FclQueries>(); }

}  // namespace kerf
