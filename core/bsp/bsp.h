#pragma once

#include <array>
#include <chrono>
#include <memory>
#include <vector>

#include "core/base/append_buffer.h"
#include "core/base/config.h"
#include "core/base/task_pool.h"
#include "core/bsp/box_exchange.h"
#include "core/bsp/fat_piece.h"
#include "core/bsp/keep_or_sweep.h"
#include "core/bsp/kept_pairs.h"
#include "core/bsp/leaf_boxes.h"
#include "core/bsp/leaf_pass.h"
#include "core/bsp/leave.h"
#include "core/bsp/restless_pass.h"
#include "core/bsp/stream.h"
#include "core/kernels/move_boxes.h"
#include "core/objects/broad_phase.h"
#include "core/objects/skin.h"
#include "core/trace/reporter.h"
#include "core/trace/statistics.h"
#include "core/tree/placement.h"
#include "core/tree/scheduler.h"
#include "core/tree/tree.h"

namespace kerf {

template <int D>
struct BspState;

/// The Semi-Adjusting BSP-tree as a broad phase (paper sections 3 to 5). `Trace` is told of every event; with
/// NoTrace watching costs nothing.
template <int D, class Trace = NoTrace>
class Bsp final : public BroadPhase<D> {
 public:
  /// Throws std::invalid_argument when the configuration cannot work (see `config_fields` for the ranges).
  explicit Bsp(const Config& config = {}, VolumeKind kind = VolumeKind::box);

  [[nodiscard]] std::string_view name() const override { return "kerf"; }
  [[nodiscard]] VolumeKind volume_kind() const override { return latest_.kind(); }
  Status insert(ObjectId object, const Box<D>& box, Mobility mobility) override;
  Status insert(ObjectId object, const Volume<D>& volume, Mobility mobility) override;
  Status move(ObjectId object, const Box<D>& box) override;
  Status move(ObjectId object, const Volume<D>& volume) override;
  Status remove(ObjectId object) override;
  Status move_many(std::span<const ObjectId> objects, std::span<const Box<D>> boxes) override;
  void step() override;
  /// A step of whose pairs nobody asks: events and state are the same, `pairs()` is empty. Kept pairs are
  /// forgotten: the next `step()` finds all anew.
  void step_unswept();
  [[nodiscard]] std::span<const Pair> pairs() const override { return pairs_.all(); }

  [[nodiscard]] const Config& config() const { return config_; }
  /// Takes effect from the next step on; the tree is kept. The direction set cannot change: throws
  /// std::invalid_argument if `directions` or `seed` differ.
  void set_config(const Config& config);
  /// What happens to single operators instead of what Algorithm 1 says; each decision names its event, which
  /// is the same in every run up to there. Throws std::invalid_argument for a tree that numbers no events
  /// (NoTrace), or for a partitioner that cannot be.
  void decide(std::vector<Decision> decisions);
  /// How many threads may share the work of a step; 1 to begin with. Pairs and their order, events and state
  /// are the same for any number. Throws std::invalid_argument for 0.
  void set_threads(unsigned threads) { pool_ = std::make_unique<TaskPool>(threads); }
  [[nodiscard]] const Tree<D>& tree() const { return tree_; }
  /// The objects as the caller sees them, up to the next request or step; the tree's own table follows in
  /// `step()` and may have fat boxes.
  [[nodiscard]] const ObjectTable<D>& objects() const { return exchange_.is_open() ? tree_.table : latest_; }
  [[nodiscard]] Statistics statistics() const;
  /// Equal for equal trees with equal events pending, wherever they were built.
  [[nodiscard]] std::uint64_t state_hash() const;
  /// Steps done so far; events carry the number of the step in which they happened, the first being 1.
  [[nodiscard]] std::uint32_t steps() const { return step_; }
  [[nodiscard]] Trace& trace() { return reporter_.trace(); }

  /// Everything that decides what the coming steps do. To be taken right after a step: requests that wait are
  /// not part of it.
  [[nodiscard]] BspState<D> state() const;
  /// Goes on from a state of any tree of the same kind of volume: every step then has the same hash, the same
  /// events and the same pairs, which may come in another order.
  void restore(const BspState<D>& state);

 private:
  /// How the pairs of a step are found.
  enum class Mode : std::uint8_t {
    ordered,  ///< the paper's: each leaf is swept along its ordered list
    swept,    ///< each leaf is swept by vectors of bytes
    kept,     ///< pairs of fat boxes are kept and filtered: the tree's table has the fat boxes
  };

  /// The latest boxes, for a request.
  ObjectTable<D>& latest() {
    exchange_.end(latest_, tree_.table, {}, *pool_);
    return latest_;
  }
  Status note(ObjectId object, Status status);
  void adapt();
  void choose_mode();
  static constexpr std::size_t kSample = 64;  ///< objects that are asked how fast they are
  [[nodiscard]] Motions motions_of_sample() const;
  [[nodiscard]] bool most_jump() const;
  [[nodiscard]] Leaving who_leaves() const;
  void enter(Mode mode);
  void place();
  void place_changes();
  void place_all(bool many_stay = false);
  void put_at_rest();
  void place_entering(const std::vector<ObjectId>& entering);
  Box<D> fat_box(ObjectId object, const Box<D>& before, bool had_fat);
  void fatten_all();
  void slim_some();
  void note_unasked(ObjectId object, std::uint8_t attention, const PackedBox<D>& before);
  void follow_restless();
  void make_fat_boxes();
  void take_fat_boxes();
  void place_fat();
  [[nodiscard]] bool was_restless(ObjectId object) const {
    return (attention_[object.index()] & kWasRestless) != 0;
  }
  /// Of an object of which nobody has asked anything.
  [[nodiscard]] std::uint8_t attention_at_rest(ObjectId object) const {
    if (!latest_.is_placed(object)) return kUnplaced;
    return mode_ == Mode::kept && skins_[object.index()].is_restless() ? kSilent : 0;
  }
  void take_out();
  void put_in(const FatPiece& piece);
  void note_entries(ObjectId object, FatPiece& piece) const;
  void find_fat_places(std::size_t k, FatPiece& piece) const;
  void sweep();
  void sweep(NodeId leaf, LeafScratch<D>& scratch, PairBuffer& pairs);
  void sweep_bytes(NodeId leaf, LeafScratch<D>& scratch, PairBuffer& pairs);
  void begin(Phase phase);
  void end_phase();

  Config config_;
  Tree<D> tree_;
  Scheduler<D> scheduler_;
  Reporter<Trace> reporter_;
  ObjectTable<D> latest_;              ///< as the caller sees the objects; the tree's table follows in step()
  BoxExchange<D> exchange_;            ///< between these two
  AppendBuffer<ObjectId> changed_;     ///< objects of which the two tables may differ
  AppendBuffer<PackedBox<D>> before_;  ///< kept: the boxes from which those of changed_ moved
  AppendBuffer<std::uint32_t> left_over_;
  static constexpr std::uint8_t kChanging = 1;     ///< the object is in changed_
  static constexpr std::uint8_t kUnplaced = 2;     ///< it is absent or in quarantine
  static constexpr std::uint8_t kSlimmed = 4;      ///< it is in changed_ though nobody moved it
  static constexpr std::uint8_t kAtRest = 16;      ///< it is in changed_ for it did not move for long
  static constexpr std::uint8_t kWasRestless = 8;  ///< it is in changed_ and was restless before this step
  std::vector<std::uint8_t> attention_;            ///< per object: what must be looked at before it moves
  std::vector<Skin> skins_;                        ///< per object
  Mode mode_ = Mode::ordered;
  KeepOrSweep keep_or_sweep_;
  std::unique_ptr<TaskPool> pool_ = std::make_unique<TaskPool>();
  LeafPass<D> leaf_pass_;
  RestlessPass<D> restless_pass_;
  KeptPairs<D> kept_;
  std::vector<Box<D>> fat_;  ///< by changed_
  std::vector<FatPiece> fat_pieces_;
  StreamMemory stream_memory_;
  LeavePass<D> leave_pass_;
  LeafBoxes<D> leaf_boxes_;  ///< swept: of all leaves, where the table exceeds what is read fast
  bool only_moves_ =
      true;  ///< nothing was asked since the last step but that placed objects go to valid boxes
  PairBuffer pairs_;
  Phase phase_ = Phase::sweep;
  std::chrono::steady_clock::time_point phase_start_;
  std::array<double, kPhaseCount> phase_seconds_{};
  std::uint64_t placed_ = 0;
  std::uint32_t step_ = 0;
};

#define KERF_DECLARE(D, TRACE) extern template class Bsp<D, TRACE>;
KERF_FOR_EACH_TRACE(KERF_DECLARE)
#undef KERF_DECLARE

}  // namespace kerf
