#include "frames/support/output_file.h"

#include <system_error>

#include "frames/support/errors.h"

namespace kerf {

void check_free(const std::filesystem::path& file, bool overwrite) {
  if (file.empty() || !std::filesystem::exists(file)) return;
  if (!overwrite)
    throw UsageError(file.string() + " exists already; choose another name, or replace it with --overwrite");
  if (!std::filesystem::is_regular_file(file))
    throw UsageError(file.string() + " is no regular file and is not replaced; choose another name");
}

void check_not_input(const std::filesystem::path& out, const std::filesystem::path& recording) {
  std::error_code ignored;
  if (std::filesystem::equivalent(out, recording, ignored))
    throw UsageError(out.string() + " is the recording itself; choose another name");
}

}  // namespace kerf
