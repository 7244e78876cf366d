#pragma once

#include <string_view>

#include "core/base/config.h"

namespace kerf::test {

/// The paper's configuration with "K=V,K=V,..." applied.
inline Config config_of(std::string_view assignments) {
  Config config;
  kerf::apply(config, assignments);
  return config;
}

/// Our configuration with so many objects in a leaf.
inline Config tuned_with_leaves_of(std::uint32_t objects) {
  Config config = tuned_config();
  config.min_threshold = config.max_threshold = objects;
  return config;
}

}  // namespace kerf::test
