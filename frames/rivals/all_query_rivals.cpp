// The libraries that answer queries (KERF_RIVALS); without them no_rivals.cpp stands in their place.

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "frames/rivals/flat.h"
#include "frames/rivals/makers.h"
#include "frames/rivals/query_rival.h"

namespace kerf {
namespace {

/// A 3D library that gets 2D boxes as slabs of unit thickness, and queries in the middle of them.
class FlatQueries final : public QueryRival<2> {
 public:
  explicit FlatQueries(std::unique_ptr<QueryRival<3>> inner) : inner_(std::move(inner)) {}
  [[nodiscard]] std::string_view name() const override { return inner_->name(); }
  void build(std::span<const Box<2>> boxes) override { inner_->build(flatten(boxes)); }
  void move(std::span<const Box<2>> boxes) override { inner_->move(flatten(boxes)); }
  bool overlaps(const Box<2>& box, std::vector<ObjectId>& found) override {
    return inner_->overlaps(in_middle(box), found);
  }
  bool overlaps(const Sphere<2>& sphere, std::vector<ObjectId>& found) override {
    return inner_->overlaps(Sphere<3>{in_middle(sphere.center), sphere.radius}, found);
  }
  bool overlaps(const Frustum<2>& frustum, std::vector<ObjectId>& found) override {
    planes_.clear();
    for (const Plane<2>& p : frustum.planes) planes_.push_back({{{p.normal[0], p.normal[1], 0}}, p.offset});
    return inner_->overlaps(Frustum<3>{planes_}, found);
  }
  bool hits(const Ray<2>& ray, std::vector<Hit>& found) override {
    return inner_->hits(in_middle(ray), found);
  }
  bool first_hit(const Ray<2>& ray, Hit& first) override { return inner_->first_hit(in_middle(ray), first); }
  bool hits(const SweptBox<2>& swept, std::vector<Hit>& found) override {
    const Vector<2>& by = swept.displacement;
    return inner_->hits(SweptBox<3>{in_middle(swept.box), {{by[0], by[1], 0}}, swept.max_t}, found);
  }
  bool nearest(const Nearest<2>& nearest, std::vector<Neighbour>& found) override {
    return inner_->nearest({in_middle(nearest.point), nearest.count, nearest.max_distance}, found);
  }

 private:
  static Vector<3> in_middle(const Vector<2>& v) { return {{v[0], v[1], 0.5F}}; }
  static Box<3> in_middle(const Box<2>& box) { return {in_middle(box.min), in_middle(box.max)}; }
  static Ray<3> in_middle(const Ray<2>& ray) {
    return {in_middle(ray.origin), {{ray.direction[0], ray.direction[1], 0}}, ray.max_t};
  }
  std::span<const Box<3>> flatten(std::span<const Box<2>> boxes) {
    flat_.resize(boxes.size());
    std::ranges::transform(boxes, flat_.begin(), flat_box);
    return flat_;
  }

  std::unique_ptr<QueryRival<3>> inner_;
  std::vector<Box<3>> flat_;
  std::vector<Plane<3>> planes_;
};

}  // namespace

template <>
std::vector<std::unique_ptr<QueryRival<3>>> query_rivals<3>() {
  std::vector<std::unique_ptr<QueryRival<3>>> all;
  all.push_back(make_bullet_queries());
  all.push_back(make_fcl_queries());
  all.push_back(make_embree_queries());
  return all;
}

template <>
std::vector<std::unique_ptr<QueryRival<2>>> query_rivals<2>() {
  std::vector<std::unique_ptr<QueryRival<2>>> all;
  all.push_back(make_box2d_queries());
  all.push_back(std::make_unique<FlatQueries>(make_bullet_queries()));
  all.push_back(std::make_unique<FlatQueries>(make_fcl_queries()));
  all.push_back(std::make_unique<FlatQueries>(make_embree_queries()));
  return all;
}

}  // namespace kerf
