#include "frames/support/disk_advice.h"

#include <system_error>

namespace kerf {

std::string with_disk_advice(std::string message) {
  const std::string advice = "; free some space or choose another place";
  const bool full = message.find(std::generic_category().message(ENOSPC)) != std::string::npos;
  if (full && message.find(advice) == std::string::npos) message += advice;
  return message;
}

}  // namespace kerf
