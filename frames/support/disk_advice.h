#pragma once

#include <string>

namespace kerf {

/// The message; of a full disk, which several rooms report in the system's words, also what to do, once.
std::string with_disk_advice(std::string message);

}  // namespace kerf
