#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/config.h"
#include "core/bsp/bsp.h"
#include "core/geometry/box.h"
#include "core/world/handle.h"
#include "core/world/object_def.h"
#include "core/world/pair_rows.h"
#include "core/world/slots.h"
#include "core/world/world_pair.h"
#include "core/world/world_status.h"

namespace kerf {

template <int D>
class WorldCodec;
template <int D>
class WorldIndex;

/// Whose overlap makes a pair. They differ only for objects with a margin.
enum class PairsOf : std::uint8_t {
  fat_boxes,    ///< pairs begin before the boxes touch and end after they part, by up to the margins
  exact_boxes,  ///< pairs of the boxes as given
};

struct WorldOptions {
  Config config = tuned_config();  ///< of the tree
  PairsOf pairs_of = PairsOf::fat_boxes;
  unsigned threads = 1;  ///< that may share a step, the caller's included; never part of a result
  Sharing sharing = Sharing::if_faster;  ///< when they do (see Bsp::set_threads)
  /// Part of each handle. Handles of worlds with different tags are never mistaken for each other; between
  /// worlds of one tag they may be, which harms nothing but what the caller meant.
  std::uint8_t tag = 0;
};

/// Asked in each step about each pair that kinds and filters allow, in the order of the report, on the thread
/// that called `step()`; true reports the pair. Meanwhile the world refuses to change: what returns a status
/// is `busy`, and what returns none throws std::logic_error. An exception leaves through `step()`, and the
/// reports stay those of the step before: call `step()` again.
using PairCallback = std::function<bool(const WorldPair&)>;

/// A broad phase for programs: objects with handles, kinds, filters and user data in, begun, ended and all
/// pairs out. It stands on Bsp, and its pairs are exact (DESIGN.md, "Correct pairs").
///
/// **Requests** take effect in the next `step()`; what `find` and `box` return changes at once. A request
/// that fails changes nothing. In a batch each object is a request of its own: those that can be met are. If
/// `statuses` is not empty, it gets the status of each; the call returns the first failure, else `clamped` if
/// any is, else `ok`. Lists of different lengths fail as a whole.
///
/// **Reports** are ordered by the indices of the handles, first by that of `a`, which is the smaller one.
/// They depend only on the requests: not on threads, machine, tree, or whether the world was saved and
/// restored.
///
/// **Memory** follows the most objects that lived at a time, not how many ever lived. (An index is given up
/// after 2^28 lives.)
///
/// **Threads**: functions that are const may be called at the same time; no other may be meanwhile. Different
/// threads may use different worlds at the same time: each world has its own oneTBB task arena, and the
/// worker threads belong to the process. `step()` uses them where that makes it faster (see
/// Bsp::set_threads).
///
/// Throws std::bad_alloc if memory runs out. The world then stays usable, and of a batch each object was
/// taken or was not. A world that was moved from can only be destroyed, assigned to or restored.
template <int D>
class World {
 public:
  /// Throws std::invalid_argument for a configuration that cannot work, no threads, or too many.
  explicit World(const WorldOptions& options = {});

  struct Inserted {
    WorldStatus status;
    Handle handle;  ///< none if it failed
  };
  /// `bad_box` for NaN and inverted boxes, `bad_value` for an unknown kind or a margin that is no length,
  /// `full` if no index is free, `clamped` if a bound was infinite.
  [[nodiscard]] Inserted insert(const Box<D>& box, const ObjectDef& def = {});
  /// `defs`: one for each box, or one for all. `handles`: one for each box; none for those that failed.
  WorldStatus insert(std::span<const Box<D>> boxes, std::span<const ObjectDef> defs,
                     std::span<Handle> handles, std::span<WorldStatus> statuses = {});
  /// `stale_handle`, `bad_box` or `clamped`.
  WorldStatus move(Handle object, const Box<D>& box);
  /// Moves are made in the order of the lists; the last one of an object counts.
  WorldStatus move(std::span<const Handle> objects, std::span<const Box<D>> boxes,
                   std::span<WorldStatus> statuses = {});
  /// Moves every object by the vector: what a program with a floating origin calls. Boxes are moved as floats
  /// round, and where moves of this step say otherwise, they are moved from there. Tree and fat boxes come
  /// along: only the step of the shift costs more than others, no pair ends, and one begins by rounding
  /// alone. `bad_value` if the vector is not finite, `clamped` if a box would exceed the range of floats.
  /// If memory runs out, no object has moved.
  WorldStatus shift_origin(const Vector<D>& by);
  /// The handle is stale at once. Pairs that the object had in the last step are reported as ended in the
  /// next one, with its handle. `stale_handle` if there is no such object.
  WorldStatus remove(Handle object);
  WorldStatus remove(std::span<const Handle> objects, std::span<WorldStatus> statuses = {});

  /// All four: `stale_handle` if there is no such object; `set_kind` and `set_margin` also `bad_value`.
  /// A pair that was a sensor's and is not now, or the other way round, ends and begins.
  WorldStatus set_kind(Handle object, ObjectKind kind);
  WorldStatus set_filter(Handle object, const PairFilter& filter);
  WorldStatus set_user_data(Handle object, std::uint64_t user_data);
  /// Makes a new fat box. `margin`: units of length, finite and not negative.
  WorldStatus set_margin(Handle object, Scalar margin);
  /// An empty function: no pair is asked about.
  void set_callback(PairCallback callback);
  /// Throws std::invalid_argument for 0, and for more than TaskPool::kMostThreads.
  void set_threads(unsigned threads, Sharing sharing = Sharing::if_faster);

  /// Brings the tree up to date with all requests and makes the reports.
  void step();
  /// All pairs of the last step. Spans are valid until the next `step()` or `restore()`.
  [[nodiscard]] std::span<const WorldPair> pairs() const { return pairs_; }
  /// Pairs of the last step that the one before did not have.
  [[nodiscard]] std::span<const WorldPair> begun() const { return begun_; }
  /// Pairs of the step before that the last one does not have. Handles of removed objects are stale.
  [[nodiscard]] std::span<const WorldPair> ended() const { return ended_; }

  [[nodiscard]] bool contains(Handle object) const { return slots_.contains(object); }
  /// Null if the handle is stale. Valid until the next call that is not const.
  [[nodiscard]] const ObjectDef* find(Handle object) const;
  /// The box as it was given last (or clamped).
  [[nodiscard]] std::optional<Box<D>> box(Handle object) const;
  [[nodiscard]] std::optional<Box<D>> fat_box(Handle object) const;
  /// How many objects there are.
  [[nodiscard]] std::size_t size() const { return slots_.alive(); }
  /// More than each handle's index: the size for arrays kept by index.
  [[nodiscard]] std::size_t bound() const { return slots_.size(); }
  /// Calls `visit(handle)` for each object, by index.
  template <class Visit>
  void for_each(Visit visit) const {
    slots_.for_each(visit);
  }
  /// The tree: its statistics, and what explains it. Object k of the tree has index k.
  [[nodiscard]] const Bsp<D>& tree() const { return *tree_; }

  /// Everything but callback and threads, as bytes with a version and a checksum. Fails between a request and
  /// the next step, and within a step.
  WorldStatus save(std::vector<std::uint8_t>& bytes) const;
  /// Becomes the world that was saved: it goes on exactly as that one. `bytes` may be anything: whatever no
  /// world wrote is refused, and the world is as it was. `why`, if given, gets a sentence.
  WorldStatus restore(std::span<const std::uint8_t> bytes, std::string* why = nullptr);

 private:
  class Change;
  void throw_if_asking() const;
  [[nodiscard]] WorldStatus check(Handle object) const;
  template <class Request>
  WorldStatus for_each_of(std::size_t count, std::span<WorldStatus> statuses, Request request);
  WorldStatus insert_one(Box<D> box, const ObjectDef& def, Handle& handle);
  WorldStatus move_one(Handle object, Box<D> box);
  WorldStatus remove_one(Handle object);
  bool list_moves(std::span<const Handle> objects, std::span<const Box<D>> boxes);
  void move_listed();
  void count(const ObjectDef& def, std::ptrdiff_t times);
  void rebuild();
  [[nodiscard]] bool may_report(ObjectId a, ObjectId b) const;
  [[nodiscard]] Box<D> exact_box(ObjectId object) const;
  [[nodiscard]] WorldPair describe(std::uint32_t a, Partner b) const;
  void gather();
  void report();

  friend class WorldCodec<D>;
  friend class WorldIndex<D>;

  WorldOptions options_;
  std::unique_ptr<Bsp<D>> tree_;
  Slots slots_;
  std::vector<ObjectDef> defs_;  ///< by index
  std::vector<Box<D>> exact_;    ///< by index, of objects with a margin
  std::ptrdiff_t margins_ = 0;   ///< how many objects have one
  std::ptrdiff_t filters_ = 0;   ///< how many have another than the default
  std::ptrdiff_t sensors_ = 0;
  bool unstepped_ = false;  ///< there were requests since the last step
  bool torn_ = false;       ///< memory ended within a change of the tree
  bool is_asking_ = false;  ///< the callback
  std::shared_ptr<const int> identity_ = std::make_shared<const int>();  ///< another one after `restore`
  PairCallback callback_;
  PairRows rows_;       ///< of the last step
  PairRows next_rows_;  ///< of the present one
  std::vector<WorldPair> pairs_;
  std::vector<WorldPair> begun_;
  std::vector<WorldPair> ended_;
  std::vector<WorldPair> next_pairs_;
  std::vector<WorldPair> next_begun_;
  std::vector<WorldPair> next_ended_;
  std::vector<ObjectId> ids_;      ///< of one call
  std::vector<Box<D>> fat_boxes_;  ///< of one call
  std::vector<Pair> allowed_;      ///< of one step: pairs that kinds and filters allow
};

}  // namespace kerf
