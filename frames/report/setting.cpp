#include "frames/report/setting.h"

#include <algorithm>

#include "core/broad_phase/approximate.h"
#include "core/bsp/bsp.h"

namespace kerf {
namespace {

Setting tree(const std::string& name, const std::string& family, const std::string& assignments = "") {
  Setting setting{name, family, tuned_config(), {}};
  kerf::apply(setting.config, assignments);
  return setting;
}

Setting approximate(const std::string& family, const std::string& assignments) {
  Setting setting{"kerf:" + assignments, family, tuned_config(), {}};
  std::replace(setting.name.begin(), setting.name.end(), ',', ':');
  kerf::apply(setting.how, assignments);
  return setting;
}

void add_exact(std::vector<Setting>& settings) {
  settings.push_back(tree("kerf", "exact: ours"));
  settings.push_back({"kerf-paper", "exact: the paper's", Config{}, {}});
  for (const char* leaf : {"64", "1024"})
    settings.push_back(tree("kerf:min_threshold=" + std::string(leaf) + ":max_threshold=" + leaf,
                            "exact: other leaf sizes, schedules",
                            "min_threshold=" + std::string(leaf) + ",max_threshold=" + leaf));
  for (const char* interval : {"1", "40"})
    settings.push_back(tree("kerf:schedule_interval=" + std::string(interval),
                            "exact: other leaf sizes, schedules",
                            "schedule_interval=" + std::string(interval)));
}

void add_periods(std::vector<Setting>& settings, const std::string& family, const std::string& more) {
  for (const char* period : {"2", "4", "8"})
    settings.push_back(approximate(family, "period=" + std::string(period) + more));
}

}  // namespace

std::vector<Setting> all_settings() {
  std::vector<Setting> settings;
  add_exact(settings);
  add_periods(settings, "every k steps", "");
  add_periods(settings, "every k steps, margin 0.1", ",margin=0.1");
  add_periods(settings, "every k steps, margin 0.3", ",margin=0.3");
  add_periods(settings, "every k steps, margin 0.3, filtered", ",margin=0.3,filter=1");
  for (const char* grid : {"0.05", "0.2", "0.5"})
    settings.push_back(approximate("rounded to a grid", "grid=" + std::string(grid)));
  for (const char* grid : {"0.02", "0.05", "0.2"})
    settings.push_back(approximate("rounded inward", "grid=" + std::string(grid) + ",shrink=1"));
  return settings;
}

std::vector<Setting> few_settings() {
  return {approximate("every k steps", "period=2"), approximate("every k steps", "period=4"),
          approximate("every k steps, margin", "period=4,margin=0.3"),
          approximate("rounded to a grid", "grid=0.2"), approximate("rounded inward", "grid=0.05,shrink=1")};
}

template <int D>
std::unique_ptr<BroadPhase<D>> make_broad_phase(const Setting& setting) {
  auto exact = std::make_unique<Bsp<D>>(setting.config);
  if (setting.how == Approximation{}) return exact;
  return std::make_unique<Approximate<D>>(std::move(exact), setting.how);
}

template std::unique_ptr<BroadPhase<2>> make_broad_phase<2>(const Setting&);
template std::unique_ptr<BroadPhase<3>> make_broad_phase<3>(const Setting&);

}  // namespace kerf
