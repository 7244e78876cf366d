#pragma once

#include <pybind11/pybind11.h>

#include <filesystem>
#include <stdexcept>

#include "frames/support/errors.h"
#include "frames/support/outputs.h"

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

/// Throws RecordingError, before the work, not after, if no recording can be put there: what is there is not
/// to be replaced, is no recording, or is `read` by the same call.
inline void check_recording(const std::filesystem::path& out, bool overwrite,
                            const std::filesystem::path& read = {}) {
  of_recording([&] {
    if (out.empty()) throw UsageError("the name of the recording is empty");
    Outputs({read}, overwrite, " exists: give another name, or overwrite=True").add_recording(out);
  });
}

}  // namespace kerf::python
