#include "frames/bench/bench_cell.h"

#include <malloc.h>

#include <algorithm>
#include <memory>

#include "frames/bench/participant.h"
#include "frames/bench/truth.h"
#include "frames/catalog/algorithm.h"

namespace kerf {
namespace {

/// The truth of one step in so many is found by a second algorithm, too.
constexpr std::size_t kConfirmed = 16;

/// Steps in a block: enough to warm the caches, in bounded memory.
template <int D>
std::uint32_t block_capacity(std::uint32_t objects) {
  constexpr std::size_t kBytes = std::size_t{128} << 20U;
  constexpr std::size_t kMost = 16;
  return static_cast<std::uint32_t>(std::clamp<std::size_t>(kBytes / (sizeof(Box<D>) * objects), 2, kMost));
}

template <int D>
class Cell {
 public:
  Cell(const CellPlan& plan, const MotionSource<D>& make, const CellWatch& watch)
      : plan_(plan), make_(make), watch_(watch), capacity_(block_capacity<D>(plan.objects)) {
    participants_.push_back(std::make_unique<Participant>("floor", capacity_, plan));
    for (const std::string& name : plan.algorithms) {
      const auto algorithm = find_algorithm<D>(name);
      if (!algorithm || algorithm->max_threads < plan.threads) continue;
      algorithms_.push_back(*algorithm);
      participants_.push_back(std::make_unique<Participant>(name, capacity_, plan));
    }
  }
  CellResult measure() {
    for (round_ = 0; round_ < plan_.rounds && !watch_.stop() && !algorithms_.empty(); ++round_) play_round();
    return result();
  }

 private:
  void play_round() {
    const auto motion = make_();
    StepBlock<D> block(*motion, capacity_);
    begin(*motion, block);
    for (std::uint32_t done = 0; done < plan_.warm_up + plan_.steps && !watch_.stop();
         done += block.steps()) {
      block.clear();
      const std::uint32_t left = plan_.warm_up + plan_.steps - done;
      for (std::uint32_t k = 0; k < std::min(capacity_, left); ++k) {
        motion->advance();
        add(*motion, block);
      }
      play_block(block, done);
    }
    for (const auto& participant : participants_) participant->finish(watch_);
  }
  void begin(const Motion<D>& motion, StepBlock<D>& block) {
    step_ = 0;
    add(motion, block);
    // Memory that this process has freed must not be free for its children: their memory is measured.
    malloc_trim(0);
    RivalHints<D> hints{motion.bounds(), motion.box_size(), plan_.objects};
    hints.may_try = true;
    for (std::size_t k = 0; k < participants_.size(); ++k) {
      const Answers& answers = participants_[k]->answers();
      participants_[k]->start(
          k == 0 ? floor_life(block, answers)
                 : subject_life<D>(maker(algorithms_[k - 1], hints), block, answers, plan_.threads == 1));
    }
    for (const auto& participant : participants_) {
      watch_.progress(where(0) + participant->name());
      if (!watch_.stop()) participant->build(watch_);
    }
  }
  [[nodiscard]] auto maker(const Algorithm<D>& algorithm, const RivalHints<D>& hints) const {
    return [make = algorithm.make, hints, threads = plan_.threads] { return make(hints, threads); };
  }
  /// The first round computes the truth.
  void add(const Motion<D>& motion, StepBlock<D>& block) {
    block.add(motion);
    if (truths_.size() <= step_) {
      const auto find = step_ % kConfirmed == 0 ? confirmed_pairs<D> : true_pairs<D>;
      truths_.push_back(truth_of(find(motion.boxes(), motion.moving())));
      if (step_ >= plan_.warm_up) meter_.add(motion, truths_.back().pairs);
    }
    block.set_truth(block.steps() - 1, truths_[step_++]);
  }
  void play_block(const StepBlock<D>& block, std::uint32_t done) {
    const std::size_t count = participants_.size();
    const std::int64_t first = static_cast<std::int64_t>(done) - plan_.warm_up;
    for (std::size_t k = 0; k < count && !watch_.stop(); ++k) {
      Participant& participant = *participants_[(k + done / capacity_ + round_) % count];
      watch_.progress(where(done) + participant.name());
      participant.run(first, block.steps(), watch_);
    }
  }
  [[nodiscard]] std::string where(std::uint32_t done) const {
    return plan_.scene + " " + std::to_string(D) + "D, " + std::to_string(plan_.objects) +
           " objects: round " + std::to_string(round_ + 1) + "/" + std::to_string(plan_.rounds) + ", step " +
           std::to_string(done) + "/" + std::to_string(plan_.warm_up + plan_.steps) + "  ";
  }
  [[nodiscard]] CellResult result() const {
    CellResult result;
    const CellName cell{plan_.scene, D, plan_.objects, plan_.threads};
    for (const auto& participant : participants_) {
      if (auto row = participant->row(cell, plan_.trace)) result.rows.push_back(std::move(*row));
      if (!participant->trouble().empty())
        result.gaps.push_back({cell, participant->name(), participant->trouble()});
    }
    const double floor = result.rows.empty() ? 0 : result.rows.front().median_ns;
    for (BenchRow& row : result.rows) row.times_floor = floor > 0 ? row.median_ns / floor : 0;
    result.properties = meter_.properties();
    return result;
  }

  const CellPlan& plan_;
  const MotionSource<D>& make_;
  const CellWatch& watch_;
  std::uint32_t capacity_;
  std::vector<Algorithm<D>> algorithms_;
  std::vector<std::unique_ptr<Participant>> participants_;  ///< the floor, then as algorithms_
  std::vector<Truth> truths_;                               ///< by step; the first is that of the beginning
  PropertyMeter<D> meter_;
  std::uint32_t round_ = 0;
  std::size_t step_ = 0;
};

}  // namespace

template <int D>
CellResult measure_cell(const CellPlan& plan, const MotionSource<D>& make, const CellWatch& watch) {
  return Cell<D>(plan, make, watch).measure();
}

template <int D>
CellResult measure_cell(const CellPlan& plan, const CellWatch& watch) {
  const BenchScene& scene = find_bench_scene(plan.scene);
  const MotionSource<D> make = [&] { return scene.make<D>(plan.objects, plan.seed); };
  return measure_cell<D>(plan, make, watch);
}

template CellResult measure_cell<2>(const CellPlan&, const MotionSource<2>&, const CellWatch&);
template CellResult measure_cell<3>(const CellPlan&, const MotionSource<3>&, const CellWatch&);
template CellResult measure_cell<2>(const CellPlan&, const CellWatch&);
template CellResult measure_cell<3>(const CellPlan&, const CellWatch&);

}  // namespace kerf
