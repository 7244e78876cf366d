#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/broad_phase/approximation.h"
#include "core/objects/broad_phase.h"
#include "core/objects/object_table.h"

namespace kerf {

/// A broad phase that passes its requests to another one, late or rounded, as an `Approximation` says. Its
/// `pairs()` may therefore disagree with the boxes given; the difference is what the settings measure.
///
/// It handles only boxes. A removal and a box that cannot be placed are never late: the next step is then a
/// placement, so that no pair names an object that is gone.
template <int D>
class Approximate final : public BroadPhase<D> {
 public:
  /// `inner` holds no objects yet. Throws std::invalid_argument for settings that cannot work.
  Approximate(std::unique_ptr<BroadPhase<D>> inner, const Approximation& how);

  [[nodiscard]] std::string_view name() const override { return name_; }
  using BroadPhase<D>::insert;
  using BroadPhase<D>::move;
  Status insert(ObjectId object, const Box<D>& box, Mobility mobility) override;
  Status move(ObjectId object, const Box<D>& box) override;
  Status remove(ObjectId object) override;
  void step() override;
  [[nodiscard]] std::span<const Pair> pairs() const override {
    return how_.filter ? std::span<const Pair>(filtered_) : inner_->pairs();
  }

 private:
  [[nodiscard]] Box<D> handed_on(const Box<D>& box) const;
  void place();
  void filter();

  std::unique_ptr<BroadPhase<D>> inner_;
  Approximation how_;
  std::string name_;
  ObjectTable<D> latest_;          ///< as last given by the caller
  std::vector<Box<D>> given_;      ///< per object: the last box given to `inner_`
  std::vector<ObjectId> changed_;  ///< objects moved since the last placement
  std::vector<std::uint8_t> is_changed_;
  std::vector<ObjectId> ids_;
  std::vector<Box<D>> boxes_;
  std::vector<Pair> filtered_;
  std::uint32_t age_;      ///< steps since the last placement
  bool is_urgent_ = true;  ///< the next step is a placement
};

}  // namespace kerf
