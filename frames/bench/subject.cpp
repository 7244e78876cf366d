#include "frames/bench/subject.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "frames/bench/structure.h"
#include "frames/bench/truth.h"
#include "frames/rivals/rival.h"
#include "frames/rivals/step_timer.h"
#include "frames/support/machine.h"

namespace kerf {
namespace {

template <int D>
class Subject {
 public:
  Subject(std::function<std::unique_ptr<BroadPhase<D>>()> make, const StepBlock<D>& block,
          const Answers& answers, bool one_thread)
      : make_(std::move(make)), block_(&block), answers_(&answers), one_thread_(one_thread) {}

  void operator()(char request) {
    if (request == static_cast<char>(Request::build)) build();
    if (request == static_cast<char>(Request::run)) run();
    if (request == static_cast<char>(Request::account))
      answers_->account().bytes = peak_own_memory() - std::min(before_, peak_own_memory());
    if (request == static_cast<char>(Request::tests)) count_tests();
  }

 private:
  void build() {
    block_->touch();
    before_ = own_memory();
    const StepTimer timer(one_thread_);
    broad_phase_ = make_();
    const auto boxes = block_->boxes(0);
    for (std::uint32_t k = 0; k < boxes.size(); ++k)
      if (!is_absent(boxes[k])) insert({k}, boxes[k]);
    broad_phase_->step();
    note(0, timer.nanoseconds());
  }
  void insert(ObjectId object, const Box<D>& box) {
    const auto mobility = object.index() < block_->moving() ? Mobility::moving : Mobility::fixed;
    static_cast<void>(broad_phase_->insert(object, box, mobility));
  }
  void run() {
    for (std::uint32_t step = 0; step < block_->steps(); ++step) {
      const StepTimer timer(one_thread_);
      for (const ObjectId object : block_->removed(step)) static_cast<void>(broad_phase_->remove(object));
      for (const ObjectId object : block_->inserted(step))
        insert(object, block_->boxes(step)[object.index()]);
      static_cast<void>(broad_phase_->move_many(block_->moved(step), block_->moved_boxes(step)));
      broad_phase_->step();
      note(step, timer.nanoseconds());
    }
  }
  void count_tests() {
    const std::optional<std::uint64_t> tests = tests_of(*broad_phase_, block_->objects());
    answers_->account().tests = tests.value_or(kUnknown);
    answers_->account().pairs = broad_phase_->pairs().size();
  }
  void note(std::uint32_t step, std::uint64_t nanoseconds) {
    auto* const library = dynamic_cast<AddedWork*>(broad_phase_.get());
    const std::uint64_t added = library == nullptr ? 0 : library->time_added();
    const auto found = broad_phase_->pairs();
    answers_->step(step) = {nanoseconds, added, found.size(), 0, 0};
    if (truth_of(found) == block_->truth(step)) return;
    const Difference difference = compare(found, true_pairs(block_->boxes(step), block_->moving()));
    answers_->step(step).missed = difference.missed;
    answers_->step(step).extra = difference.extra;
  }

  std::function<std::unique_ptr<BroadPhase<D>>()> make_;
  const StepBlock<D>* block_;
  const Answers* answers_;
  bool one_thread_;
  std::shared_ptr<BroadPhase<D>> broad_phase_;  ///< shared, because a Life is copied
  std::uint64_t before_ = 0;
};

/// The box around all boxes, in lanes that the compiler can vectorise.
template <int D>
Scalar read_all(std::span<const Box<D>> boxes) {
  constexpr std::size_t kLanes = 48;
  static_assert(kLanes * sizeof(Scalar) % sizeof(Box<D>) == 0);
  std::array<Scalar, kLanes> most{};
  const Scalar* const floats = boxes.front().min.value.data();
  const std::size_t count = boxes.size() * 2 * D;
  for (std::size_t at = 0; at + kLanes <= count; at += kLanes)
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      most[lane] = floats[at + lane] > most[lane] ? floats[at + lane] : most[lane];
  return *std::max_element(most.begin(), most.end());
}

template <int D>
class Floor {
 public:
  Floor(const StepBlock<D>& block, const Answers& answers) : block_(&block), answers_(&answers) {}

  void operator()(char request) {
    if (request == static_cast<char>(Request::tests)) answers_->account().tests = kUnknown;
    if (request == static_cast<char>(Request::account) || request == static_cast<char>(Request::tests))
      return;
    block_->touch();
    const bool build = request == static_cast<char>(Request::build);
    for (std::uint32_t step = 0; step < (build ? 1 : block_->steps()); ++step) pass(step);
  }

 private:
  void pass(std::uint32_t step) {
    if (pairs_.size() < block_->truth(step).pairs) pairs_.resize(2 * block_->truth(step).pairs);
    const StepTimer timer(true);
    const auto something = static_cast<std::uint32_t>(read_all(block_->boxes(step)));
    std::fill_n(pairs_.begin(), block_->truth(step).pairs, Pair{{something}, {step}});
    answers_->step(step) = {timer.nanoseconds(), 0, block_->truth(step).pairs, 0, 0};
  }

  const StepBlock<D>* block_;
  const Answers* answers_;
  std::vector<Pair> pairs_;
};

}  // namespace

template <int D>
Life subject_life(std::function<std::unique_ptr<BroadPhase<D>>()> make, const StepBlock<D>& block,
                  const Answers& answers, bool one_thread) {
  return Subject<D>(std::move(make), block, answers, one_thread);
}

template <int D>
Life floor_life(const StepBlock<D>& block, const Answers& answers) {
  return Floor<D>(block, answers);
}

template Life subject_life<2>(std::function<std::unique_ptr<BroadPhase<2>>()>, const StepBlock<2>&,
                              const Answers&, bool);
template Life subject_life<3>(std::function<std::unique_ptr<BroadPhase<3>>()>, const StepBlock<3>&,
                              const Answers&, bool);
template Life floor_life<2>(const StepBlock<2>&, const Answers&);
template Life floor_life<3>(const StepBlock<3>&, const Answers&);

}  // namespace kerf
