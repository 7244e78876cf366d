#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/ids.h"
#include "core/geometry/given_box.h"
#include "core/recording/bound_rounding.h"

namespace kerf {

/// How a pair of another engine compares with the definition. `twice` is one more time that it was reported;
/// those from `filtered` on are no fault: the engine is right by design, or the text is open.
enum class PairVerdict : std::uint8_t {
  missed,     ///< an overlap that was not reported
  extra,      ///< reported, but no overlap
  twice,      ///< reported again
  filtered,   ///< the masks of its objects leave it out
  listed,     ///< declared to be ignored
  margin,     ///< reported, and only the boxes with their margin overlap
  undecided,  ///< reported or not: what was rounded away of the bounds decides whether the boxes touch
};
inline constexpr std::size_t kVerdicts = 7;
inline constexpr std::array<std::string_view, kVerdicts> kVerdictNames{
    "missed", "extra", "twice", "filtered", "listed", "margin", "undecided"};
constexpr std::string_view to_string(PairVerdict verdict) {
  return kVerdictNames[static_cast<std::size_t>(verdict)];
}
constexpr bool is_fault(PairVerdict verdict) { return verdict < PairVerdict::filtered; }
constexpr bool is_ignored(PairVerdict verdict) {
  return !is_fault(verdict) && verdict != PairVerdict::undecided;
}

struct JudgedPair {
  Pair pair;
  PairVerdict verdict = PairVerdict::missed;
  friend bool operator==(const JudgedPair&, const JudgedPair&) = default;
};

/// The pairs of a step in figures.
struct TheirStep {
  std::uint64_t pairs = 0;      ///< as they reported them
  std::uint64_t missed = 0;     ///< overlaps that they did not report
  std::uint64_t extra = 0;      ///< reported, but no overlap
  std::uint64_t twice = 0;      ///< reported again
  std::uint64_t ignored = 0;    ///< neither missed nor extra, by what they do by design
  std::uint64_t undecided = 0;  ///< reported or not: their boxes touch only in the digits that were written
  friend bool operator==(const TheirStep&, const TheirStep&) = default;
  TheirStep& operator+=(const TheirStep& other);
};
/// `pairs` is how many were reported.
TheirStep sum_of(std::uint64_t pairs, std::span<const JudgedPair> judged);

/// What an engine's filter says of an object: two objects are a pair if each has a category of the other's
/// mask.
struct GivenFilter {
  std::uint64_t category = 1;
  std::uint64_t mask = UINT64_MAX;
  friend bool operator==(const GivenFilter&, const GivenFilter&) = default;
};
constexpr bool lets_pass(const GivenFilter& a, const GivenFilter& b) {
  return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

/// What another engine does by design, in all steps, and how its boxes were written.
struct PairDesign {
  Margin margin;
  std::vector<Pair> ignored;  ///< sorted
  BoundRounding rounding{};
  friend bool operator==(const PairDesign&, const PairDesign&) = default;
};

/// What a step changes for the judgement of their pairs beside what the tree is asked.
template <int D>
struct TheirChanges {
  struct GivenChange {
    ObjectId object;
    std::optional<GivenBox<D>> box;  ///< none: from now on the floats say all
    friend bool operator==(const GivenChange&, const GivenChange&) = default;
  };
  struct FilterChange {
    ObjectId object;
    GivenFilter filter;
    friend bool operator==(const FilterChange&, const FilterChange&) = default;
  };
  std::vector<GivenChange> boxes;  ///< of each object at most one, and only where floats do not hold the box
  std::vector<FilterChange> filters;
  friend bool operator==(const TheirChanges&, const TheirChanges&) = default;
};

}  // namespace kerf
