#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/query/structure_check.h"
#include "core/replay/replayer.h"

namespace kerf {

/// Something wrong with another engine's structure, of which it may be so in many steps.
struct TheirFault {
  StructureFault fault;  ///< as it was in the first of these steps
  std::uint32_t first_step = 0;
  std::uint32_t last_step = 0;
  std::uint32_t steps = 0;  ///< in how many, from the first to the last
};

/// All of a recording, by their first steps. `stop`: called with each step; true ends the search.
template <int D>
std::vector<TheirFault> find_their_faults(Replayer<D>& replayer, const StructureLimits& limits,
                                          const std::function<bool(std::uint32_t)>& stop = {});

/// "step 7: child outside its parent: n12 lies outside ...; until step 9, in 3 steps"
std::string to_text(const TheirFault& fault, const GivenNames& names);

}  // namespace kerf
