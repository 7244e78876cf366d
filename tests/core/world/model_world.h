#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "core/world/world.h"

namespace kerf::test {

/// What a World is, written as maps and loops over all pairs.
template <int D>
class ModelWorld {
 public:
  struct Object {
    Handle handle;
    Box<D> box;
    Box<D> fat;
    ObjectDef def;
  };
  /// Ordered as the reports are.
  using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;  ///< indices of a and b, flags
  using Report = std::map<Key, WorldPair>;

  explicit ModelWorld(PairsOf pairs_of) : pairs_of_(pairs_of) {}

  void insert(Handle handle, const Box<D>& box, const ObjectDef& def) {
    objects[handle] = {handle, box, grown(box, def.margin), def};
  }
  void move(Handle handle, const Box<D>& box) {
    Object& object = objects.at(handle);
    object.box = box;
    if (object.def.margin == 0 || !kerf::contains(object.fat, box))
      object.fat = grown(box, object.def.margin);
  }
  void shift_origin(const Vector<D>& by) {
    for (auto& [handle, object] : objects) {
      object.box = {object.box.min + by, object.box.max + by};
      object.fat = {object.fat.min + by, object.fat.max + by};
    }
  }
  void set_margin(Handle handle, Scalar margin) {
    Object& object = objects.at(handle);
    object.def.margin = margin;
    object.fat = grown(object.box, margin);
  }
  template <class Allowed>
  void step(Allowed allowed) {
    before = now;
    now.clear();
    for (const auto& [handle, one] : objects)
      for (const auto& [other, two] : objects)
        if (handle.index() < other.index() && is_pair(one, two) && allowed(one.def, two.def)) add(one, two);
  }
  /// The pairs of one report that the other does not have.
  static std::vector<WorldPair> difference(const Report& of, const Report& from) {
    std::vector<WorldPair> pairs;
    for (const auto& [key, pair] : of) {
      const auto found = from.find(key);
      if (found == from.end() || found->second != pair) pairs.push_back(pair);
    }
    return pairs;
  }

  std::map<Handle, Object> objects;
  Report before;
  Report now;

 private:
  static Box<D> grown(Box<D> box, Scalar margin) {
    for (int i = 0; i < D; ++i) {
      box.min[i] -= margin;
      box.max[i] += margin;
    }
    return box;
  }
  [[nodiscard]] bool is_pair(const Object& one, const Object& two) const {
    const auto is_active = [](const Object& object) {
      return object.def.kind == ObjectKind::moving || object.def.kind == ObjectKind::sensor;
    };
    if (!is_active(one) && !is_active(two)) return false;
    const PairFilter& a = one.def.filter;
    const PairFilter& b = two.def.filter;
    const bool same_group = a.group == b.group && a.group != 0;
    const bool by_bits = (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
    if (same_group ? a.group < 0 : !by_bits) return false;
    return pairs_of_ == PairsOf::fat_boxes ? overlaps(one.fat, two.fat)
                                           : overlaps(one.fat, two.fat) && overlaps(one.box, two.box);
  }
  void add(const Object& one, const Object& two) {
    const bool sensor = one.def.kind == ObjectKind::sensor || two.def.kind == ObjectKind::sensor;
    const WorldPair pair{one.handle, two.handle, sensor ? 1U : 0U, 0};
    now[{one.handle.index(), two.handle.index(), pair.flags}] = pair;
  }

  PairsOf pairs_of_;
};

}  // namespace kerf::test
