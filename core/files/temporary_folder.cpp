#include "core/files/temporary_folder.h"

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>

namespace kerf {

std::filesystem::path temporary_folder() {
  std::error_code error;
  std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if (!error) return folder;
  const char* const given = std::getenv("TMPDIR");
  throw std::runtime_error("temporary files go to TMPDIR, which is '" +
                           std::string(given == nullptr ? "" : given) + "': " + error.message() +
                           "; set it to a folder that is there, or unset it");
}

}  // namespace kerf
