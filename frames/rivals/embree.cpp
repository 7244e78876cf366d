#if KERF_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <stdexcept>
#include <string>

#include "frames/rivals/makers.h"
#include "frames/rivals/rival_base.h"

namespace kerf {
namespace {

void check(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error != RTC_ERROR_NONE) throw std::runtime_error("Embree error " + std::to_string(error));
}

RTCBounds to_embree(const Box<3>& box) {
  RTCBounds bounds{};
  bounds.lower_x = box.min[0];
  bounds.lower_y = box.min[1];
  bounds.lower_z = box.min[2];
  bounds.upper_x = box.max[0];
  bounds.upper_y = box.max[1];
  bounds.upper_z = box.max[2];
  return bounds;
}

/// A scene of boxes. Primitive k of its one geometry is object k of the list.
class EmbreeScene {
 public:
  explicit EmbreeScene(RTCDevice device)
      : device_(device),
        scene_(rtcNewScene(device)),
        geometry_(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER)) {
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_LOW);
    rtcSetGeometryBuildQuality(geometry_, RTC_BUILD_QUALITY_LOW);
    rtcSetGeometryUserData(geometry_, this);
    rtcSetGeometryBoundsFunction(
        geometry_,
        [](const RTCBoundsFunctionArguments* given) {
          const auto& self = *static_cast<const EmbreeScene*>(given->geometryUserPtr);
          *given->bounds_o = to_embree(self.boxes_[given->primID]);
        },
        nullptr);
    rtcAttachGeometry(scene_, geometry_);
    rtcReleaseGeometry(geometry_);
    check(device_);
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene() { rtcReleaseScene(scene_); }

  std::size_t add(ObjectId object, const Box<3>& box) {
    objects_.push_back(object);
    boxes_.push_back(box);
    changed_ = true;
    return objects_.size() - 1;
  }
  void change(std::size_t place, const Box<3>& box) {
    boxes_[place] = box;
    changed_ = true;
  }
  /// Removes the object at a place; the last object takes the place and is returned.
  ObjectId drop(std::size_t place) {
    objects_[place] = objects_.back();
    boxes_[place] = boxes_.back();
    objects_.pop_back();
    boxes_.pop_back();
    changed_ = true;
    return place < objects_.size() ? objects_[place] : ObjectId::none();
  }
  void commit() {
    if (!changed_) return;
    rtcSetGeometryUserPrimitiveCount(geometry_, static_cast<unsigned>(objects_.size()));
    rtcCommitGeometry(geometry_);
    rtcCommitScene(scene_);
    check(device_);
    changed_ = false;
  }
  [[nodiscard]] bool empty() const { return objects_.empty(); }
  [[nodiscard]] ObjectId object(unsigned primitive) const { return objects_[primitive]; }
  [[nodiscard]] RTCScene get() const { return scene_; }

 private:
  RTCDevice device_;
  RTCScene scene_;
  RTCGeometry geometry_;  ///< the scene owns it
  std::vector<ObjectId> objects_;
  std::vector<Box<3>> boxes_;
  bool changed_ = true;
};

class EmbreeRival final : public RivalBase<3> {
 public:
  EmbreeRival(const RivalHints<3>& hints, Intake intake) : RivalBase<3>(hints, intake) {
    check(device_.get());
  }
  [[nodiscard]] std::string_view name() const override { return "embree-collide"; }

 private:
  struct Device {
    Device() : device(rtcNewDevice("threads=1")) {}
    ~Device() { rtcReleaseDevice(device); }
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    [[nodiscard]] RTCDevice get() const { return device; }
    RTCDevice device;
  };

  EmbreeScene& scene_of(ObjectId object) { return is_fixed(object) ? fixed_ : moving_; }
  void add(ObjectId object, const Box<3>& box, bool /*fixed*/) override {
    if (place_.size() <= object.index()) place_.resize(object.index() + 1);
    place_[object.index()] = scene_of(object).add(object, box);
  }
  void change(ObjectId object, const Box<3>& box) override {
    scene_of(object).change(place_[object.index()], box);
  }
  void drop(ObjectId object) override {
    const std::size_t place = place_[object.index()];
    const ObjectId moved = scene_of(object).drop(place);
    if (!moved.is_none()) place_[moved.index()] = place;
  }
  void tell_structure(StructureParts<3>& parts) const override {
    parts.unseen = "Embree keeps its tree to itself";
  }
  void find_pairs() override {
    moving_.commit();
    fixed_.commit();
    if (moving_.empty()) return;
    // A scene against itself reports each pair in both orders, and each object with itself.
    rtcCollide(
        moving_.get(), moving_.get(),
        [](void* self, RTCCollision* found, unsigned count) {
          auto& rival = *static_cast<EmbreeRival*>(self);
          for (unsigned i = 0; i < count; ++i)
            if (found[i].primID0 < found[i].primID1)
              rival.report(rival.moving_.object(found[i].primID0), rival.moving_.object(found[i].primID1));
        },
        this);
    if (fixed_.empty()) return;
    rtcCollide(
        moving_.get(), fixed_.get(),
        [](void* self, RTCCollision* found, unsigned count) {
          auto& rival = *static_cast<EmbreeRival*>(self);
          for (unsigned i = 0; i < count; ++i)
            rival.report(rival.moving_.object(found[i].primID0), rival.fixed_.object(found[i].primID1));
        },
        this);
    check(device_.get());
  }

  Device device_;  // first: the scenes end before it does
  EmbreeScene moving_{device_.get()};
  EmbreeScene fixed_{device_.get()};
  std::vector<std::size_t> place_;
};

}  // namespace

std::unique_ptr<BroadPhase<3>> make_embree(const RivalHints<3>& hints, Intake intake) {
  return std::make_unique<EmbreeRival>(hints, intake);
}

}  // namespace kerf
