#pragma once

#include <filesystem>
#include <list>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/bsp/bsp_state.h"
#include "core/recording/block_codec.h"
#include "core/recording/database.h"
#include "core/recording/operator_rows.h"
#include "core/recording/recorded_rows.h"
#include "core/recording/recording_info.h"
#include "core/recording/their_structure.h"
#include "core/tree/projector.h"

namespace kerf {

/// The sizes of the parts of a recording, in bytes.
struct RecordingSize {
  std::uint64_t blocks = 0;
  std::uint64_t keyframes = 0;
  std::uint64_t changed = 0;  ///< boxes that changed, in all steps; blocks / changed is the cost of each
};

/// Reads the info of a recording of any dimension. Throws std::runtime_error as `open_recording` does.
RecordingInfo read_recording_info(const std::filesystem::path& path);

/// Reads a recording, also one that is still being written or was cut short: it sees what is there when it is
/// opened. Everything throws std::runtime_error, with the file where it is known, for damaged or changed
/// content.
template <int D>
class RecordingReader {
 public:
  explicit RecordingReader(const std::filesystem::path& path);
  /// The same, but also opens a recording with changed rows, for callers that examine them.
  static std::unique_ptr<RecordingReader> open_changed(const std::filesystem::path& path);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const RecordingInfo& info() const { return info_; }
  /// Complete steps; they count from 1.
  [[nodiscard]] std::uint32_t steps() const { return static_cast<std::uint32_t>(rows_.steps.size()); }
  /// One row for each step, the first being step 1.
  [[nodiscard]] std::span<const StepRow> rows() const { return rows_.steps; }
  /// Pre: 1 <= step <= steps().
  [[nodiscard]] const StepRow& row(std::uint32_t step) const { return rows_.steps[step - 1]; }
  /// The place where its rows are no longer as written.
  [[nodiscard]] const std::optional<ChangedPart>& change() const { return chain_.change; }
  /// The end of its chain: equal for copies of one recording. Two runs differ, since steps have their times.
  [[nodiscard]] std::uint64_t chain_end() const { return chain_.end; }
  /// See `find_added`.
  [[nodiscard]] std::optional<ChangedPart> added() const;
  /// The step in which an event happened; none if it is beyond the end.
  [[nodiscard]] std::optional<std::uint32_t> step_of(std::uint64_t event) const;

  /// Requests and events of a step. Valid until another step is read.
  const RecordedStep<D>& step(std::uint32_t step);
  /// Throws std::runtime_error for an id that the recording does not have.
  Event event(std::uint64_t id);
  /// See `read_operators`.
  [[nodiscard]] std::vector<OperatorRow> operators() const {
    return read_operators(database_, rows_.steps, info_.names);
  }
  /// Steps that have a keyframe, in order; step 0, which needs none, is not among them.
  [[nodiscard]] std::span<const KeyframeRow> keyframes() const { return rows_.keyframes; }
  [[nodiscard]] bool has_keyframe(std::uint32_t step) const;
  /// The last step up to `step` that has a keyframe; 0 if none has.
  [[nodiscard]] std::uint32_t keyframe_before(std::uint32_t step) const;
  /// The shapes of all objects, by their numbers in Look; none if they were not recorded. Valid as long as
  /// the reader.
  [[nodiscard]] const std::vector<Shape<D>>& shapes() const;
  /// How many there are, without a look at them.
  [[nodiscard]] std::size_t shape_count() const { return rows_.shapes.size(); }
  /// The looks of all objects after a step that has a keyframe.
  [[nodiscard]] Looks<D> keyframe_looks(std::uint32_t step) const;
  /// A keyframe for a tree with this projector.
  [[nodiscard]] BspState<D> keyframe(std::uint32_t step, std::shared_ptr<const Projector<D>> projector) const;

  /// Another engine's pairs of a step, as reported; none unless the recording is an import.
  [[nodiscard]] std::vector<Pair> their_pairs(std::uint32_t step) const;
  [[nodiscard]] std::optional<TheirStep> their_step(std::uint32_t step) const;
  /// Whether it has another engine's pairs, but not those of this step: a writer was killed before they came.
  [[nodiscard]] bool lacks_their_pairs(std::uint32_t step) const;
  /// Of all steps at once, each compared with its seal.
  [[nodiscard]] std::vector<std::pair<std::uint32_t, TheirStep>> their_steps() const;
  /// Those of them that are not right, those that they missed, and what they leave out by design.
  [[nodiscard]] std::vector<JudgedPair> judged_pairs(std::uint32_t step) const;
  [[nodiscard]] TheirChanges<D> their_changes(std::uint32_t step) const;
  /// The box as it was given up to a step, where floats do not hold it.
  [[nodiscard]] std::optional<GivenBox<D>> given_box(ObjectId object, std::uint32_t step) const;
  [[nodiscard]] bool has_filters() const;
  [[nodiscard]] std::optional<GivenFilter> filter(ObjectId object, std::uint32_t step) const;
  /// Another engine's structure after a step; none if it is not known.
  [[nodiscard]] std::optional<TheirStructure<D>> their_structure(std::uint32_t step) const;
  /// The steps that have one, rising; every step is compared with its seal.
  [[nodiscard]] std::vector<std::uint32_t> structure_steps() const;
  [[nodiscard]] RecordingSize size() const;
  /// Throws std::runtime_error if a step's data of another engine is not as written.
  void check_theirs(std::uint32_t step) const;
  /// Throws std::runtime_error if SQLite finds a fault in any page of the file, or if the file has other
  /// bytes beside its pages.
  void check_pages() const;

 private:
  /// The steps from one keyframe to the next, decoded.
  struct Span {
    std::uint32_t first = 0;
    std::vector<RecordedStep<D>> steps;
  };
  static constexpr std::size_t kSpans = 3;

  struct AsItIs {};
  RecordingReader(const std::filesystem::path& path, AsItIs /*even if changed*/);

  /// What is written of a keyframe.
  struct KeyframeBytes {
    Bytes tree;
    Bytes looks;
  };

  [[nodiscard]] KeyframeBytes keyframe_bytes(std::uint32_t step) const;
  [[nodiscard]] Looks<D> decode_looks(std::uint32_t step, const KeyframeBytes& bytes,
                                      std::size_t bound) const;
  void check_look(const Look<D>& look, std::uint32_t step) const;
  void read_block(BlockDecoder<D>& decoder, const BlockRow& block, Span& span) const;
  [[nodiscard]] Span read_span(std::uint32_t keyframe) const;
  void check_theirs_up_to(std::uint32_t step) const;
  void check_all_theirs(bool is_any) const;

  std::filesystem::path path_;
  Database database_;
  RecordingInfo info_;
  RecordedRows rows_;
  FollowedChain chain_;
  std::list<Span> spans_;                                ///< latest used first
  mutable std::optional<std::vector<Shape<D>>> shapes_;  ///< none: not read yet
  mutable std::uint32_t theirs_checked_ = 0;  ///< up to this step another engine's rows are as written
  mutable std::uint32_t theirs_asked_ = 0;    ///< and in this one
};

}  // namespace kerf
