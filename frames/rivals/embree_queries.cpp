#if KERF_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <cmath>
#include <stdexcept>
#include <string>

#include "frames/rivals/makers.h"
#include "frames/rivals/query_tests.h"

namespace kerf {
namespace {

#if KERF_EMBREE >= 4
using RayContext = RTCRayQueryContext;

void begin(RayContext& context) { rtcInitRayQueryContext(&context); }

void intersect(RTCScene scene, RayContext& context, RTCRayHit& hit) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  rtcIntersect1(scene, &hit, &arguments);
}
#else
using RayContext = RTCIntersectContext;

void begin(RayContext& context) { rtcInitIntersectContext(&context); }

void intersect(RTCScene scene, RayContext& context, RTCRayHit& hit) { rtcIntersect1(scene, &context, &hit); }
#endif

/// Boxes as a geometry of Embree's kind "user". Its hierarchy has the default quality.
class EmbreeQueries final : public QueryRival<3> {
 public:
  EmbreeQueries() : device_(rtcNewDevice("threads=1")) {}
  ~EmbreeQueries() override {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  [[nodiscard]] std::string_view name() const override { return "embree"; }
  void build(std::span<const Box<3>> boxes) override {
    rtcReleaseScene(scene_);
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    geometry_ = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryBuildQuality(geometry_, RTC_BUILD_QUALITY_MEDIUM);
    rtcSetGeometryUserData(geometry_, this);
    rtcSetGeometryUserPrimitiveCount(geometry_, static_cast<unsigned>(boxes.size()));
    rtcSetGeometryBoundsFunction(
        geometry_,
        [](const RTCBoundsFunctionArguments* given) {
          const Box<3>& box =
              static_cast<const EmbreeQueries*>(given->geometryUserPtr)->boxes_[given->primID];
          *given->bounds_o = {box.min[0], box.min[1], box.min[2], 0, box.max[0], box.max[1], box.max[2], 0};
        },
        nullptr);
    rtcSetGeometryIntersectFunction(geometry_, enter);
    rtcAttachGeometry(scene_, geometry_);
    rtcReleaseGeometry(geometry_);
    move(boxes);
  }
  void move(std::span<const Box<3>> boxes) override {
    boxes_.assign(boxes.begin(), boxes.end());
    rtcCommitGeometry(geometry_);
    rtcCommitScene(scene_);
    const RTCError error = rtcGetDeviceError(device_);
    if (error != RTC_ERROR_NONE) throw std::runtime_error("Embree error " + std::to_string(error));
  }
  /// Points only: Embree knows balls, but no boxes.
  bool overlaps(const Box<3>& box, std::vector<ObjectId>& found) override {
    if (!(box.min == box.max)) return false;
    query(box.min, 0, [&](ObjectId object, const Box<3>& other, float&) {
      if (kerf::overlaps(box, other)) found.push_back(object);
      return false;
    });
    return true;
  }
  bool overlaps(const Sphere<3>& sphere, std::vector<ObjectId>& found) override {
    query(sphere.center, sphere.radius, [&](ObjectId object, const Box<3>& box, float&) {
      if (quick_distance(sphere.center, box) <= sphere.radius * sphere.radius) found.push_back(object);
      return false;
    });
    return true;
  }
  bool hits(const Ray<3>& ray, std::vector<Hit>& found) override {
    cast(ray, &found);
    return true;
  }
  bool first_hit(const Ray<3>& ray, Hit& first) override {
    first = cast(ray, nullptr);
    return true;
  }
  bool nearest(const Nearest<3>& nearest, std::vector<Neighbour>& found) override {
    QuickNearest best(nearest.count, found);
    query(nearest.point, INFINITY, [&](ObjectId object, const Box<3>& box, float& radius) {
      best.take(object, static_cast<double>(quick_distance(nearest.point, box)));
      if (!best.is_full()) return false;
      radius = std::sqrt(static_cast<float>(best.squared_distance())) * (1 + 1e-6F);
      return true;
    });
    return true;
  }

 private:
  struct Context : RayContext {
    const QuickRay<3>* ray = nullptr;
    std::vector<Hit>* all = nullptr;  ///< none: the first is wanted
  };
  static void enter(const RTCIntersectFunctionNArguments* given) {
    const auto& context = *static_cast<const Context*>(given->context);
    auto& hit = *reinterpret_cast<RTCRayHit*>(given->rayhit);
    const Box<3>& box = static_cast<const EmbreeQueries*>(given->geometryUserPtr)->boxes_[given->primID];
    const auto t = context.ray->enter(box);
    if (!t) return;
    if (context.all != nullptr) {
      context.all->push_back({{given->primID}, *t});
      return;
    }
    const bool is_first = *t < hit.ray.tfar || (*t == hit.ray.tfar && given->primID < hit.hit.primID);
    if (!is_first) return;
    hit.ray.tfar = *t;
    hit.hit.primID = given->primID;
    hit.hit.geomID = given->geomID;
  }
  Hit cast(const Ray<3>& ray, std::vector<Hit>* all) {
    const QuickRay<3> quick(ray);
    Context context;
    begin(context);
    context.ray = &quick;
    context.all = all;
    RTCRayHit hit{};
    hit.ray = {ray.origin[0],
               ray.origin[1],
               ray.origin[2],
               0,
               ray.direction[0],
               ray.direction[1],
               ray.direction[2],
               0,
               ray.max_t,
               ~0U,
               0,
               0};
    hit.hit.geomID = hit.hit.primID = RTC_INVALID_GEOMETRY_ID;
    intersect(scene_, context, hit);
    if (hit.hit.primID == RTC_INVALID_GEOMETRY_ID) return {ObjectId::none(), INFINITY};
    return {{hit.hit.primID}, hit.ray.tfar};
  }
  template <class Take>
  void query(const Vector<3>& point, float radius, Take take) {
    struct Asked {
      Take& take;
      const std::vector<Box<3>>& boxes;
    } asked{take, boxes_};
    RTCPointQuery ball{point[0], point[1], point[2], 0, radius};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(
        scene_, &ball, &context,
        [](RTCPointQueryFunctionArguments* given) {
          auto& a = *static_cast<Asked*>(given->userPtr);
          return a.take({given->primID}, a.boxes[given->primID], given->query->radius);
        },
        &asked);
  }

  RTCDevice device_;
  RTCScene scene_ = nullptr;
  RTCGeometry geometry_ = nullptr;  ///< the scene owns it
  std::vector<Box<3>> boxes_;
};

}  // namespace

std::unique_ptr<QueryRival<3>> make_embree_queries() { return std::make_unique<EmbreeQueries>(); }

}  // namespace kerf
