#include "core/query/their_faults.h"

#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "core/base/counted.h"
#include "core/base/float_mode.h"
#include "core/query/their_parts.h"

namespace kerf {

template <int D>
std::vector<TheirFault> find_their_faults(Replayer<D>& replayer, const StructureLimits& limits,
                                          const std::function<bool(std::uint32_t)>& stop) {
  const DefaultFloats floats;
  using Key = std::tuple<StructureFaultKind, std::optional<GivenId>, ObjectId>;
  std::vector<TheirFault> faults;
  std::map<Key, std::size_t> known;
  const GivenNames& names = replayer.recording().info().names;
  TheirStructure<D> before;
  std::uint32_t before_step = 0;  // 0: none is known
  bool held_fixed = false;
  for (const std::uint32_t step : replayer.recording().structure_steps()) {
    if (stop && stop(step)) break;
    TheirStructure<D> structure = *replayer.recording().their_structure(step);
    replayer.seek(step);
    const ObjectTable<D>& objects = replayer.tree().objects();
    const TheirPast<D> past{before_step == 0 ? nullptr : &before, step == before_step + 1, held_fixed};
    for (StructureFault& fault : check_theirs<D>(structure, objects, names, past, limits)) {
      const auto node =
          fault.cell == kNoPart ? std::nullopt : std::optional(structure.nodes[fault.cell].name);
      const auto [found, is_new] = known.emplace(Key{fault.kind, node, fault.object}, faults.size());
      if (is_new) faults.push_back({std::move(fault), step, step, 0});
      TheirFault& same = faults[found->second];
      if (same.steps == 0 || same.last_step != step) ++same.steps;
      same.last_step = step;
    }
    held_fixed = held_fixed || holds_fixed(structure, objects);
    before = std::move(structure);
    before_step = step;
  }
  return faults;
}

std::string to_text(const TheirFault& fault, const GivenNames& names) {
  std::string text = "step " + names.step(fault.first_step) + ": " +
                     std::string(to_string(fault.fault.kind)) + ": " + fault.fault.text;
  if (fault.steps > 1)
    text += "; until step " + names.step(fault.last_step) + ", in " + counted(fault.steps, "step");
  return text;
}

template std::vector<TheirFault> find_their_faults(Replayer<2>&, const StructureLimits&,
                                                   const std::function<bool(std::uint32_t)>&);
template std::vector<TheirFault> find_their_faults(Replayer<3>&, const StructureLimits&,
                                                   const std::function<bool(std::uint32_t)>&);

}  // namespace kerf
