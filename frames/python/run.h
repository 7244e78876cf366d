#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/bsp/bsp.h"
#include "core/recording/recorder.h"
#include "frames/sequence/part_recording.h"

namespace kerf::python {

/// A tree, and the recording of what it is asked, if one is wanted.
template <int D>
class Run {
 public:
  /// Throws std::invalid_argument for a configuration that cannot work, std::runtime_error if the recording
  /// cannot be written. `record` may be empty; `overwrite`: it may take an earlier recording's place.
  Run(const Config& config, const std::filesystem::path& record, bool overwrite);
  /// A recording that was not closed is kept as far as it came, if it has a step; what keeps it from that is
  /// lost.
  ~Run();
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// What takes the requests. Throws std::runtime_error after `close`, and after a change that was left
  /// half-made.
  [[nodiscard]] BroadPhase<D>& broad_phase();
  /// Calls `change(broad_phase())`, which makes so many requests. An exception leaves the change half-made.
  template <class Change>
  void change(std::size_t requests, Change change) {
    BroadPhase<D>& changed = broad_phase();
    is_torn_ = true;
    change(changed);
    is_torn_ = false;
    requests_ += requests;
  }
  /// Throws RecordingError if the recording cannot be written (PartRecording::write).
  void step();
  void set_threads(unsigned threads);
  /// What the recording does not have, in words: requests after the last step. Empty: nothing.
  [[nodiscard]] std::string left_out() const;
  /// Ends the recording, which then has its name. Throws as `step` does.
  void close();

  [[nodiscard]] const Tree<D>& tree() const {
    return visit([](const auto& bsp) -> const Tree<D>& { return bsp.tree(); });
  }
  [[nodiscard]] const ObjectTable<D>& objects() const {
    return visit([](const auto& bsp) -> const ObjectTable<D>& { return bsp.objects(); });
  }
  [[nodiscard]] Statistics statistics() const {
    return visit([](const auto& bsp) { return bsp.statistics(); });
  }
  [[nodiscard]] std::uint32_t steps() const {
    return visit([](const auto& bsp) { return bsp.steps(); });
  }
  [[nodiscard]] std::span<const Pair> pairs() const {
    return visit([](const auto& bsp) { return bsp.pairs(); });
  }
  /// As Bsp::exchange_pairs.
  void exchange_pairs(PairBuffer& buffer);

 private:
  /// It is built beside its final name, and gets that when it is complete.
  struct Recorded {
    Recorded(const Config& config, const std::filesystem::path& path, bool overwrite);
    PartRecording part;
    Bsp<D, EventLog> bsp;
    std::optional<Recorder<D>> recorder;  ///< none: the recording is complete, or could not be written
  };
  /// Calls `work`, which writes the recording.
  template <class Work>
  void write(Work work);

  template <class Ask>
  [[nodiscard]] decltype(auto) visit(Ask ask) const {
    return recorded_ ? ask(recorded_->bsp) : ask(*quiet_);
  }

  std::unique_ptr<Bsp<D>> quiet_;
  std::unique_ptr<Recorded> recorded_;
  bool is_torn_ = false;
  std::size_t requests_ = 0;  ///< since the last step
};

}  // namespace kerf::python
