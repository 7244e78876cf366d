#pragma once

#include <chrono>
#include <filesystem>
#include <span>

#include "core/bsp/bsp_state.h"
#include "core/recording/block_codec.h"
#include "core/recording/chain.h"
#include "core/recording/database.h"
#include "core/recording/recording_info.h"
#include "core/recording/shape_rows.h"
#include "core/recording/their_structure.h"

namespace kerf {

/// Writes a recording (docs/RECORDING.md). It commits at least once a second and every 25 steps, an import
/// when all that another engine has of the last step is there; committed data remains whatever happens to the
/// program. Throws std::runtime_error with the file and the reason, a full disk for example; then nothing may
/// be asked of it any more. Its fields are what is under way between two commits.
template <int D>
class RecordingWriter {
 public:
  /// Throws if the file exists and is not empty. Leaves no file behind when it throws.
  RecordingWriter(const std::filesystem::path& path, const RecordingInfo& info);

  /// `looks`: one for each of the requests' objects, with the numbers of `shapes()`; empty if nothing is
  /// known of any object, in the whole recording.
  void add(const StepRequests<D>& requests, std::span<const Event> events, StepRow row,
           std::span<const Look<D>> looks = {});
  /// Shapes that get their number here are written with the next step.
  [[nodiscard]] ShapeNumbers<D>& shapes() { return shapes_; }
  /// True if a keyframe should follow the last step.
  [[nodiscard]] bool wants_keyframe() const;
  void add(const BspState<D>& keyframe);
  /// What another engine's last step changes for the judgement of its pairs.
  void add(const TheirChanges<D>& changes);
  /// Its pairs of the last step, as it reported them, and the verdicts on those that are not right.
  void add(std::span<const Pair> their_pairs, std::span<const JudgedPair> judged);
  /// Its structure after the last step.
  void add(const TheirStructure<D>& structure);
  /// Ends the recording: it is complete then.
  void finish();
  /// The last step that remains whatever happens.
  [[nodiscard]] std::uint32_t committed() const { return committed_; }

 private:
  void put(const StepRow& row);
  std::uint64_t put(std::span<const Event> events);
  void put_new_shapes();
  void seal_theirs();
  void flush();
  void commit();

  Database database_;
  Chain chain_;
  Statement put_step_;
  Statement put_event_;
  Statement put_block_;
  Statement put_keyframe_;
  BlockEncoder<D> encoder_;
  ShapeNumbers<D> shapes_;
  std::uint32_t step_ = 0;
  std::uint32_t committed_ = 0;
  std::uint64_t changed_ = 0;         ///< since the last block
  std::uint64_t since_keyframe_ = 0;  ///< the cost of replaying the steps, in objects at rest
  std::uint32_t last_keyframe_ = 0;
  bool awaits_theirs_;  ///< a step is followed by data of another engine
  bool commits_later_ = false;
  bool has_theirs_ = false;  ///< data of another engine was written after the last step
  std::chrono::steady_clock::time_point last_flush_;
};

}  // namespace kerf
