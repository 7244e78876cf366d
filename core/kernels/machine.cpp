#include "core/kernels/machine.h"

#include <hwy/highway.h>
#include <hwy/targets.h>

#include <cstdint>
#include <stdexcept>

namespace kerf {
namespace {

/// Compiled in and supported by this machine, the widest first; every machine supports the baseline.
std::vector<std::int64_t> targets() {
  std::vector<std::int64_t> found;
  std::int64_t rest = (hwy::SupportedTargets() & HWY_TARGETS) | HWY_STATIC_TARGET;
  for (; rest != 0; rest &= rest - 1) found.push_back(rest & -rest);
  return found;
}

std::string& chosen() {
  static std::string name;
  return name;
}

}  // namespace

std::vector<std::string> kernels() {
  std::vector<std::string> names;
  for (const std::int64_t target : targets()) names.emplace_back(hwy::TargetName(target));
  return names;
}

std::string kernel() { return chosen().empty() ? kernels().front() : chosen(); }

void use_kernel(std::string_view name) {
  if (name.empty()) {
    hwy::GetChosenTarget().DeInit();
    chosen().clear();
    return;
  }
  std::string known;
  for (const std::int64_t target : targets()) {
    known += (known.empty() ? "" : ", ") + std::string(hwy::TargetName(target));
    if (name != hwy::TargetName(target)) continue;
    hwy::GetChosenTarget().Update(target);
    chosen() = name;
    return;
  }
  throw std::invalid_argument("no kernel '" + std::string(name) + "' on this machine; there are " + known);
}

}  // namespace kerf
