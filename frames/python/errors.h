#pragma once

#include <pybind11/pybind11.h>

#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace kerf::python {

/// `kerf.RecordingError`: a file that is no recording, or damaged, or cannot be written, or does not have
/// what was asked for.
class RecordingError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Calls `work`, with whatever core says of a recording as a RecordingError.
template <class Work>
auto of_recording(Work work) {
  try {
    return work();
  } catch (const pybind11::builtin_exception&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw RecordingError(error.what());
  }
}

/// Throws RecordingError if there is a file of the name that must not be replaced: before the work, not
/// after.
inline void check_free(const std::filesystem::path& out, bool overwrite) {
  if (!overwrite && std::filesystem::exists(out))
    throw RecordingError(out.string() + " exists: give another name, or overwrite=True");
}

}  // namespace kerf::python
