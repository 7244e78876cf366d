#pragma once

#include "tests/hard/cases.h"

// The scripts of the hard cases, each written once for both dimensions.
namespace kerf::test {

// values.cpp, extremes.cpp
template <int D>
Script<D> not_a_number(Size size);
template <int D>
Script<D> infinite_bounds(Size size);
template <int D>
Script<D> inverted_boxes(Size size);
template <int D>
Script<D> points_and_plates(Size size);
template <int D>
Script<D> signed_zeros(Size size);
template <int D>
Script<D> denormals(Size size);
template <int D>
Script<D> touch_at_zero(Size size);
template <int D>
Script<D> largest_floats(Size size);
template <int D>
Script<D> far_offsets(Size size);
template <int D>
Script<D> exact_touch(Size size);
template <int D>
Script<D> mixed_scales(Size size);
template <int D>
Script<D> tiny_box_far_out(Size size);

// structure.cpp
template <int D>
Script<D> all_coincide(Size size);
template <int D>
Script<D> nested_boxes(Size size);
template <int D>
Script<D> crossing_rods(Size size);
template <int D>
Script<D> half_share_a_centre(Size size);
template <int D>
Script<D> neighbouring_floats(Size size);
template <int D>
Script<D> sorted_and_collinear(Size size);
template <int D>
Script<D> exponential_spacing(Size size);
template <int D>
Script<D> many_objects(Size size);
template <int D>
Script<D> few_objects(Size size);
template <int D>
Script<D> touching_lattice(Size size);
template <int D>
Script<D> slanted_needles(Size size);
template <int D>
Script<D> overflowing_projections(Size size);

// motion.cpp
template <int D>
Script<D> teleports(Size size);
template <int D>
Script<D> moves_below_an_ulp(Size size);
template <int D>
Script<D> last_box_counts(Size size);
template <int D>
Script<D> removed_while_pending(Size size);
template <int D>
Script<D> added_and_removed_at_once(Size size);
template <int D>
Script<D> changed_parameters(Size size);
template <int D>
Script<D> fat_and_tight(Size size);
template <int D>
Script<D> oscillation(Size size);
template <int D>
Script<D> collapse_and_explosion(Size size);
template <int D>
Script<D> resizing(Size size);

// operators.cpp
template <int D>
Script<D> shifts_onto_ends(Size size);
template <int D>
Script<D> swaps_at_the_root(Size size);
template <int D>
Script<D> merges_of_straddlers(Size size);
template <int D>
Script<D> events_for_dead_nodes(Size size);
template <int D>
Script<D> full_event_list(Size size);

}  // namespace kerf::test
