#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/recording/recording_reader.h"
#include "core/replay/position.h"
#include "frames/sequence/render_request.h"

namespace kerf {

/// What a recording of this run is of.
RecordingInfo recording_info(const RenderRequest& request);

/// Which of our trees was recorded, "kerf" or "kerf-paper": a recording has its parameters, and its tree is
/// the one of which fewer of them were changed.
std::string_view tree_of(const RecordingInfo& info);

/// How captions call what found the pairs of a recording: our tree, in whatever engine the boxes moved.
std::string broad_phase_of(const RecordingInfo& info);

/// Throws UsageError if the name of a new recording is taken, unless `overwrite` is given and a recording has
/// it.
void check_recording_path(const std::filesystem::path& path, bool overwrite);
/// Makes room for a new recording: checks the same and removes the one that has the name. For whoever has
/// read all that he needs; PartRecording keeps the old one until the new one is complete.
void clear_recording_path(const std::filesystem::path& path, bool overwrite);

/// Opens a recording of either dimension and calls `work` with its reader. Throws std::runtime_error as
/// RecordingReader does.
template <class Work>
auto with_recording(const std::filesystem::path& path, Work work) {
  if (read_recording_info(path).dimension == 2) return work(std::make_shared<RecordingReader<2>>(path));
  return work(std::make_shared<RecordingReader<3>>(path));
}

/// "17" is the end of step 17, "e1234" the moment after that event. Throws UsageError for anything else.
template <int D>
Position parse_position(const std::string& option, const std::string& text,
                        const RecordingReader<D>& recording);

}  // namespace kerf
