#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/recording/recording_writer.h"

namespace kerf {

/// Stands between a scene and its tree and records everything: requests, events, and the tree after each
/// step. The tree must be new, and all requests must go through the recorder; decisions and changes of the
/// configuration (RecordingInfo) reach it here.
///
/// `step()` throws std::runtime_error if the recording cannot be written, std::invalid_argument for an
/// impossible decision or change (see Bsp::decide and Bsp::set_config).
template <int D>
class Recorder final : public BroadPhase<D> {
 public:
  /// `tree` must live as long as the recorder. Throws std::runtime_error if the file cannot be made or has
  /// content, std::invalid_argument for an impossible decision of `info`.
  Recorder(Bsp<D, EventLog>& tree, const std::filesystem::path& path, const RecordingInfo& info);

  [[nodiscard]] std::string_view name() const override { return tree_.name(); }
  [[nodiscard]] VolumeKind volume_kind() const override { return tree_.volume_kind(); }
  Status insert(ObjectId object, const Box<D>& box, Mobility mobility) override;
  Status insert(ObjectId object, const Volume<D>& volume, Mobility mobility) override;
  Status move(ObjectId object, const Box<D>& box) override;
  Status move(ObjectId object, const Volume<D>& volume) override;
  Status move_many(std::span<const ObjectId> objects, std::span<const Box<D>> boxes) override;
  Status remove(ObjectId object) override;
  void step() override;
  [[nodiscard]] std::span<const Pair> pairs() const override { return tree_.pairs(); }

  /// Also records how objects look: `step()` asks for each object that was inserted or moved since the last
  /// one. Call it before the first step. The bodies of a scene are asked like this:
  /// `recorder.show([&](ObjectId object) { return appearance_of(scene->bodies()[object.index()]); })`.
  void show(std::function<Appearance<D>(ObjectId)> appearance) { appearance_ = std::move(appearance); }
  /// Also keeps what belongs to another engine's last step: see RecordingWriter.
  void add_theirs(const TheirChanges<D>& changes) { writer_.add(changes); }
  void add_theirs(std::span<const Pair> pairs, std::span<const JudgedPair> judged) {
    writer_.add(pairs, judged);
  }
  void add_theirs(const TheirStructure<D>& structure) { writer_.add(structure); }
  /// Completes the file. Throws std::runtime_error if it cannot be written. Nothing may be asked of the
  /// recorder afterwards.
  void finish();
  /// The cost of recording so far.
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  void know(ObjectId object, bool present);
  [[nodiscard]] bool knows(ObjectId object) const {
    return object.index() < known_.size() && known_[object.index()];
  }
  void record();
  [[nodiscard]] std::span<const Look<D>> find_looks();
  [[nodiscard]] Look<D> look_of(ObjectId object, const Appearance<D>& appearance);
  void count_seconds(std::chrono::steady_clock::time_point since);
  [[nodiscard]] std::span<const Event> events_of_step() const;
  [[nodiscard]] bool rested(std::span<const Event> events) const;

  Bsp<D, EventLog>& tree_;
  RecordingInfo info_;
  RecordingWriter<D> writer_;
  StepRequests<D> requests_;
  std::vector<bool> known_;  ///< by object: it is present
  std::function<Appearance<D>(ObjectId)> appearance_;
  std::vector<std::uint32_t> shapes_;  ///< by object, as it was last recorded
  std::vector<Look<D>> looks_;         ///< of the step's requests
  std::uint64_t next_event_ = 0;
  std::uint64_t state_hash_ = 0;  ///< of the last step
  std::uint64_t pairs_hash_ = 0;
  double seconds_ = 0;
};

extern template class Recorder<2>;
extern template class Recorder<3>;

}  // namespace kerf
