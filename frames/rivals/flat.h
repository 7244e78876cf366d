#pragma once

#include <memory>
#include <utility>

#include "core/objects/structure.h"
#include "frames/rivals/rival.h"

namespace kerf {

/// The box of a slab of unit thickness.
inline Box<3> flat_box(const Box<2>& box) {
  return {{{box.min[0], box.min[1], 0}}, {{box.max[0], box.max[1], 1}}};
}

/// The description of a structure of such slabs, without the third axis. No library cuts its cells by planes.
inline StructureParts<2> flat_parts(StructureParts<3> solid) {
  StructureParts<2> parts;
  parts.kind = solid.kind;
  parts.holding = solid.holding;
  for (const StructureCell<3>& cell : solid.cells) {
    const Box<2> box{{{cell.box.min[0], cell.box.min[1]}}, {{cell.box.max[0], cell.box.max[1]}}};
    parts.cells.push_back({box, cell.name, cell.parent, cell.depth, kNoPart});
  }
  parts.members = std::move(solid.members);
  std::erase_if(solid.lists, [](const AxisList& list) { return list.axis == 2; });
  parts.lists = std::move(solid.lists);
  parts.tests = solid.tests;
  parts.tells_tested = solid.tells_tested;
  parts.tested = std::move(solid.tested);
  parts.bytes = solid.bytes;
  parts.unseen = std::move(solid.unseen);
  return parts;
}

/// A 3D broad phase that gets 2D boxes as slabs of unit thickness: two slabs overlap iff the boxes do.
class Flat final : public BroadPhase<2>, public AddedWork, public SelfDescribing<2> {
 public:
  explicit Flat(std::unique_ptr<BroadPhase<3>> inner) : inner_(std::move(inner)) {}
  [[nodiscard]] std::string_view name() const override { return inner_->name(); }
  Status insert(ObjectId object, const Box<2>& box, Mobility mobility) override {
    return inner_->insert(object, flat_box(box), mobility);
  }
  Status move(ObjectId object, const Box<2>& box) override { return inner_->move(object, flat_box(box)); }
  Status remove(ObjectId object) override { return inner_->remove(object); }
  void step() override { inner_->step(); }
  [[nodiscard]] std::span<const Pair> pairs() const override { return inner_->pairs(); }
  std::uint64_t time_added() override {
    auto* const added = dynamic_cast<AddedWork*>(inner_.get());
    return added == nullptr ? 0 : added->time_added();
  }
  void describe(StructureParts<2>& parts) const override {
    const auto* const seen = dynamic_cast<const SelfDescribing<3>*>(inner_.get());
    if (seen == nullptr) {
      parts.unseen = "it does not describe its structure";
      return;
    }
    StructureParts<3> solid;
    seen->describe(solid);
    parts = flat_parts(std::move(solid));
  }

 private:
  std::unique_ptr<BroadPhase<3>> inner_;
};

/// Turns the factory of a 3D rival into one for 2D boxes.
template <auto Make>
std::unique_ptr<BroadPhase<2>> make_flat(const RivalHints<2>& hints, Intake intake) {
  return std::make_unique<Flat>(Make(
      {flat_box(hints.bounds), hints.box_size, hints.capacity, {true, true, false}, hints.may_try}, intake));
}

}  // namespace kerf
