#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

#include "core/replay/replayer.h"

namespace kerf {

/// Runs with a difference. A rerun is a recording of its own, so one what-if can follow another; each must
/// come after those that the recording already has, since later events then have other numbers.

/// Adds a decision to `info`: the operator of `event` does not act or, with `candidate`, an index in the
/// event's ballot, its split uses that partitioner. Throws std::invalid_argument, with the reason, where
/// there is nothing to decide, std::runtime_error if there is no such event.
template <int D>
void decide(RecordingInfo& info, Replayer<D>& replayer, std::uint64_t event,
            std::optional<std::size_t> candidate = std::nullopt);

/// Another configuration from a step on; from 1 on, in the whole run. Throws std::invalid_argument if the
/// recording has decisions or changes from that step on.
template <int D>
void change_config(RecordingInfo& info, const RecordingReader<D>& recording, std::uint32_t step,
                   const Config& config);

/// Runs a recording's requests again, as `info` says, and records that. False if `stop` returned true; the
/// steps so far are kept. Within a step of an import it is asked, too: then the file is as if the program was
/// killed. Throws as Recorder does (CannotWrite leaves the file as far as it came), and std::runtime_error,
/// leaving no file, if a decision had no effect.
template <int D>
bool rerun(RecordingReader<D>& recording, const RecordingInfo& info, const std::filesystem::path& out,
           const std::function<bool()>& stop = {});

}  // namespace kerf
