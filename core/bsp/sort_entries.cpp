#include <algorithm>

#include "core/base/tuning.h"
#include "core/bsp/ordered_sweep.h"

namespace kerf {
namespace {

bool before(const Entry& a, const Entry& b) {
  return a.key.lo != b.key.lo ? a.key.lo < b.key.lo : a.object < b.object;
}

/// Insertion sort that gives up once it has moved more than `limit` entries; true if it finished.
bool insertion_sort(std::vector<Entry>& entries, std::size_t limit) {
  std::size_t moved = 0;
  for (std::size_t i = 1; i < entries.size(); ++i) {
    if (!before(entries[i], entries[i - 1])) continue;
    const Entry entry = entries[i];
    std::size_t k = i;
    for (; k > 0 && before(entry, entries[k - 1]); --k) entries[k] = entries[k - 1];
    entries[k] = entry;
    moved += i - k;
    if (moved > limit) return false;
  }
  return true;
}

}  // namespace

void sort_entries(std::vector<Entry>& entries) {
  if (!insertion_sort(entries, tuning::kMovesPerEntry * entries.size()))
    std::sort(entries.begin(), entries.end(), before);
}

}  // namespace kerf
