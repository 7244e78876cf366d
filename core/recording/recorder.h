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
/// configuration (RecordingInfo) reach it here. It computes as a program begins with, whatever its caller has
/// chosen (DefaultFloats), and so does what it calls back.
///
/// Everything throws std::runtime_error if the recording cannot be written. After any exception of a request
/// or step the recording ends with what was committed before, which can be read when the recorder is gone:
/// nothing more is written, and all further calls throw.
template <int D>
class Recorder final : public BroadPhase<D> {
 public:
  /// `tree` must live as long as the recorder. Throws std::runtime_error if the file cannot be made or has
  /// content, std::invalid_argument for an impossible decision of `info`, if dimension, volume or
  /// configuration are not the tree's, or if the tree has had a step or an object; then it leaves no file.
  Recorder(Bsp<D, EventLog>& tree, const std::filesystem::path& path, const RecordingInfo& info);

  [[nodiscard]] std::string_view name() const override { return tree_.name(); }
  [[nodiscard]] VolumeKind volume_kind() const override { return tree_.volume_kind(); }
  Status insert(ObjectId object, const Box<D>& box, Mobility mobility) override;
  Status insert(ObjectId object, const Volume<D>& volume, Mobility mobility) override;
  Status move(ObjectId object, const Box<D>& box) override;
  Status move(ObjectId object, const Volume<D>& volume) override;
  Status move_many(std::span<const ObjectId> objects, std::span<const Box<D>> boxes) override;
  Status remove(ObjectId object) override;
  /// Also throws std::invalid_argument for an impossible change of the configuration (Bsp::set_config), and
  /// if the tree took a step or another configuration without the recorder.
  void step() override;
  [[nodiscard]] std::span<const Pair> pairs() const override { return tree_.pairs(); }

  /// Also records how objects look: `step()` asks for each object that was inserted or moved since the last
  /// one. Call it before the first step. The bodies of a scene are asked like this:
  /// `recorder.show([&](ObjectId object) { return appearance_of(scene->bodies()[object.index()]); })`.
  void show(std::function<Appearance<D>(ObjectId)> appearance) { appearance_ = std::move(appearance); }
  /// Also keeps what belongs to another engine's last step: see RecordingWriter.
  void add_theirs(const TheirChanges<D>& changes);
  void add_theirs(std::span<const Pair> pairs, std::span<const JudgedPair> judged);
  void add_theirs(const TheirStructure<D>& structure);
  /// Completes the file. All further calls throw std::runtime_error.
  void finish();
  /// The cost of recording so far.
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  class Change;
  template <class Ask, class Write>
  Status request(Ask ask, Write write);
  void add_moves_of_known(std::span<const ObjectId> objects, std::span<const Box<D>> boxes);
  void check_open() const;
  void check_alone() const;
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
  std::uint32_t steps_ = 0;  ///< recorded
  bool has_ended_ = false;   ///< finished, or a change was left half-made
  double seconds_ = 0;
};

}  // namespace kerf
