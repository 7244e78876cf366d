#pragma once

#include <memory>
#include <vector>

#include "core/objects/broad_phase.h"
#include "core/objects/object_table.h"
#include "core/recording/step_requests.h"

namespace kerf {

/// Several broad phases that get the same boxes: what is requested before a step goes to each of them in
/// turn. The pairs are those of the first.
template <int D>
class SideBySide final : public BroadPhase<D> {
 public:
  /// At least one.
  explicit SideBySide(std::vector<std::unique_ptr<BroadPhase<D>>> all);

  [[nodiscard]] std::string_view name() const override { return all_.front()->name(); }
  Status insert(ObjectId object, const Box<D>& box, Mobility mobility) override;
  Status move(ObjectId object, const Box<D>& box) override;
  Status remove(ObjectId object) override;
  void step() override;
  [[nodiscard]] std::span<const Pair> pairs() const override { return all_.front()->pairs(); }

  [[nodiscard]] std::size_t size() const { return all_.size(); }
  [[nodiscard]] const BroadPhase<D>& operator[](std::size_t k) const { return *all_[k]; }
  /// What a step of broad phase k took on average of the last steps, its requests included.
  [[nodiscard]] double milliseconds(std::size_t k) const;

 private:
  static constexpr std::size_t kSteps = 25;

  std::vector<std::unique_ptr<BroadPhase<D>>> all_;
  ObjectTable<D> table_;  ///< answers requests
  StepRequests<D> requests_;
  std::vector<std::vector<double>> times_;  ///< by broad phase: a ring of the last kSteps
  std::size_t steps_ = 0;
};

}  // namespace kerf
