#pragma once

#include <string>
#include <string_view>

#include "core/base/config.h"

namespace kerf {

/// `defaults` with the changes "K=V,K=V,...". Throws UsageError, which begins with the option's name,
/// suggests a parameter for an unknown one, and says what is allowed.
Config parse_config(std::string_view option, const std::string& text, const Config& defaults);

}  // namespace kerf
