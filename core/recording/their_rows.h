#pragma once

#include "core/base/given_names.h"
#include "core/recording/database.h"
#include "core/recording/theirs.h"

namespace kerf {

/// The tables of an import: what the other engine calls things, what it reported and how that was judged.
/// Whatever is read is checked; what makes no sense throws std::runtime_error.
extern const char* const kTheirTables;

void write_names(Database& database, const GivenNames& names);
GivenNames read_names(const Database& database);

void write_design(Database& database, const PairDesign& design);
PairDesign read_design(const Database& database);

/// Their pairs of a step as they reported them, and how each compares. Pairs without a verdict are right.
void write_theirs(Database& database, std::uint32_t step, std::span<const Pair> reported,
                  std::span<const JudgedPair> judged);
std::vector<Pair> read_their_pairs(const Database& database, std::uint32_t step);
std::vector<JudgedPair> read_judged_pairs(const Database& database, std::uint32_t step);
std::optional<TheirStep> read_their_step(const Database& database, std::uint32_t step);
/// Of all steps that have one, by step.
std::vector<std::pair<std::uint32_t, TheirStep>> read_their_steps(const Database& database);

template <int D>
void write_changes(Database& database, std::uint32_t step, const TheirChanges<D>& changes);
template <int D>
TheirChanges<D> read_their_changes(const Database& database, std::uint32_t step);
/// The box that an object was last given up to a step, and its filter; none if the floats say all, or if it
/// has none.
template <int D>
std::optional<GivenBox<D>> read_given_box(const Database& database, ObjectId object, std::uint32_t step);
std::optional<GivenFilter> read_filter(const Database& database, ObjectId object, std::uint32_t step);

}  // namespace kerf
