#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/config.h"
#include "core/broad_phase/approximation.h"
#include "core/objects/broad_phase.h"

namespace kerf {

/// One setting of the knobs that trade error for time.
struct Setting {
  std::string name;    ///< as `kerf bench --algorithms` takes it
  std::string family;  ///< settings that differ in one number: a line in a plot
  Config config = tuned_config();
  Approximation how;
};

/// The exact tree, ours and the paper's, with leaves of several sizes and schedules, and then all approximate
/// modes: placement every k steps without and with a margin, filtered, and rounded intervals.
std::vector<Setting> all_settings();
/// A few of them, for runs in which the pairs decide the motion.
std::vector<Setting> few_settings();

template <int D>
std::unique_ptr<BroadPhase<D>> make_broad_phase(const Setting& setting);

}  // namespace kerf
