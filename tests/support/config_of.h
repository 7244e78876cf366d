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

}  // namespace kerf::test
