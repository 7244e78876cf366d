#include <array>

#include "tests/hard/cases/scripts.h"

namespace kerf::test {
namespace {

constexpr std::string_view kEager =
    "max_redundancy=0.4,schedule_interval=1,budget_divisor=1,min_threshold=4,max_threshold=8";
constexpr std::string_view kLate =
    "max_redundancy=0.4,schedule_interval=1,budget_divisor=64,min_threshold=4,"
    "max_threshold=8";
constexpr std::string_view kUncapped =
    "max_redundancy=0.4,schedule_interval=1,budget_divisor=1,min_threshold=4,max_threshold=8,"
    "max_entries=1000";
constexpr std::string_view kCoarse =
    "max_redundancy=0.4,schedule_interval=1,budget_divisor=1,min_threshold=24,max_threshold=24";

/// Id, name, what it is, both scripts, and what differs from the usual.
constexpr std::array kCases{
    HardCase{"V1", "NotANumber", "NaN in one bound or all", not_a_number<2>, not_a_number<3>},
    HardCase{"V2", "InfiniteBounds", "unbounded planes, half spaces", infinite_bounds<2>, infinite_bounds<3>},
    HardCase{"V3", "Inverted", "min > max", inverted_boxes<2>, inverted_boxes<3>},
    HardCase{"V4", "PointsAndFlatPlates", "zero extent", points_and_plates<2>, points_and_plates<3>},
    HardCase{"V5", "SignedZeros", "+0 touches -0", signed_zeros<2>, signed_zeros<3>},
    HardCase{"V6", "Denormals", "coordinates below 2^-126", denormals<2>, denormals<3>},
    HardCase{"V6",
             "DenormalsFlushedToZero",
             "the same, taken for zero",
             denormals<2>,
             denormals<3>,
             {},
             std::nullopt,
             false,
             true},
    HardCase{"V6", "TouchAtZeroFlushedToZero", "couples meet at zero, so taken", touch_at_zero<2>,
             touch_at_zero<3>,
             "max_redundancy=0.4,schedule_interval=1,budget_divisor=1,min_threshold=16,max_threshold=16,"
             "free_directions=0,byte_sweep=1,stream_share=0.06,bulk_factor=2",
             std::nullopt, false, true},
    HardCase{"V7", "LargestFloats", "coordinates up to FLT_MAX", largest_floats<2>, largest_floats<3>},
    HardCase{"V8", "FarOffsets", "scene offset by 1e5 to 1e7", far_offsets<2>, far_offsets<3>},
    HardCase{"V9", "ExactTouch", "touch, and one ulp off", exact_touch<2>, exact_touch<3>},
    HardCase{"V10", "MixedScales", "sizes 2^-40 to 2^40, ground", mixed_scales<2>, mixed_scales<3>},
    HardCase{"V11", "TinyBoxFarOut", "one box at 1e3 to 1e30", tiny_box_far_out<2>, tiny_box_far_out<3>},
    HardCase{"S1", "AllCoincide", "all boxes the same", all_coincide<2>, all_coincide<3>},
    HardCase{"S2", "Nested", "each box in the next", nested_boxes<2>, nested_boxes<3>},
    HardCase{"S3", "CrossingRods", "every plane straddled", crossing_rods<2>, crossing_rods<3>},
    HardCase{"S4", "HalfShareACentre", "half on one spot, half aside", half_share_a_centre<2>,
             half_share_a_centre<3>},
    HardCase{"S5", "NeighbouringFloats", "no float between objects", neighbouring_floats<2>,
             neighbouring_floats<3>},
    HardCase{"S6", "SortedAndCollinear", "one long row, in order", sorted_and_collinear<2>,
             sorted_and_collinear<3>},
    HardCase{"S7", "ExponentialSpacing", "2^-120 to 2^120 on a line", exponential_spacing<2>,
             exponential_spacing<3>},
    HardCase{"S8", "ManyObjects", "more than 65,535 objects", many_objects<2>, many_objects<3>},
    HardCase{"S9", "FewObjects", "0, 1, 2 objects; all removed", few_objects<2>, few_objects<3>},
    HardCase{"S10", "TouchingLattice", "faces, edges, corners meet", touching_lattice<2>,
             touching_lattice<3>},
    HardCase{"S11", "SlantedNeedles", "dense set of directions", slanted_needles<2>, slanted_needles<3>,
             "directions=400,candidate_factor=100,max_redundancy=0.4,schedule_interval=1,budget_divisor=1,"
             "min_threshold=8,max_threshold=16"},
    HardCase{"S12", "OverflowingProjections", "n * p beyond FLT_MAX", overflowing_projections<2>,
             overflowing_projections<3>},
    HardCase{"M1", "Teleports", "everything elsewhere at once", teleports<2>, teleports<3>},
    HardCase{"M2", "MovesBelowAnUlp", "moves lost in rounding", moves_below_an_ulp<2>, moves_below_an_ulp<3>},
    HardCase{"M3", "LastBoxCounts", "moved often in one step", last_box_counts<2>, last_box_counts<3>},
    HardCase{"M4", "RemovedWhilePending", "removed before its update", removed_while_pending<2>,
             removed_while_pending<3>},
    HardCase{"M5", "AddedAndRemovedAtOnce", "double remove, reused id", added_and_removed_at_once<2>,
             added_and_removed_at_once<3>},
    HardCase{"M6",
             "ChangedParameters",
             "parameters change in mid-run",
             changed_parameters<2>,
             changed_parameters<3>,
             {},
             std::nullopt,
             true},
    HardCase{"M7", "FatAndTight", "volumes larger than their boxes", fat_and_tight<2>, fat_and_tight<3>},
    HardCase{"M8", "Oscillation", "to and fro across planes", oscillation<2>, oscillation<3>},
    HardCase{"M9", "CollapseAndExplosion", "an attractor, then apart", collapse_and_explosion<2>,
             collapse_and_explosion<3>},
    HardCase{"M10", "Resizing", "grow and shrink while moving", resizing<2>, resizing<3>},
    HardCase{"O1", "ShiftsOntoEnds", "balance onto ends of objects", shifts_onto_ends<2>, shifts_onto_ends<3>,
             kEager, Operator::balance, true},
    HardCase{"O2", "SwapsAtTheRoot", "swap down to one leaf", swaps_at_the_root<2>, swaps_at_the_root<3>,
             kUncapped, Operator::swap, true},
    HardCase{"O3", "MergesOfStraddlers", "merge of objects on both sides", merges_of_straddlers<2>,
             merges_of_straddlers<3>, kCoarse, Operator::merge, true},
    HardCase{"O4", "EventsForDeadNodes", "deferred until the node is gone", events_for_dead_nodes<2>,
             events_for_dead_nodes<3>, kLate, std::nullopt, true},
    HardCase{"O5",
             "FullEventList",
             "no budget, no room for events",
             full_event_list<2>,
             full_event_list<3>,
             {},
             std::nullopt,
             true},
};

}  // namespace

std::span<const HardCase> hard_cases() { return kCases; }

}  // namespace kerf::test
