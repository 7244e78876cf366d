#pragma once

#include <vector>

#include "core/recording/look_codec.h"
#include "core/recording/recording_info.h"
#include "core/recording/step_requests.h"
#include "core/recording/volume_predictor.h"
#include "core/trace/event.h"

namespace kerf {

/// The content of one step in a recording, beside its row in the table of steps.
template <int D>
struct RecordedStep {
  StepRequests<D> requests;          ///< before the step
  std::vector<Event> events;         ///< during the step
  std::uint64_t changed = 0;         ///< objects that came, went or got another box
  std::vector<LookChange<D>> looks;  ///< of those objects, where they differ from the step before
};

/// The range of object numbers: arrays have a place for each number up to the highest, so a number far above
/// the number of inserted objects is damage, and would take all memory.
class NumberRoom {
 public:
  /// After a keyframe with so many places.
  void restart(std::size_t bound) { places_ = bound; }
  void insert(std::uint64_t objects) { places_ += objects; }
  [[nodiscard]] bool has(ObjectId object) const {
    return object.value / kSparse < kAlways / kSparse + places_;
  }

 private:
  static constexpr std::uint64_t kAlways = 65'536;
  static constexpr std::uint64_t kSparse = 4;  ///< of so many numbers one at least is used
  std::uint64_t places_ = 0;
};

/// Writes consecutive steps into blocks. Columns of like numbers are compressed together: calls, objects,
/// lengths of differences, events; the bits of differences follow them as they are. Writing and reading
/// foretell the same numbers, however their callers' threads round.
template <int D>
class BlockEncoder {
 public:
  explicit BlockEncoder(VolumeKind kind);

  /// Call it at every keyframe, between two blocks.
  void restart(const ObjectTable<D>& latest) {
    predictor_.restart(latest);
    room_.restart(latest.bound());
    looks_.restart(looks_.looks());
  }
  /// `looks`: see LookEncoder. Returns the number of objects that came, went or got another box. Throws
  /// std::runtime_error for an object whose number is too high (see NumberRoom).
  std::uint64_t add(const StepRequests<D>& requests, std::span<const Event> events,
                    std::span<const Look<D>> looks = {});
  /// The looks of all objects after the last step.
  [[nodiscard]] Looks<D> looks() const { return looks_.looks(); }
  /// Steps since the last block.
  [[nodiscard]] std::uint32_t steps() const { return steps_; }
  /// The block of these steps.
  Bytes take();

 private:
  std::uint64_t add_volumes(const StepRequests<D>& requests);

  VolumeKind kind_;
  VolumePredictor<D> predictor_;
  NumberRoom room_;
  std::uint32_t steps_ = 0;
  ByteWriter calls_;
  ByteWriter objects_;
  ByteWriter events_;
  std::vector<Bytes> lengths_;  ///< by channel
  BitWriter bits_;
  LookEncoder<D> looks_;
};

/// Reads the blocks of BlockEncoder in their order. Throws std::runtime_error for a damaged one.
template <int D>
class BlockDecoder {
 public:
  explicit BlockDecoder(VolumeKind kind) : kind_(kind), predictor_(kind) {}

  void restart(const ObjectTable<D>& latest, const Looks<D>& looks) {
    predictor_.restart(latest);
    room_.restart(latest.bound());
    looks_.restart(looks);
  }
  /// Appends the block's steps, of which these are the rows: a block of others is damaged. It makes room for
  /// no more steps and events than they say.
  void read(std::span<const std::uint8_t> block, std::span<const StepRow> rows,
            std::vector<RecordedStep<D>>& steps);

 private:
  VolumeKind kind_;
  VolumePredictor<D> predictor_;
  NumberRoom room_;
  LookDecoder<D> looks_;
};

}  // namespace kerf
