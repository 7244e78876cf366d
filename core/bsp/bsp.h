#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/append_buffer.h"
#include "core/base/config.h"
#include "core/base/task_pool.h"
#include "core/bsp/kept_step.h"
#include "core/bsp/mode_chooser.h"
#include "core/bsp/ordered_step.h"
#include "core/bsp/phase_clock.h"
#include "core/bsp/requests.h"
#include "core/bsp/step_context.h"
#include "core/bsp/swept_step.h"
#include "core/bsp/thread_use.h"
#include "core/objects/broad_phase.h"
#include "core/trace/reporter.h"
#include "core/trace/statistics.h"
#include "core/tree/scheduler.h"
#include "core/tree/tree.h"

namespace kerf {

template <int D>
struct BspState;

/// The Semi-Adjusting BSP-tree as a broad phase (paper sections 3 to 5). Every event is reported to `Trace`;
/// with NoTrace that costs nothing.
///
/// A step gathers the requests, chooses a mode, places the objects, lets the scheduler's operators adjust the
/// tree, and finds the pairs. How objects are placed and pairs are found is the business of the mode's
/// strategy: OrderedStep, SweptStep or KeptStep. This class has fourteen fields, since it is where all parts
/// of a step meet; what they do with each other is in `adapt`, `place` and `find_pairs`, and nowhere else.
///
/// If a request or a step throws because memory runs out, the tree can only be destroyed or restored; World
/// makes it anew by itself.
template <int D, class Trace = NoTrace>
class Bsp final : public BroadPhase<D> {
 public:
  /// The default is the paper's tree; `tuned_config()` is the fastest one, which World, C and Python have by
  /// default. Throws std::invalid_argument when the configuration cannot work (see `config_fields` for the
  /// ranges), or D dimensions have no such volumes.
  explicit Bsp(const Config& config = {}, VolumeKind kind = VolumeKind::box);

  [[nodiscard]] std::string_view name() const override { return "kerf"; }
  [[nodiscard]] VolumeKind volume_kind() const override { return requests_.kind(); }
  Status insert(ObjectId object, const Box<D>& box, Mobility mobility) override;
  Status insert(ObjectId object, const Volume<D>& volume, Mobility mobility) override;
  Status move(ObjectId object, const Box<D>& box) override;
  Status move(ObjectId object, const Volume<D>& volume) override;
  Status remove(ObjectId object) override;
  /// Throws std::invalid_argument unless there are as many boxes as objects.
  Status move_many(std::span<const ObjectId> objects, std::span<const Box<D>> boxes) override;
  /// Room for the moves of so many objects: the next call of `move_many` then takes all of them if they are
  /// different ones, or this one throws for lack of memory, and nothing has changed.
  void make_room_for_moves(std::size_t count) { requests_.make_room_for_moves(count); }
  void step() override;
  /// Like step(), but finds no pairs: events and state are the same, `pairs()` is empty. Kept pairs are
  /// forgotten: the next `step()` finds all anew.
  void step_unswept();
  [[nodiscard]] std::span<const Pair> pairs() const override { return pairs_.all(); }
  /// Gives the list of pairs away, for a caller that keeps it without a copy, and takes the memory of
  /// `buffer` for the next one. Until then `pairs()` is empty.
  void exchange_pairs(PairBuffer& buffer) {
    std::swap(pairs_, buffer);
    pairs_.clear();
  }

  [[nodiscard]] const Config& config() const { return config_; }
  /// Takes effect from the next step on; the tree is kept. The direction set cannot change: throws
  /// std::invalid_argument if `directions` or `seed` differ.
  void set_config(const Config& config);
  /// Overrides what Algorithm 1 decides for single operators; each decision names its event, which is the
  /// same in every run up to there. Throws std::invalid_argument for a tree that numbers no events (NoTrace),
  /// or for a partitioner that cannot be.
  void decide(std::vector<Decision> decisions);
  /// How many threads may share the work of a step; 1 to begin with. They do where steps take less time by it
  /// than by one thread, unless `sharing` says always. Pairs and their order, events and state are the same
  /// for any number. Throws std::invalid_argument for 0 and for more than TaskPool::kMostThreads.
  void set_threads(unsigned threads, Sharing sharing = Sharing::if_faster) { threads_.set(threads, sharing); }
  /// Whether `statistics()` has the time of each phase: only with a trace to begin with.
  void time_phases(bool on) { clock_.set_on(on); }
  [[nodiscard]] const Tree<D>& tree() const { return tree_; }
  /// The objects as the caller sees them, up to the next request or step; the tree's own table follows in
  /// `step()` and may have fat boxes.
  [[nodiscard]] const ObjectTable<D>& objects() const { return requests_.latest(); }
  [[nodiscard]] Statistics statistics() const;
  /// How the last step found its pairs.
  [[nodiscard]] Mode mode() const { return modes_.mode(); }
  /// The transition by which the last step came to its mode; null if the step before had the same.
  [[nodiscard]] const Transition* transition() const { return modes_.taken(); }
  /// Equal for equal trees with equal events pending, wherever they were built.
  [[nodiscard]] std::uint64_t state_hash() const;
  /// Steps done so far; events carry the number of the step in which they happened, the first being 1.
  [[nodiscard]] std::uint32_t steps() const { return step_; }
  [[nodiscard]] Trace& trace() { return reporter_.trace(); }

  /// Everything that decides what the coming steps do. Take it right after a step: requests that wait are not
  /// part of it.
  [[nodiscard]] BspState<D> state() const;
  /// Goes on from a state of any tree of the same kind of volume: every step then has the same hash, the same
  /// events and the same pairs, which may come in another order.
  void restore(const BspState<D>& state);

 private:
  /// The receiver of requests.
  typename Requests<D>::Receiver receiver() {
    return {tree_.table, threads_.pool(), modes_.mode() == Mode::kept};
  }
  StepContext<D> context(const std::optional<Vector<D>>& shift = {}) {
    return {config_, tree_, requests_, memory_, threads_, step_, shift};
  }
  [[nodiscard]] bool is_calm() const;
  void step_in_rows();
  void adapt();
  [[nodiscard]] std::optional<Vector<D>> common_motion(std::uint64_t row_tests) const;
  [[nodiscard]] std::uint64_t row_tests() const;
  [[nodiscard]] Evidence evidence(std::uint64_t row_tests, bool is_shift) const;
  void choose_mode(std::uint64_t row_tests, bool is_shift);
  void place();
  std::uint64_t place_after(Mode before, const StepContext<D>& step, bool rows);
  void sort_leaves();
  void find_pairs();
  void begin(Phase phase);

  Config config_;
  Tree<D> tree_;
  Scheduler<D> scheduler_;
  Reporter<Trace> reporter_;
  Requests<D> requests_;
  ModeChooser modes_{D};
  SweptStep<D> swept_;
  KeptStep<D> kept_;
  StepMemory<D> memory_;
  ThreadUse threads_;
  PairBuffer pairs_;
  PhaseClock clock_;
  std::uint64_t placed_ = 0;
  std::uint32_t step_ = 0;
};

}  // namespace kerf
