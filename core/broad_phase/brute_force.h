#pragma once

#include <vector>

#include "core/objects/broad_phase.h"
#include "core/objects/object_table.h"
#include "core/objects/structure.h"

namespace kerf {

/// The oracle: tests every object against every other. Exact by definition, O(n^2).
template <int D>
class BruteForce : public BroadPhase<D>, public SelfDescribing<D> {
 public:
  explicit BruteForce(VolumeKind kind = VolumeKind::box) : objects_(kind) {}

  [[nodiscard]] std::string_view name() const override { return "brute-force"; }
  [[nodiscard]] VolumeKind volume_kind() const override { return objects_.kind(); }
  Status insert(ObjectId object, const Box<D>& box, Mobility mobility) override {
    return objects_.insert(object, box, mobility);
  }
  Status insert(ObjectId object, const Volume<D>& volume, Mobility mobility) override {
    return objects_.insert(object, volume, mobility);
  }
  Status move(ObjectId object, const Box<D>& box) override { return objects_.move(object, box); }
  Status move(ObjectId object, const Volume<D>& volume) override { return objects_.move(object, volume); }
  Status remove(ObjectId object) override { return objects_.remove(object); }
  void step() override;
  [[nodiscard]] std::span<const Pair> pairs() const override { return pairs_; }
  /// Has no structure: describes only how many tests that takes.
  void describe(StructureParts<D>& parts) const override;

 protected:
  ObjectTable<D> objects_;
  std::vector<Pair> pairs_;
};

}  // namespace kerf
