#include "core/replay/judge_theirs.h"

#include <algorithm>
#include <iterator>

namespace kerf {
namespace {

std::vector<Pair> sorted_pairs(std::span<const Pair> reported) {
  std::vector<Pair> pairs;
  for (const Pair& pair : reported) pairs.push_back(make_pair(pair.a, pair.b));
  std::ranges::sort(pairs);
  return pairs;
}

/// Takes out what is there again and returns it.
std::vector<Pair> take_repeated(std::vector<Pair>& pairs) {
  std::vector<Pair> repeated;
  for (std::size_t k = 1; k < pairs.size(); ++k)
    if (pairs[k] == pairs[k - 1]) repeated.push_back(pairs[k]);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return repeated;
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
bool TheirWorld<D>::overlap(const ObjectTable<D>& objects, const Pair& pair, const Margin& margin) const {
  const GivenBox<D> a = box(objects, pair.a);
  const GivenBox<D> b = box(objects, pair.b);
  return margin == Margin{} ? overlaps(a, b) : overlaps(grow(a, margin), grow(b, margin));
}

template <int D>
std::vector<JudgedPair> judge_theirs(std::span<const Pair> reported, std::span<const Pair> truth,
                                     const ObjectTable<D>& objects, const TheirWorld<D>& world,
                                     const PairDesign& design) {
  std::vector<JudgedPair> judged;
  std::vector<Pair> theirs = sorted_pairs(reported);
  for (const Pair& pair : take_repeated(theirs)) judged.push_back({pair, PairVerdict::twice});
  std::vector<Pair> right;
  std::ranges::copy_if(truth, std::back_inserter(right),
                       [&](const Pair& pair) { return world.overlap(objects, pair); });

  const auto add = [&](const Pair& pair, PairVerdict otherwise) {
    if (!lets_pass(world.filter(pair.a), world.filter(pair.b))) {
      judged.push_back({pair, PairVerdict::filtered});
    } else if (std::ranges::binary_search(design.ignored, pair)) {
      judged.push_back({pair, PairVerdict::listed});
    } else if (otherwise == PairVerdict::extra && design.margin != Margin{} && objects.is_placed(pair.a) &&
               objects.is_placed(pair.b) && !(objects.is_fixed(pair.a) && objects.is_fixed(pair.b)) &&
               world.overlap(objects, pair, design.margin)) {
      judged.push_back({pair, PairVerdict::margin});
    } else {
      judged.push_back({pair, otherwise});
    }
  };
  std::vector<Pair> missed;
  std::ranges::set_difference(right, theirs, std::back_inserter(missed));
  for (const Pair& pair : missed) add(pair, PairVerdict::missed);
  std::vector<Pair> extra;
  std::ranges::set_difference(theirs, right, std::back_inserter(extra));
  for (const Pair& pair : extra) add(pair, PairVerdict::extra);
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
