#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "core/recording/recording_info.h"
#include "core/scene/scene.h"

namespace kerf {

/// A run of a scene that is recorded.
template <int D>
struct RunToRecord {
  const SceneEntry<D>& entry;
  SceneOptions options;
  RecordingInfo info;  ///< with parameters and volume of the tree; see `info_of_run`
  std::uint32_t steps = 0;
};

/// How far a run came, and what recording it took.
struct RunSoFar {
  std::uint32_t steps = 0;
  double recording = 0;  ///< seconds
};

/// The info of a recording of a scene, with the name that the scene has in the program.
RecordingInfo info_of_run(const std::string& scene, int dimension, const SceneOptions& options,
                          const Config& config, VolumeKind volume);

/// Runs the scene with the tree and records it, with the shapes of its bodies, into `file`, which is closed
/// then. Ends early if `go_on`, called after each step with its number, is false. Throws as Recorder does.
template <int D>
RunSoFar record_run(const RunToRecord<D>& run, const std::filesystem::path& file,
                    const std::function<bool(std::uint32_t)>& go_on);

}  // namespace kerf
