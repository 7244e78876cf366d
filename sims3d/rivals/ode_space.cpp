#include "sims3d/rivals/ode_space.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "sims3d/rivals/ode_candidates.h"

namespace kerf {
namespace {

/// ODE takes a geom without extent for none at all and reports no pair of it. This extent is lost in the
/// rounding of any coordinate but 0, and nearer to 0 than any other float.
constexpr dReal kThinnest = 4 * std::numeric_limits<dReal>::min();

constexpr unsigned long kFixed = 1;
constexpr unsigned long kMoving = 2;
constexpr unsigned long kMarkerBits = 4;
/// The data of the geoms that are no objects.
constexpr std::uintptr_t kMarker = ~std::uintptr_t{0};

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double>(end - begin).count();
}

/// The same box with Y and Z exchanged.
Box<3> with_exchanged_axes(const Box<3>& box) {
  return {{{box.min[0], box.min[2], box.min[1]}}, {{box.max[0], box.max[2], box.max[1]}}};
}

ObjectId object_of(dGeomID geom) {
  return {static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(dGeomGetData(geom)))};
}

void keep_pair(void* pairs, dGeomID a, dGeomID b) {
  static_cast<std::vector<Pair>*>(pairs)->push_back(make_pair(object_of(a), object_of(b)));
}

/// The pairs of a search, and when it began and ended.
struct TimedSearch {
  std::vector<Pair>* pairs;
  Clock::time_point begin{};
  Clock::time_point end{};
};

void keep_pair_or_time(void* data, dGeomID a, dGeomID b) {
  TimedSearch& search = *static_cast<TimedSearch*>(data);
  if (reinterpret_cast<std::uintptr_t>(dGeomGetData(a)) != kMarker) {
    keep_pair(search.pairs, a, b);
  } else if (search.begin == Clock::time_point{}) {
    search.begin = Clock::now();
  } else {
    search.end = Clock::now();
  }
}

}  // namespace

OdeSpace::OdeSpace(OdeSpaceKind kind, const Box<3>& bounds, OdeIntake intake, OdePlane plane)
    : kind_(kind),
      intake_(intake),
      exchanges_axes_(kind == OdeSpaceKind::quadtree && plane == OdePlane::xz),
      bounds_(exchanges_axes_ ? with_exchanged_axes(bounds) : bounds) {
  const auto lock = library_.enter();
  space_ = make_space();
  constexpr dReal kFarAway = 1e30;
  stranger_.reset(dCreateSphere(nullptr, 1));
  dGeomSetPosition(stranger_.get(), kFarAway, kFarAway, kFarAway);
}

/// An empty one.
dSpaceID OdeSpace::make_space() const {
  dSpaceID space = nullptr;
  if (kind_ == OdeSpaceKind::hash) space = dHashSpaceCreate(nullptr);
  if (kind_ == OdeSpaceKind::sweep_and_prune) space = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XZY);
  if (kind_ == OdeSpaceKind::quadtree) {
    const Vector<3> center = bounds_.center();
    const Vector<3> half = bounds_.extent() * 0.5F;
    const dVector3 c{center[0], center[1], center[2]};
    const dVector3 h{half[0], half[1], half[2]};
    constexpr int kDepth = 7;  // 4^7 leaves; level 11, as in the paper, takes 400 MB
    space = dQuadTreeSpaceCreate(nullptr, c, h, kDepth);
  }
  if (space == nullptr) throw std::runtime_error("ODE cannot make its space");
  dSpaceSetCleanup(space, 0);
  return space;
}

OdeSpace::~OdeSpace() {
  const auto lock = library_.enter();
  geoms_.clear();
  markers_.clear();
  stranger_.reset();
  dSpaceDestroy(space_);
}

std::string_view OdeSpace::name() const {
  constexpr std::array<std::string_view, 3> kNames{"ode-hash", "ode-quadtree", "ode-sap"};
  return kNames[static_cast<std::size_t>(kind_)];
}

/// Updates the geom of an object to the last box given for it.
void OdeSpace::place(ObjectId object, const Box<3>& given) {
  const auto lock = library_.enter();
  if (geoms_.size() <= object.index()) geoms_.resize(object.index() + 1);
  OdeHandle<dxGeom>& geom = geoms_[object.index()];
  const bool raw = intake_ == OdeIntake::raw;
  if (!raw && !objects_.is_placed(object)) {
    geom.reset();
    return;
  }
  const Box<3>& latest = raw ? given : objects_.box(object);
  const Box<3> box = exchanges_axes_ ? with_exchanged_axes(latest) : latest;
  std::array<dReal, 3> center;
  std::array<dReal, 3> size;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    center[k] = (static_cast<dReal>(box.min[i]) + static_cast<dReal>(box.max[i])) / 2;
    size[k] = static_cast<dReal>(box.max[i]) - static_cast<dReal>(box.min[i]);
    if (!raw) size[k] = std::max(size[k], kThinnest);
  }
  if (!geom) {
    geom.reset(dCreateBox(space_, size[0], size[1], size[2]));
    dGeomSetData(geom.get(), reinterpret_cast<void*>(std::uintptr_t{object.value}));
    const bool fixed = objects_.is_fixed(object);
    dGeomSetCategoryBits(geom.get(), fixed ? kFixed : kMoving);
    dGeomSetCollideBits(geom.get(), fixed ? kMoving : kMoving | kFixed);
  } else {
    dGeomBoxSetLengths(geom.get(), size[0], size[1], size[2]);
  }
  dGeomSetPosition(geom.get(), center[0], center[1], center[2]);
}

Status OdeSpace::insert(ObjectId object, const Box<3>& box, Mobility mobility) {
  const Status status = objects_.insert(object, box, mobility);
  if (!is_refused(status)) place(object, box);
  return status;
}

Status OdeSpace::move(ObjectId object, const Box<3>& box) {
  const Status status = objects_.move(object, box);
  if (status != Status::unknown_id) place(object, box);
  return status;
}

Status OdeSpace::remove(ObjectId object) {
  const Status status = objects_.remove(object);
  if (status == Status::ok) {
    const auto lock = library_.enter();
    if (object.index() < geoms_.size()) geoms_[object.index()].reset();
  }
  return status;
}

/// A query for a geom far away makes the quadtree place the objects that moved.
void OdeSpace::arrange() {
  if (kind_ != OdeSpaceKind::quadtree) return;
  const auto start = Clock::now();
  dSpaceCollide2(reinterpret_cast<dGeomID>(space_), stranger_.get(), &pairs_, keep_pair);
  arrange_seconds_ = seconds_between(start, Clock::now());
}

void OdeSpace::separate_times() {
  constexpr double kFreePlace = 1e7 + 0.0625;  // in a cell of the finest level
  const auto lock = library_.enter();
  if (kind_ != OdeSpaceKind::hash || !markers_.empty()) return;
  for (const double size : {4096.0, 0.03125})  // larger than any cell; smaller than all
    for (int k = 0; k < 2; ++k) add_marker(kFreePlace, size);
}

void OdeSpace::add_marker(double x, double size) {
  const dGeomID marker = markers_.emplace_back(dCreateBox(space_, size, size, size)).get();
  dGeomSetData(marker, reinterpret_cast<void*>(kMarker));
  dGeomSetCategoryBits(marker, kMarkerBits);
  dGeomSetCollideBits(marker, kMarkerBits);
  dGeomSetPosition(marker, x, 0.0625, 0.0625);
}

/// ODE puts what moved last in front of its list, and compares in the order of the list.
void OdeSpace::search() {
  for (const OdeHandle<dxGeom>& marker : markers_) {
    const dReal* at = dGeomGetPosition(marker.get());
    dGeomSetPosition(marker.get(), at[0], at[1], at[2]);
  }
  TimedSearch search{&pairs_};
  const auto start = Clock::now();
  dSpaceCollide(space_, &search, keep_pair_or_time);
  arrange_seconds_ = seconds_between(start, search.begin) + seconds_between(search.end, Clock::now());
}

void OdeSpace::step() {
  const auto lock = library_.enter();
  arrange();
  pairs_.clear();
  if (markers_.empty()) {
    dSpaceCollide(space_, &pairs_, keep_pair);
  } else {
    search();
  }
}

double OdeSpace::count_candidates() const {
  const auto lock = library_.enter();
  std::vector<OdeBox> boxes;
  for (const OdeHandle<dxGeom>& geom : geoms_) {
    if (!geom) continue;
    OdeBox& box = boxes.emplace_back();
    dGeomGetAABB(geom.get(), box.bounds.data());
    box.fixed = dGeomGetCategoryBits(geom.get()) == kFixed;
  }
  const std::unique_ptr<dxSpace, void (*)(dSpaceID)> space(make_space(), dSpaceDestroy);
  if (kind_ == OdeSpaceKind::hash) return count_hash_candidates(space.get(), boxes);
  if (kind_ == OdeSpaceKind::quadtree) return count_quadtree_candidates(space.get(), boxes);
  return count_sweep_candidates(space.get(), boxes);
}

void OdeSpace::describe(StructureParts<3>& parts) const {
  parts.unseen = "ODE keeps the structure of its spaces to itself";
  const double candidates = count_candidates();
  if (candidates >= 0) parts.tests = static_cast<std::uint64_t>(candidates);
}

}  // namespace kerf
