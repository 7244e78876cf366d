#pragma once

#include "core/base/config.h"
#include "tests/fuzz/tree/byte_reader.h"

namespace kerf::test {

/// The configuration with which fuzz cases begin: small thresholds and generous limits, so that few objects
/// make a deep tree.
Config small_tree_config();

/// Changes one parameter to a value within its range. Never those that a living tree cannot change.
void change_parameter(Config& config, ByteReader& bytes);

}  // namespace kerf::test
