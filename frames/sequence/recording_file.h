#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/recording/recording_reader.h"
#include "core/replay/position.h"
#include "frames/sequence/render_request.h"

namespace kerf {

/// The info of a recording of this run.
RecordingInfo recording_info(const RenderRequest& request);

/// Which of our trees was recorded, "kerf" or "kerf-paper": the one whose parameters differ least from the
/// recording's.
std::string_view tree_of(const RecordingInfo& info);

/// The caption's name for the broad phase of a recording: our tree, whatever engine moved the boxes.
std::string broad_phase_of(const RecordingInfo& info);

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
