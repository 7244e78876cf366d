#pragma once

#include <vector>

#include "core/objects/broad_phase.h"
#include "core/objects/object_table.h"

namespace kerf::test {

/// The oracle for many objects: tests each pair that overlaps along one axis. Exact as brute force is, and
/// nearly as plain: boxes in the order of their lower ends, each against those that begin before it ends.
template <int D>
class ScanOracle final : public BroadPhase<D> {
 public:
  explicit ScanOracle(VolumeKind kind = VolumeKind::box) : objects_(kind) {}

  [[nodiscard]] std::string_view name() const override { return "scan"; }
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
  /// In the order of `Pair`.
  [[nodiscard]] std::span<const Pair> pairs() const override { return pairs_; }

 private:
  [[nodiscard]] int best_axis(const std::vector<ObjectId>& placed) const;

  ObjectTable<D> objects_;
  std::vector<Pair> pairs_;
};

}  // namespace kerf::test
