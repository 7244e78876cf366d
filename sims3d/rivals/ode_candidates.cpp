#include "sims3d/rivals/ode_candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace kerf {
namespace {

constexpr dReal kNan = std::numeric_limits<dReal>::quiet_NaN();
constexpr dReal kInfinity = std::numeric_limits<dReal>::infinity();

constexpr unsigned long kFixedGeom = 1;
constexpr unsigned long kMovingGeom = 2;
constexpr unsigned long kMarkerGeom = 4;

using Bounds = std::array<dReal, 6>;

/// Geoms whose boxes can be changed behind the back of their space.
class OpenGeoms {
 public:
  explicit OpenGeoms(dSpaceID space) : space_(space) {}

  void add(const Bounds& bounds, unsigned long category, unsigned long collides) {
    OdeHandle<dxGeom>& geom = geoms_.emplace_back(library_.make_open_geom(bounds.data()));
    dGeomSetData(geom.get(), reinterpret_cast<void*>(geoms_.size() - 1));
    dGeomSetCategoryBits(geom.get(), category);
    dGeomSetCollideBits(geom.get(), collides);
    dSpaceAdd(space_, geom.get());
  }
  void add(const OdeBox& box) {
    add(box.bounds, box.fixed ? kFixedGeom : kMovingGeom, box.fixed ? kMovingGeom : kMovingGeom | kFixedGeom);
  }

  [[nodiscard]] std::size_t size() const { return geoms_.size(); }
  [[nodiscard]] dGeomID geom(std::size_t k) const { return geoms_[k].get(); }
  /// Has an effect once the space has computed the box.
  void change(std::size_t k, const Bounds& bounds) {
    std::ranges::copy(bounds, OdeLibrary::bounds_of(geoms_[k].get()));
  }
  void change_all(dReal value) {
    Bounds bounds;
    bounds.fill(value);
    for (std::size_t k = 0; k < size(); ++k) change(k, bounds);
  }
  static std::size_t index_of(dGeomID geom) { return reinterpret_cast<std::size_t>(dGeomGetData(geom)); }

 private:
  OdeLibrary library_;  // first: the geoms end before it does
  dSpaceID space_;
  std::vector<OdeHandle<dxGeom>> geoms_;
};

/// What a callback counts.
struct Count {
  OpenGeoms* geoms;
  double calls = 0;
  bool begun = false;
};

/// The first pair are the markers: from then on every box is NaN.
void count_behind_markers(void* data, dGeomID /*a*/, dGeomID /*b*/) {
  Count& count = *static_cast<Count*>(data);
  if (count.begun) {
    ++count.calls;
  } else {
    count.geoms->change_all(kNan);
    count.begun = true;
  }
}

/// A box of the finest level to the right of all that the hash table has; NaN beyond what its whole numbers
/// hold.
Bounds marker_beside(std::span<const OdeBox> boxes) {
  constexpr dReal kFarthest = 1e8;
  constexpr dReal kLargestCell = 1024;  // 2^10, ODE's default; larger boxes are in no cell
  constexpr dReal kGap = 16;
  dReal right = 0;
  for (const OdeBox& box : boxes) {
    bool hashed = true;
    for (std::size_t axis = 0; axis < 6; axis += 2)
      hashed &= box.bounds[axis + 1] - box.bounds[axis] <= kLargestCell;
    if (hashed) right = std::max(right, box.bounds[1]);
  }
  if (right > kFarthest) return {kNan};
  const dReal at = std::ceil(right) + kGap;
  return {at + 0.03125, at + 0.0625, 0.03125, 0.0625, 0.03125, 0.0625};
}

void list_firsts(void* data, dGeomID a, dGeomID /*b*/) {
  auto& firsts = *static_cast<std::vector<std::size_t>*>(data);
  const std::size_t index = OpenGeoms::index_of(a);
  if (firsts.empty() || firsts.back() != index) firsts.push_back(index);
}

void count_others(void* data, dGeomID a, dGeomID b) {
  if (a != b) ++static_cast<Count*>(data)->calls;
}

}  // namespace

/// ODE goes through its list from the geom that was added last, and through the cells from the finest level:
/// the markers, alone in a cell of theirs, are compared before any others.
double count_hash_candidates(dSpaceID space, std::span<const OdeBox> boxes) {
  OpenGeoms geoms(space);
  for (const OdeBox& box : boxes) geoms.add(box);
  const Bounds marker = marker_beside(boxes);
  if (std::isnan(marker[0])) return -1;
  for (int k = 0; k < 2; ++k) geoms.add(marker, kMarkerGeom, kMarkerGeom);
  Count count{&geoms};
  dSpaceCollide(space, &count, count_behind_markers);
  return count.begun ? count.calls : -1;
}

/// A block's geom is compared with those behind it in the block's list and with those of the blocks below
/// that its own box reaches. A query for a geom of the space does the same, but looks at the whole list of
/// the block and at all blocks above. So each geom is asked about in the order in which ODE goes down the
/// tree; those that were have an empty box, apart from everything, and the others one of NaN.
double count_quadtree_candidates(dSpaceID space, std::span<const OdeBox> boxes) {
  OpenGeoms geoms(space);
  for (const OdeBox& box : boxes) geoms.add(box);
  const OdeHandle<dxGeom> stranger(dCreateSphere(nullptr, 1));
  dGeomSetPosition(stranger.get(), 1e30, 1e30, 1e30);
  Count count{&geoms};
  dSpaceCollide2(reinterpret_cast<dGeomID>(space), stranger.get(), &count, count_others);  // places them
  geoms.change_all(kNan);
  std::vector<std::size_t> order;
  dSpaceCollide(space, &order, list_firsts);
  count.calls = 0;
  for (const std::size_t k : order) {
    geoms.change(k, boxes[k].bounds);
    dSpaceCollide2(reinterpret_cast<dGeomID>(space), geoms.geom(k), &count, count_others);
    geoms.change(k, {kInfinity, -kInfinity, kInfinity, -kInfinity, kInfinity, -kInfinity});
  }
  return count.calls;
}

/// Boxes that are alike along the other axes are reported as soon as they overlap along the first.
double count_sweep_candidates(dSpaceID space, std::span<const OdeBox> boxes) {
  constexpr unsigned long kEvery = ~0UL;
  OpenGeoms geoms(space);
  for (const OdeBox& box : boxes) geoms.add({box.bounds[0], box.bounds[1], 0, 1, 0, 1}, kEvery, kEvery);
  Count count{&geoms};
  dSpaceCollide(space, &count, count_others);
  return count.calls;
}

}  // namespace kerf
