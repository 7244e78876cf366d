#include <fcl/fcl.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "sims3d/fcl/fcl_manager.h"
#include "tests/bench/adapter_steps/contest.h"

namespace kerf::adapters {
namespace {

/// FCL moves nothing by itself: balls fly straight and are reflected by the walls; in the heap each swings
/// about its place. A step moves them, updates the manager, and runs FCL's narrow phase on each pair. Of the
/// two ways to update all objects, FCL's own tree gets the faster one: in the gas that with a list, since
/// without one its boxes grow from step to step.
class FclScene {
 public:
  FclScene(const Start& start, std::unique_ptr<fcl::BroadPhaseCollisionManager<double>> manager)
      : start_(start), manager_(std::move(manager)) {
    const auto ball = std::make_shared<fcl::Sphere<double>>(0.5);
    for (std::size_t k = 0; k < start.positions.size(); ++k)
      all_.push_back(objects_.emplace_back(std::make_unique<fcl::CollisionObject<double>>(ball)).get());
    place();
    manager_->registerObjects(all_);
    manager_->setup();
  }
  void step() {
    ++step_;
    place();
    if (start_.gravity > 0) {
      manager_->update();
    } else {
      manager_->update(all_);
    }
    manager_->collide(&found_, [](auto* a, auto* b, void* data) {
      fcl::CollisionRequest<double> request;
      fcl::CollisionResult<double> result;
      *static_cast<std::size_t*>(data) += fcl::collide(a, b, request, result);
      return false;
    });
  }
  void collide_balls(const Start& start) {
    place_at_each(start, [this] {
      manager_->collide(&probe_, &found_, [](auto* /*a*/, auto* /*b*/, void* data) {
        ++*static_cast<std::size_t*>(data);
        return false;
      });
    });
  }
  void find_nearest(const Start& start) {
    place_at_each(start, [this] {
      double least = std::numeric_limits<double>::max();
      manager_->distance(&probe_, &least, [](auto* a, auto* b, void* data, double& bound) {
        fcl::DistanceRequest<double> request;
        fcl::DistanceResult<double> result;
        auto& nearest = *static_cast<double*>(data);
        bound = nearest = std::min(nearest, fcl::distance(a, b, request, result));
        return bound <= 0;
      });
    });
  }

 private:
  [[nodiscard]] double coordinate(std::size_t object, std::size_t axis) const {
    const double from = start_.positions[object][axis];
    const double time = kSeconds * step_;
    if (start_.gravity > 0) return from + 0.1 * std::sin(3 * time + static_cast<double>(object * 7 + axis));
    const double span = start_.side;
    const double there = std::fmod(from + time * start_.velocities[object][axis] + 1000 * span, 2 * span);
    return std::min(there, 2 * span - there);
  }
  template <class Ask>
  void place_at_each(const Start& start, Ask ask) {
    for (const std::vector<double>& ray : start.rays) {
      probe_.setTranslation({ray[0], ray[1], ray[2]});
      probe_.computeAABB();
      ask();
    }
  }
  void place() {
    for (std::size_t k = 0; k < objects_.size(); ++k) {
      objects_[k]->setTranslation({coordinate(k, 0), coordinate(k, 1), coordinate(k, 2)});
      objects_[k]->computeAABB();
    }
  }

  const Start start_;
  std::vector<std::unique_ptr<fcl::CollisionObject<double>>> objects_;
  std::unique_ptr<fcl::BroadPhaseCollisionManager<double>> manager_;
  std::vector<fcl::CollisionObject<double>*> all_;
  fcl::CollisionObject<double> probe_{std::make_shared<fcl::Sphere<double>>(1.0)};
  std::size_t found_ = 0;
  int step_ = 0;
};

}  // namespace

Contest fcl_contest(const Start& start) {
  const auto own =
      std::make_shared<FclScene>(start, std::make_unique<fcl::DynamicAABBTreeCollisionManager<double>>());
  const auto ours = std::make_shared<FclScene>(start, std::make_unique<FclManager<double>>());
  return {"FCL",
          "DynamicAABBTreeCollisionManager",
          [own] { own->step(); },
          [ours] { ours->step(); },
          {{"one object", [own](const Start& rays) { own->collide_balls(rays); },
            [ours](const Start& rays) { ours->collide_balls(rays); }},
           {"nearest object", [own](const Start& rays) { own->find_nearest(rays); },
            [ours](const Start& rays) { ours->find_nearest(rays); }}}};
}

}  // namespace kerf::adapters
