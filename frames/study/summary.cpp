#include "frames/study/summary.h"

#include <algorithm>

namespace kerf {
namespace {

bool is_sum(const std::string& figure) {
  return figure == "pairs" || figure == "candidates" || figure == "missed" || figure == "extra";
}

std::string title_of(const Json& settings) {
  const int grow = settings.value("grow", 0);
  return settings.value("scene", "") + " (" + settings.value("kind", "") + "), " +
         std::to_string(settings.value("dimension", 3)) + "D, " + std::to_string(settings.value("steps", 0)) +
         " steps after " + std::to_string(settings.value("warm_up", 0)) +
         (grow > 0 ? ", grown in " + std::to_string(grow) : "");
}

/// The item of the list that has these members, added at the end if there is none.
template <class Item, class Same>
Item& find_or_add(std::vector<Item>& list, Same same, const Item& fresh) {
  const auto found = std::ranges::find_if(list, same);
  if (found != list.end()) return *found;
  return list.emplace_back(fresh);
}

}  // namespace

void Group::add(const CellFile& file) {
  const auto seed = file.settings.value("seed", std::uint64_t{0});
  const double steps = file.settings.value("steps", 1.0);
  for (const Json* const part : {&file.figures.counts, &file.figures.times})
    for (const auto& [key, value] : part->items())
      if (value.is_number()) values_[key][seed].push_back(value.get<double>() / (is_sum(key) ? steps : 1));
  ++cells_;
}

std::optional<Estimate> Group::estimate(const std::string& figure) const {
  const auto found = values_.find(figure);
  if (found == values_.end()) return std::nullopt;
  std::size_t count = 0;
  for (const auto& [seed, values] : found->second) count += values.size();
  if (count != cells_) return std::nullopt;
  return estimate_of_seeds(found->second);
}

std::vector<StudyComparison> comparisons(const JoinedStudy& joined) {
  std::vector<StudyComparison> all;
  for (const JoinedStudy::Cell& cell : joined.cells) {
    if (cell.cell->is_frames()) continue;
    const Json& settings = cell.file.settings;
    const StudyComparison none{title_of(settings), settings.value("measure", ""), {}};
    const auto same_title = [&](const StudyComparison& other) {
      return other.title == none.title && other.measures == none.measures;
    };
    StudyComparison& comparison = find_or_add(all, same_title, none);
    Group fresh;
    fresh.broad_phase = settings.value("broad_phase", "");
    fresh.machine = cell.file.machine;
    fresh.objects = settings.value("objects", std::uint64_t{0});
    const auto same = [&](const Group& other) {
      return other.broad_phase == fresh.broad_phase && other.machine == fresh.machine &&
             other.objects == fresh.objects;
    };
    find_or_add(comparison.groups, same, fresh).add(cell.file);
  }
  return all;
}

}  // namespace kerf
