#pragma once

#include <filesystem>

namespace kerf {

/// Opens a recording as a debugger does, goes to random steps and from there back step by step; prints the
/// times and the memory. Throws std::runtime_error if the recording cannot be read.
void print_replay_timings(const std::filesystem::path& file);

}  // namespace kerf
