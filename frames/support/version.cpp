#include "frames/support/version.h"

#include <cstdint>

#include "core/files/whole_file.h"
#include "core/recording/chain.h"
#include "core/recording/recording_info.h"

namespace kerf {

const char* version() { return KERF_VERSION; }

const std::string& build_id() {
  static const std::string kId = [] {
    const std::string program = read_whole_file("/proc/self/exe");
    return to_hex(hash_bytes({reinterpret_cast<const std::uint8_t*>(program.data()), program.size()}, 0));
  }();
  return kId;
}

}  // namespace kerf
