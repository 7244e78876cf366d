#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace kerf {

/// How the pairs of a step are found (docs/MODES.md).
enum class Mode : std::uint8_t {
  ordered,  ///< the paper's: each leaf is swept along its ordered list
  swept,    ///< each leaf is swept by vectors of bytes; in a small world of which little moves, rows of bits
  kept,     ///< pairs of fat boxes are kept and filtered: the tree's table has the fat boxes
};
inline constexpr std::size_t kModeCount = 3;

std::string_view to_string(Mode mode);

/// Why the mode changes. `meaning` says it in words.
enum class Condition : std::uint8_t {
  bytes_on,
  bytes_off,
  skins_off,
  keeping_is_costly,
  many_leave,
  uproar,
  rows_pay,
  slow_at_first,
  slow_for_long,
};
inline constexpr std::size_t kConditionCount = 9;

std::string_view to_string(Condition condition);
std::string_view meaning(Condition condition);

struct Transition {
  Mode from;
  Mode to;
  Condition condition;
  friend constexpr bool operator==(const Transition&, const Transition&) = default;
};

/// All transitions. Before each step the first one from the present mode whose condition holds is taken; if
/// none does, the mode stays.
inline constexpr std::array kTransitions{
    Transition{Mode::ordered, Mode::swept, Condition::bytes_on},
    Transition{Mode::swept, Mode::ordered, Condition::bytes_off},
    Transition{Mode::swept, Mode::kept, Condition::slow_at_first},
    Transition{Mode::swept, Mode::kept, Condition::slow_for_long},
    Transition{Mode::kept, Mode::ordered, Condition::bytes_off},
    Transition{Mode::kept, Mode::swept, Condition::skins_off},
    Transition{Mode::kept, Mode::swept, Condition::rows_pay},
    Transition{Mode::kept, Mode::swept, Condition::keeping_is_costly},
    Transition{Mode::kept, Mode::swept, Condition::many_leave},
    Transition{Mode::kept, Mode::swept, Condition::uproar},
};

}  // namespace kerf
