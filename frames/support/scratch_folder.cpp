#include "frames/support/scratch_folder.h"

#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>

namespace kerf {

ScratchFolder::ScratchFolder(const std::filesystem::path& parent) {
  std::string name = (parent / "kerf-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw std::runtime_error("cannot make the folder " + name + ": " +
                             std::generic_category().message(errno));
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace kerf
