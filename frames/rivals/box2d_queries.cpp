#include <box2d/b2_dynamic_tree.h>

#include "frames/rivals/makers.h"
#include "frames/rivals/query_tests.h"

namespace kerf {
namespace {

// Box2D adds a margin of 0.1 to each box. In coordinates so large no float is near enough to have one.
constexpr Scalar kScale = 0x1p28F;

b2Vec2 to_box2d(const Vector<2>& v) { return {v[0] * kScale, v[1] * kScale}; }
b2AABB to_box2d(const Box<2>& box) {
  b2AABB aabb;
  aabb.lowerBound = to_box2d(box.min);
  aabb.upperBound = to_box2d(box.max);
  return aabb;
}

/// Calls `take(object, box)` with each proxy that the tree finds.
template <class Take>
struct Callback {
  const b2DynamicTree& tree;
  const std::vector<Box<2>>& boxes;
  Take take;

  bool QueryCallback(int32 proxy) {  // NOLINT(readability-identifier-naming): Box2D's name
    const ObjectId object = object_of(proxy);
    take(object, boxes[object.index()]);
    return true;
  }
  float RayCastCallback(const b2RayCastInput& input, int32 proxy) {  // NOLINT(readability-identifier-naming)
    const ObjectId object = object_of(proxy);
    return take(object, boxes[object.index()], input.maxFraction);
  }
  [[nodiscard]] ObjectId object_of(int32 proxy) const {
    return {static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(tree.GetUserData(proxy)))};
  }
};

class Box2dQueries final : public QueryRival<2> {
 public:
  [[nodiscard]] std::string_view name() const override { return "box2d"; }
  void build(std::span<const Box<2>> boxes) override {
    tree_ = std::make_unique<b2DynamicTree>();
    boxes_.assign(boxes.begin(), boxes.end());
    proxies_.clear();
    for (std::uintptr_t k = 0; k < boxes.size(); ++k)
      proxies_.push_back(tree_->CreateProxy(to_box2d(boxes[k]), reinterpret_cast<void*>(k)));
  }
  void move(std::span<const Box<2>> boxes) override {
    for (std::size_t k = 0; k < boxes.size(); ++k)
      if (!(boxes[k] == boxes_[k])) tree_->MoveProxy(proxies_[k], to_box2d(boxes[k]), b2Vec2_zero);
    boxes_.assign(boxes.begin(), boxes.end());
  }
  bool overlaps(const Box<2>& box, std::vector<ObjectId>& found) override {
    query(box, [&](ObjectId object, const Box<2>& other) {
      if (kerf::overlaps(box, other)) found.push_back(object);
    });
    return true;
  }
  bool overlaps(const Sphere<2>& sphere, std::vector<ObjectId>& found) override {
    const Vector<2> reach{{sphere.radius, sphere.radius}};
    query({sphere.center - reach, sphere.center + reach}, [&](ObjectId object, const Box<2>& box) {
      if (quick_distance(sphere.center, box) <= sphere.radius * sphere.radius) found.push_back(object);
    });
    return true;
  }
  bool hits(const Ray<2>& ray, std::vector<Hit>& found) override {
    const QuickRay<2> quick(ray);
    cast(ray, [&](ObjectId object, const Box<2>& box, float) {
      if (const auto t = quick.enter(box)) found.push_back({object, *t});
      return -1.0F;  // goes on with the whole ray
    });
    return true;
  }
  bool first_hit(const Ray<2>& ray, Hit& first) override {
    first = {ObjectId::none(), std::numeric_limits<Scalar>::infinity()};
    const QuickRay<2> quick(ray);
    cast(ray, [&](ObjectId object, const Box<2>& box, float) {
      const auto t = quick.enter(box);
      if (!t || !(Hit{object, *t} < first)) return -1.0F;
      first = {object, *t};
      return *t > 0 ? *t : -1.0F;  // 0 would end it
    });
    return true;
  }

 private:
  template <class Take>
  void query(const Box<2>& box, Take take) {
    Callback<Take> callback{*tree_, boxes_, take};
    tree_->Query(&callback, to_box2d(box));
  }
  template <class Take>
  void cast(const Ray<2>& ray, Take take) {
    Callback<Take> callback{*tree_, boxes_, take};
    const b2Vec2 from = to_box2d(ray.origin);
    tree_->RayCast(&callback, {from, from + to_box2d(ray.direction), ray.max_t});
  }

  std::unique_ptr<b2DynamicTree> tree_;
  std::vector<Box<2>> boxes_;
  std::vector<int32> proxies_;
};

}  // namespace

std::unique_ptr<QueryRival<2>> make_box2d_queries() { return std::make_unique<Box2dQueries>(); }

}  // namespace kerf
