#include "frames/report/cell_store.h"

#include <fstream>
#include <utility>

#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"
#include "frames/support/machine.h"
#include "frames/support/version.h"

namespace kerf {
namespace {

/// The owner of the figures: this processor and this very program.
std::string owner() {
  const auto built = std::filesystem::last_write_time("/proc/self/exe").time_since_epoch().count();
  return describe_machine().value("processor", "") + ", kerf " + version() + ", " + std::to_string(built);
}

/// Whether `put` has written it, on any machine.
bool is_ours(const Json& json) {
  return json.is_object() && json.size() == 2 && json.contains("owner") && json["owner"].is_string() &&
         json.contains("cells") && json["cells"].is_object();
}

}  // namespace

CellStore::CellStore(std::filesystem::path file, bool forget) : file_(std::move(file)) {
  if (!std::filesystem::exists(file_)) return;
  std::ifstream stream(file_);
  const Json kept = Json::parse(stream, nullptr, false);
  if (!is_ours(kept))
    throw UsageError(file_.string() +
                     " would keep the figures, and holds something else; choose another name with --out, or "
                     "move that file away");
  if (kept["owner"] == owner()) {
    results_ = kept["cells"];
  } else if (!forget) {
    throw UsageError(
        file_.string() +
        " holds figures of another machine or another build of kerf; choose another name with --out, or "
        "measure anew with --overwrite");
  }
}

void CellStore::put(const std::string& key, Json result) {
  results_[key] = std::move(result);
  constexpr int kIndent = 1;
  write_file_atomically(file_, Json{{"owner", owner()}, {"cells", results_}}.dump(kIndent) + "\n");
}

}  // namespace kerf
