#include "core/bsp/mode.h"

namespace kerf {
namespace {

struct ConditionWords {
  std::string_view name;
  std::string_view meaning;
};

/// In the order of Condition.
constexpr std::array<ConditionWords, kConditionCount> kConditions{{
    {"bytes_on", "`byte_sweep` is on"},
    {"bytes_off", "`byte_sweep` is off"},
    {"skins_off", "`skin` is 0"},
    {"keeping_is_costly",
     "the last step with kept pairs cost nearly as much as sweeping all leaves, since many objects are "
     "restless"},
    {"many_leave", "for some steps in a row many objects left their fat boxes"},
    {"uproar", "very many objects left their fat boxes at once, and they are fast"},
    {"rows_pay", "for some steps in a row so little moved in so small a world that its pairs are bits"},
    {"slow_at_first", "the first motions that are known are slow"},
    {"slow_for_long",
     "for many steps in a row objects were slow; each phase of keeping that did not pay doubles the number "
     "of steps"},
}};

constexpr std::array<std::string_view, kModeCount> kModes{"ordered", "swept", "kept"};

}  // namespace

std::string_view to_string(Mode mode) { return kModes[static_cast<std::size_t>(mode)]; }
std::string_view to_string(Condition condition) {
  return kConditions[static_cast<std::size_t>(condition)].name;
}
std::string_view meaning(Condition condition) {
  return kConditions[static_cast<std::size_t>(condition)].meaning;
}

}  // namespace kerf
