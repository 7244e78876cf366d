#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>

#include "core/recording/recording_reader.h"

namespace kerf {

/// Called with each step before it is written; its exception ends the export.
using OnStep = std::function<void(std::uint32_t step)>;

/// The broad phase's time as a timeline in the trace-event format: a slice for each step and phase, a mark
/// for each operator, curves of pairs, entries, deferred events and redundancy. The steps follow one another
/// without gaps.
template <int D>
void export_chrome_trace(RecordingReader<D>& recording, std::ostream& out, const OnStep& on_step);

/// The table of steps as CSV, with a heading.
template <int D>
void export_steps(const RecordingReader<D>& recording, std::ostream& out, const OnStep& on_step);

/// Every change of a box as CSV, with a heading, as `kerf import` reads it: of an import with the names and
/// numbers that were given, of other runs with as many digits as it takes to read them back bit by bit.
/// Bounds are blank where an object goes; a step in which nothing changes has a line without an object.
template <int D>
void export_boxes(RecordingReader<D>& recording, std::ostream& out, const OnStep& on_step);

/// The pairs that another engine reported, as `kerf import --pairs` reads them.
template <int D>
void export_pairs(const RecordingReader<D>& recording, std::ostream& out, const OnStep& on_step);

}  // namespace kerf
