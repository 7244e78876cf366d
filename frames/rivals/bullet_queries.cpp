#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <array>

#include "frames/rivals/makers.h"
#include "frames/rivals/query_tests.h"

namespace kerf {
namespace {

btVector3 to_bullet(const Vector<3>& v) { return {v[0], v[1], v[2]}; }
btDbvtVolume to_volume(const Box<3>& box) {
  return btDbvtVolume::FromMM(to_bullet(box.min), to_bullet(box.max));
}
ObjectId object_of(const btDbvtNode& leaf) { return {static_cast<std::uint32_t>(leaf.dataAsInt)}; }
Box<3> box_of(const btDbvtNode& leaf) {
  const btVector3& low = leaf.volume.Mins();
  const btVector3& high = leaf.volume.Maxs();
  return {{{low.x(), low.y(), low.z()}}, {{high.x(), high.y(), high.z()}}};
}

/// Calls `take` with each leaf.
template <class Take>
struct Policy final : btDbvt::ICollide {
  explicit Policy(Take given) : take(given) {}
  using btDbvt::ICollide::Process;
  void Process(const btDbvtNode* leaf) { take(*leaf); }  // NOLINT: Bullet's name; hides what is not virtual
  Take take;
};

class BulletQueries final : public QueryRival<3> {
 public:
  [[nodiscard]] std::string_view name() const override { return "bullet"; }
  void build(std::span<const Box<3>> boxes) override {
    tree_.clear();
    leaves_.clear();
    for (const Box<3>& box : boxes) {
      btDbvtNode* const leaf = tree_.insert(to_volume(box), nullptr);
      leaf->dataAsInt = static_cast<int>(leaves_.size());
      leaves_.push_back(leaf);
    }
    tree_.optimizeTopDown();
  }
  void move(std::span<const Box<3>> boxes) override {
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      btDbvtVolume volume = to_volume(boxes[k]);
      tree_.update(leaves_[k], volume);
    }
  }
  bool overlaps(const Box<3>& box, std::vector<ObjectId>& found) override {
    Policy policy([&](const btDbvtNode& leaf) { found.push_back(object_of(leaf)); });
    tree_.collideTV(tree_.m_root, to_volume(box), policy);
    return true;
  }
  bool overlaps(const Sphere<3>& sphere, std::vector<ObjectId>& found) override {
    const Vector<3> reach{{sphere.radius, sphere.radius, sphere.radius}};
    Policy policy([&](const btDbvtNode& leaf) {
      if (quick_distance(sphere.center, box_of(leaf)) <= sphere.radius * sphere.radius)
        found.push_back(object_of(leaf));
    });
    tree_.collideTV(tree_.m_root, to_volume({sphere.center - reach, sphere.center + reach}), policy);
    return true;
  }
  bool overlaps(const Frustum<3>& frustum, std::vector<ObjectId>& found) override {
    std::array<btVector3, 8> normals;
    std::array<btScalar, 8> offsets{};
    for (std::size_t k = 0; k < frustum.planes.size(); ++k) {
      normals[k] = -to_bullet(frustum.planes[k].normal);
      offsets[k] = frustum.planes[k].offset;
    }
    Policy policy([&](const btDbvtNode& leaf) { found.push_back(object_of(leaf)); });
    btDbvt::collideKDOP(tree_.m_root, normals.data(), offsets.data(), static_cast<int>(frustum.planes.size()),
                        policy);
    return true;
  }
  bool hits(const Ray<3>& ray, std::vector<Hit>& found) override {
    const QuickRay<3> quick(ray);
    cast(ray.origin, ray.direction, ray.max_t, {}, [&](const btDbvtNode& leaf) {
      if (const auto t = quick.enter(box_of(leaf))) found.push_back({object_of(leaf), *t});
    });
    return true;
  }
  bool first_hit(const Ray<3>& ray, Hit& first) override {
    first = {ObjectId::none(), std::numeric_limits<Scalar>::infinity()};
    const QuickRay<3> quick(ray);
    cast(ray.origin, ray.direction, ray.max_t, {}, [&](const btDbvtNode& leaf) {
      const auto t = quick.enter(box_of(leaf));
      if (t && Hit{object_of(leaf), *t} < first) first = {object_of(leaf), *t};
    });
    return true;
  }
  bool hits(const SweptBox<3>& swept, std::vector<Hit>& found) override {
    const QuickRay<3> quick(swept);
    cast({}, swept.displacement, swept.max_t, swept.box, [&](const btDbvtNode& leaf) {
      if (const auto t = quick.enter(box_of(leaf))) found.push_back({object_of(leaf), *t});
    });
    return true;
  }

 private:
  template <class Take>
  void cast(const Vector<3>& origin, const Vector<3>& direction, Scalar length, const Box<3>& shape,
            Take take) {
    btVector3 inverse;
    std::array<unsigned, 3> signs{};
    for (int i = 0; i < 3; ++i) {
      inverse[i] = direction[i] == 0 ? btScalar(BT_LARGE_FLOAT) : 1 / direction[i];
      signs[static_cast<std::size_t>(i)] = inverse[i] < 0 ? 1 : 0;
    }
    Policy policy(take);
    tree_.rayTestInternal(tree_.m_root, to_bullet(origin), to_bullet(origin + direction * length), inverse,
                          signs.data(), length, to_bullet(shape.min), to_bullet(shape.max), stack_, policy);
  }

  btDbvt tree_;
  std::vector<btDbvtNode*> leaves_;
  btAlignedObjectArray<const btDbvtNode*> stack_;
};

}  // namespace

std::unique_ptr<QueryRival<3>> make_bullet_queries() { return std::make_unique<BulletQueries>(); }

}  // namespace kerf
