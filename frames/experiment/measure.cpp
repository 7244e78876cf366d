#include "frames/experiment/measure.h"

#include <array>

namespace kerf {
namespace {

constexpr std::array<MeasureTraits, 18> kTraits{
    {{"frames a second", "", Merit::more, true},
     {"pairs", "", Merit::less, false},
     {"collision time", " ms", Merit::less, true},
     {"overhead", " ms", Merit::less, true},
     {"frames a second over those of the fastest other", "", Merit::none, true},
     {"frames a second before the first fracture", "", Merit::more, true},
     {"pairs before the first fracture", "", Merit::less, false},
     {"frames a second, after the first fracture over before", "", Merit::more, true},
     {"pairs for each moving object, after the first fracture over before", "", Merit::less, false},
     {"pairs for each moving object, last fifth of the run over the second", "", Merit::less, false},
     {"collision time for each moving object, last fifth of the run over the second", "", Merit::less, true},
     {"pairs, first twenty steps over the least of as many in the first tenth", "", Merit::none, false},
     {"pairs for each moving object, greatest over least fifth of the last two thirds", "", Merit::less,
      false},
     {"frames a second, greatest over least fifth of the last two thirds", "", Merit::less, true},
     {"leaves, greatest over least fifth of the last two thirds", "", Merit::less, false},
     {"greatest change of depth within ten steps", "", Merit::less, false},
     {"changes of depth, after the first fracture over before", "", Merit::none, false},
     {"changes of depth, at the end over after the first fracture", "", Merit::less, false}}};

}  // namespace

const MeasureTraits& traits_of(Measure measure) { return kTraits[static_cast<std::size_t>(measure)]; }

}  // namespace kerf
