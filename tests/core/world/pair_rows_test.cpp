#include "core/world/pair_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/base/random.h"

namespace kerf::test {
namespace {

using Listed = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Listed list(const PairRows& rows) {
  Listed pairs;
  for (std::uint32_t a = 0; a < rows.rows(); ++a)
    for (const Partner b : rows.row(a)) pairs.emplace_back(a, b.value);
  return pairs;
}

/// Pairs of `bound` objects in random order, each once; half of them of object 0, whose row is long.
std::vector<Pair> random_pairs(Random& random, std::uint32_t bound, std::size_t count) {
  std::set<Pair> pairs;
  while (pairs.size() < count) {
    const std::uint32_t a = random.below(2) == 0 ? 0 : random.below(bound - 1);
    const std::uint32_t b = a + 1 + random.below(bound - a - 1);
    pairs.insert(Pair{{a}, {b}});
  }
  std::vector<Pair> shuffled(pairs.begin(), pairs.end());
  for (std::size_t k = shuffled.size(); k > 1; --k)
    std::swap(shuffled[k - 1], shuffled[random.below(static_cast<std::uint32_t>(k))]);
  return shuffled;
}

TEST(PairRows, AreOrdered) {
  Random random(1);
  for (std::size_t count = 0; count < 60; ++count) {
    std::vector<Pair> pairs = random_pairs(random, 100, count);
    PairRows rows;
    rows.assign(pairs, 100);
    std::ranges::sort(pairs);
    Listed expected;
    for (const Pair& pair : pairs)
      expected.emplace_back(pair.a.value, make_partner(pair.b.value, false).value);
    ASSERT_EQ(list(rows), expected);
    ASSERT_EQ(rows.size(), count);
  }
}

/// In most rounds a few pairs are others than before, or come in another order; in some the rows before were
/// filtered, or are of fewer objects.
TEST(PairRows, AreOrderedWhateverWasBefore) {
  Random random(3);
  std::vector<Pair> pairs = random_pairs(random, 100, 300);
  PairRows before;
  for (int round = 0; round < 200; ++round) {
    if (round % 10 == 0) pairs = random_pairs(random, 100, 300);
    for (std::uint32_t k = random.below(5); k > 0; --k)
      std::swap(pairs[random.below(300)], pairs[random.below(300)]);
    const std::size_t count = 300 - random.below(3);
    const std::uint32_t bound = 100 + random.below(20);
    PairRows alone;
    alone.assign(std::span(pairs).first(count), bound);
    PairRows now;
    now.assign(std::span(pairs).first(count), bound, before);
    ASSERT_EQ(list(now), list(alone)) << "round " << round;
    if (round % 7 == 6) now.filter([&](std::uint32_t a, Partner) { return a % 5 != 0; });
    before = now;
  }
}

TEST(PairRows, DifferencesAreThoseOfTheSets) {
  Random random(2);
  PairRows before;
  std::vector<Pair> last;
  for (int round = 0; round < 40; ++round) {
    PairRows now;
    const std::uint32_t bound = 10 + random.below(50);
    std::vector<Pair> pairs = round % 4 == 3 ? last : random_pairs(random, bound, random.below(30));
    if (round % 4 == 3 && !pairs.empty()) pairs.pop_back();  // most rows stay
    now.assign(pairs, 60);
    last = pairs;
    const Listed old = list(before);
    const Listed next = list(now);
    Listed lost;
    Listed gained;
    compare_rows(
        before, now,
        [&](std::uint32_t a, std::size_t k) { lost.emplace_back(a, before.partners()[k].value); },
        [&](std::uint32_t a, std::size_t i) { gained.emplace_back(a, now.partners()[i].value); });
    Listed expected;
    std::ranges::set_difference(old, next, std::back_inserter(expected));
    ASSERT_EQ(lost, expected);
    expected.clear();
    std::ranges::set_difference(next, old, std::back_inserter(expected));
    ASSERT_EQ(gained, expected);
    before = now;
  }
}

TEST(PairRows, RowsOfOneLengthCanDiffer) {
  std::vector<Pair> pairs;
  for (std::uint32_t a = 0; a < 40; ++a) pairs.push_back({{a}, {a + 1}});
  PairRows before;
  before.assign(pairs, 50);
  pairs[5].b = {9};
  PairRows now;
  now.assign(pairs, 50);
  Listed lost;
  Listed gained;
  compare_rows(
      before, now,
      [&](std::uint32_t a, std::size_t k) { lost.emplace_back(a, before.partners()[k].index()); },
      [&](std::uint32_t a, std::size_t i) { gained.emplace_back(a, now.partners()[i].index()); });
  EXPECT_EQ(lost, (Listed{{5, 6}}));
  EXPECT_EQ(gained, (Listed{{5, 9}}));
}

TEST(PairRows, AFlagIsADifference) {
  PairRows before;
  PairRows now;
  before.assign(std::vector<Pair>{{{1}, {2}}}, 3);
  now.assign_flagged(std::vector<Pair>{{{1}, {make_partner(2, true).value}}}, 3);
  int changes = 0;
  compare_rows(
      before, now,
      [&](std::uint32_t, std::size_t k) { changes += before.partners()[k].is_flagged() ? 100 : 1; },
      [&](std::uint32_t, std::size_t i) { changes += now.partners()[i].is_flagged() ? 10 : 100; });
  EXPECT_EQ(changes, 11);
}

TEST(PairRows, AFilterAsksInOrderAndDropsPairs) {
  PairRows rows;
  rows.assign(std::vector<Pair>{{{0}, {3}}, {{2}, {3}}, {{0}, {1}}, {{1}, {2}}}, 4);
  Listed asked;
  rows.filter([&](std::uint32_t a, Partner b) {
    asked.emplace_back(a, b.index());
    return b.index() == 3;
  });
  EXPECT_EQ(asked, (Listed{{0, 1}, {0, 3}, {1, 2}, {2, 3}}));
  EXPECT_EQ(list(rows), (Listed{{0, make_partner(3, false).value}, {2, make_partner(3, false).value}}));
}

}  // namespace
}  // namespace kerf::test
