#include "core/replay/judge_theirs.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <string_view>

#include "core/base/float_mode.h"
#include "core/base/poll.h"
#include "core/replay/oracle.h"

namespace kerf {
namespace {

/// Calls `use(pair, whether it is among the others)` with each pair of a sorted range.
template <class Use>
void for_each_pair(std::span<const Pair> pairs, std::span<const Pair> others, const Use& use) {
  auto other = others.begin();
  for (const Pair& pair : pairs) {
    poll();
    while (other != others.end() && *other < pair) ++other;
    use(pair, other != others.end() && *other == pair);
  }
}

/// Whether a float, written with as many digits as the number has, is the number: then an engine of floats
/// may have written it.
bool may_be_float(double x) {
  constexpr double kMost = std::numeric_limits<Scalar>::max();
  if (!(std::abs(x) <= kMost)) return true;
  std::array<char, 64> given{};
  std::array<char, 64> rounded{};
  const char* const end = std::to_chars(given.begin(), given.end(), x, std::chars_format::scientific).ptr;
  const std::string_view text(given.data(), end);
  const std::size_t point = text.find('.');
  const auto decimals = point == std::string_view::npos ? 0 : static_cast<int>(text.find('e') - point - 1);
  const auto as_float = static_cast<double>(static_cast<Scalar>(x));
  const char* const rounded_end =
      std::to_chars(rounded.begin(), rounded.end(), as_float, std::chars_format::scientific, decimals).ptr;
  return text == std::string_view(rounded.data(), rounded_end);
}

template <int D>
bool may_be_floats(const GivenBox<D>& box) {
  return std::ranges::all_of(box.min, may_be_float) && std::ranges::all_of(box.max, may_be_float);
}

/// An engine of floats rounds what it adds its margin to, and rounds the sum. Bounds may be off by what was
/// rounded away of them, too.
template <int D>
bool overlap_with(const Margin& margin, const BoundRounding& rounding, const GivenBox<D>& a,
                  const GivenBox<D>& b) {
  if (overlaps(grow(widen(a, rounding), margin), grow(widen(b, rounding), margin))) return true;
  if (!may_be_floats(a) || !may_be_floats(b)) return false;
  const auto as_floats = [](GivenBox<D> box) {
    for (double& x : box.min) x = static_cast<double>(static_cast<Scalar>(x));
    for (double& x : box.max) x = static_cast<double>(static_cast<Scalar>(x));
    return box;
  };
  const auto grown = [&](const GivenBox<D>& box) {
    return widen(grow<Scalar>(as_floats(box), margin), rounding);
  };
  return overlaps(grown(a), grown(b));
}

}  // namespace

template <int D>
void TheirWorld<D>::apply(const TheirChanges<D>& changes) {
  for (const auto& [object, box] : changes.boxes) boxes_[object] = box;
  for (const auto& [object, filter] : changes.filters) filters_[object] = filter;
}

template <int D>
const std::optional<GivenBox<D>>& TheirWorld<D>::given(ObjectId object) const {
  static const std::optional<GivenBox<D>> kNone;
  const auto found = boxes_.find(object);
  return found == boxes_.end() ? kNone : found->second;
}

template <int D>
GivenBox<D> TheirWorld<D>::box(const ObjectTable<D>& objects, ObjectId object) const {
  const auto& box = given(object);
  return box ? *box : to_given(objects.box(object));
}

template <int D>
GivenFilter TheirWorld<D>::filter(ObjectId object) const {
  const auto found = filters_.find(object);
  return found == filters_.end() ? GivenFilter{} : found->second;
}

template <int D>
bool TheirWorld<D>::overlap(const ObjectTable<D>& objects, const Pair& pair) const {
  return overlaps(box(objects, pair.a), box(objects, pair.b));
}

template <int D>
bool TheirWorld<D>::overlap_with_margin(const ObjectTable<D>& objects, const Pair& pair,
                                        const PairDesign& design) const {
  return overlap_with(design.margin, design.rounding, box(objects, pair.a), box(objects, pair.b));
}

namespace {

/// Why the engine need not report a pair.
template <int D>
std::optional<PairVerdict> left_out(const Pair& pair, const TheirWorld<D>& world, const PairDesign& design) {
  if (!lets_pass(world.filter(pair.a), world.filter(pair.b))) return PairVerdict::filtered;
  if (std::ranges::binary_search(design.ignored, pair)) return PairVerdict::listed;
  return std::nullopt;
}

/// On a pair that was reported, and is none: the boxes are apart, or both are fixed. What the engine leaves
/// out excuses nothing that it reports.
template <int D>
PairVerdict verdict_on_extra(const Pair& pair, const ObjectTable<D>& objects, const TheirWorld<D>& world,
                             const PairDesign& design) {
  if (!objects.is_placed(pair.a) || !objects.is_placed(pair.b)) return PairVerdict::extra;
  const bool both_fixed = objects.is_fixed(pair.a) && objects.is_fixed(pair.b);
  const bool by_margin = design.margin != Margin{} && !both_fixed && !world.overlap(objects, pair);
  return by_margin && world.overlap_with_margin(objects, pair, design) ? PairVerdict::margin
                                                                       : PairVerdict::extra;
}

}  // namespace

template <int D>
std::vector<JudgedPair> judge_theirs(std::span<const Pair> reported, std::span<const Pair> truth,
                                     const ObjectTable<D>& objects, const TheirWorld<D>& world,
                                     const PairDesign& design) {
  const DefaultFloats floats;
  std::vector<JudgedPair> judged;
  std::vector<Pair> theirs = sorted_pairs(reported);
  const std::vector<Pair> repeated = take_repeated(theirs);
  const auto overlap = [&](const Pair& pair) { return world.overlap(objects, pair); };
  const bool may_be_open = design.rounding != BoundRounding{};
  const auto is_open = [&](const Pair& pair) {
    return may_be_open &&
           undecided_axis(design.rounding, world.box(objects, pair.a), world.box(objects, pair.b));
  };
  std::size_t missing = 0;
  for_each_pair(truth, theirs, [&](const Pair& /*pair*/, bool is_theirs) { missing += is_theirs ? 0 : 1; });
  judged.reserve(missing);
  for_each_pair(truth, theirs, [&](const Pair& pair, bool is_theirs) {
    if ((is_theirs && !may_be_open) || !overlap(pair)) return;
    const bool open = is_open(pair);
    if (is_theirs && !open) return;
    const auto why = is_theirs ? std::nullopt : left_out(pair, world, design);
    judged.push_back({pair, why.value_or(open ? PairVerdict::undecided : PairVerdict::missed)});
  });
  for_each_pair(theirs, truth, [&](const Pair& pair, bool is_true) {
    if (!is_true || !overlap(pair)) judged.push_back({pair, verdict_on_extra(pair, objects, world, design)});
  });
  for (const Pair& pair : repeated) judged.push_back({pair, PairVerdict::twice});
  if (!std::ranges::is_sorted(judged, {}, &JudgedPair::verdict))  // sorting takes memory
    std::ranges::stable_sort(judged, {}, &JudgedPair::verdict);
  return judged;
}

template <int D>
bool overlap_as_given(const RecordingReader<D>& recording, std::uint32_t step, const ObjectTable<D>& objects,
                      const Pair& pair) {
  const auto box = [&](ObjectId object) {
    const auto given = recording.given_box(object, step);
    return given ? *given : to_given(objects.box(object));
  };
  return overlaps(box(pair.a), box(pair.b));
}

template class TheirWorld<2>;
template class TheirWorld<3>;
#define KERF_INSTANTIATE(D)                                                                          \
  template std::vector<JudgedPair> judge_theirs<D>(std::span<const Pair>, std::span<const Pair>,     \
                                                   const ObjectTable<D>&, const TheirWorld<D>&,      \
                                                   const PairDesign&);                               \
  template bool overlap_as_given<D>(const RecordingReader<D>&, std::uint32_t, const ObjectTable<D>&, \
                                    const Pair&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
