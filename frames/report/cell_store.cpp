#include "frames/report/cell_store.h"

#include <fstream>
#include <utility>

#include "frames/atomic_file.h"
#include "frames/bench/machine.h"

namespace kerf {
namespace {

/// Whose figures these are: the processor's and this very program's.
std::string owner() {
  const auto built = std::filesystem::last_write_time("/proc/self/exe").time_since_epoch().count();
  return describe_machine().value("processor", "") + ", kerf " KERF_VERSION ", " + std::to_string(built);
}

}  // namespace

CellStore::CellStore(std::filesystem::path file) : file_(std::move(file)) {
  std::ifstream stream(file_);
  const Json kept = Json::parse(stream, nullptr, false);
  if (!kept.is_object() || kept.value("owner", "") != owner()) return;
  if (kept.contains("cells") && kept["cells"].is_object()) results_ = kept["cells"];
}

void CellStore::put(const std::string& key, Json result) {
  results_[key] = std::move(result);
  constexpr int kIndent = 1;
  write_file_atomically(file_, Json{{"owner", owner()}, {"cells", results_}}.dump(kIndent) + "\n");
}

}  // namespace kerf
