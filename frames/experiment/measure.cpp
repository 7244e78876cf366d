#include "frames/experiment/measure.h"

#include <array>

namespace kerf {
namespace {

constexpr std::array<MeasureTraits, 18> kTraits{
    {{"frames a second", "", false, true},
     {"pairs", "", true, false},
     {"collision time", " ms", true, true},
     {"overhead", " ms", true, true},
     {"frames a second over those of the fastest other", "", false, true},
     {"frames a second before the first fracture", "", false, true},
     {"pairs before the first fracture", "", true, false},
     {"frames a second, after the first fracture over before", "", false, true},
     {"pairs for each moving object, after the first fracture over before", "", true, false},
     {"pairs, last fifth of the run over the second", "", true, false},
     {"collision time, last fifth of the run over the second", "", true, true},
     {"pairs for each moving object, first tenth of the run over the last half", "", true, false},
     {"pairs for each moving object, greatest over least fifth of the last two thirds", "", true, false},
     {"frames a second, greatest over least fifth of the last two thirds", "", true, true},
     {"leaves, greatest over least fifth of the last two thirds", "", true, false},
     {"greatest change of depth within ten steps", "", true, false},
     {"changes of depth, after the first fracture over before", "", true, false},
     {"changes of depth, at the end over after the first fracture", "", true, false}}};

}  // namespace

const MeasureTraits& traits_of(Measure measure) { return kTraits[static_cast<std::size_t>(measure)]; }

}  // namespace kerf
