#pragma once

#include <map>
#include <optional>
#include <string>

#include "viz/debugger/gui/gui.h"

namespace kerf {

/// What scripts call the keys, in small letters, but for the digits.
const std::map<std::string, Key>& key_names();
/// The key of such a name, or of a digit.
std::optional<Key> key_called(const std::string& name);

}  // namespace kerf
