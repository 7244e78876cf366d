#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/random.h"
#include "sims3d/rivals/ode_space.h"

namespace kerf::test {
namespace {

struct Crowd {
  std::vector<Box<3>> boxes;
  std::vector<bool> fixed;
};

/// Boxes in [0, 32]^3 of extents from 0.02 to 9, smaller ones more often.
Crowd scatter(std::uint32_t count, std::uint64_t seed) {
  Random random(seed);
  Crowd crowd;
  for (std::uint32_t k = 0; k < count; ++k) {
    Box<3> box;
    for (int i = 0; i < 3; ++i) {
      box.min[i] = static_cast<Scalar>(random.uniform(0, 32));
      box.max[i] = box.min[i] + static_cast<Scalar>(std::exp(random.uniform(-4, 2.2)));
    }
    crowd.boxes.push_back(box);
    crowd.fixed.push_back(random.below(4) == 0);
  }
  return crowd;
}

constexpr Box<3> kRoom{{{0, 0, 0}}, {{32, 32, 32}}};

/// A space with the crowd in it, after a step.
class Filled {
 public:
  Filled(OdeSpaceKind kind, const Crowd& crowd, OdePlane plane = OdePlane::xz)
      : space_(kind, kRoom, OdeIntake::checked, plane) {
    for (std::uint32_t k = 0; k < crowd.boxes.size(); ++k)
      static_cast<void>(
          space_.insert({k}, crowd.boxes[k], crowd.fixed[k] ? Mobility::fixed : Mobility::moving));
    space_.step();
  }
  OdeSpace& operator*() { return space_; }
  [[nodiscard]] double candidates() const { return space_.count_candidates(); }
  [[nodiscard]] std::size_t pairs() const { return space_.pairs().size(); }

 private:
  OdeSpace space_;
};

/// The box as the geom has it: from its centre and extent, in doubles.
std::array<double, 6> bounds_of(const Box<3>& box) {
  std::array<double, 6> bounds{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double min = box.min[static_cast<int>(i)];
    const double max = box.max[static_cast<int>(i)];
    bounds[2 * i] = (min + max) / 2 - (max - min) / 2;
    bounds[2 * i + 1] = (min + max) / 2 + (max - min) / 2;
  }
  return bounds;
}

/// Two boxes are compared if they share a cell at the coarser of their levels.
bool share_a_cell(const std::array<double, 6>& a, const std::array<double, 6>& b) {
  const auto level_of = [](const std::array<double, 6>& box) {
    int level = 0;
    static_cast<void>(std::frexp(std::max({box[1] - box[0], box[3] - box[2], box[5] - box[4]}), &level));
    return std::max(level, -3);
  };
  const int coarser = std::max(level_of(a), level_of(b));
  const auto cell = [&](const std::array<double, 6>& box, std::size_t end) {
    const int own = level_of(box);
    return static_cast<int>(std::floor(box[end] * std::ldexp(1.0, -own))) >> (coarser - own);
  };
  for (std::size_t axis = 0; axis < 6; axis += 2)
    if (cell(a, axis) > cell(b, axis + 1) || cell(a, axis + 1) < cell(b, axis)) return false;
  return true;
}

double hash_candidates(const Crowd& crowd) {
  double count = 0;
  for (std::size_t i = 0; i < crowd.boxes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (!(crowd.fixed[i] && crowd.fixed[k]) &&
          share_a_cell(bounds_of(crowd.boxes[i]), bounds_of(crowd.boxes[k])))
        ++count;
  return count;
}

/// ODE's quadtree of depth 7 over the plane of two axes, written anew.
class Quadtree {
 public:
  Quadtree(const Crowd& crowd, std::size_t first, std::size_t second) : crowd_(crowd) {
    for (const Box<3>& box : crowd.boxes) {
      const std::array<double, 6> b = bounds_of(box);
      boxes_.push_back({b[2 * first], b[2 * first + 1], b[2 * second], b[2 * second + 1]});
    }
    const double end = std::nextafter(32.0, std::numeric_limits<double>::infinity());
    std::vector<std::size_t> all;
    for (std::size_t k = 0; k < boxes_.size(); ++k) all.push_back(k);
    visit({0, end, 0, end}, 7, all, {});
  }
  [[nodiscard]] double candidates() const { return count_; }

 private:
  using Rectangle = std::array<double, 4>;

  void visit(const Rectangle& block, int depth, const std::vector<std::size_t>& members,
             const std::vector<std::size_t>& from_above) {
    std::array<std::vector<std::size_t>, 4> below;
    const std::array<Rectangle, 4> quarters = quarters_of(block);
    std::vector<std::size_t> local;
    for (const std::size_t k : members) {
      const auto inside =
          std::ranges::find_if(quarters, [&](const Rectangle& r) { return holds(r, boxes_[k]); });
      if (depth == 0 || inside == quarters.end()) {
        local.push_back(k);
      } else {
        below[static_cast<std::size_t>(inside - quarters.begin())].push_back(k);
      }
    }
    for (std::size_t i = 0; i < local.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) count(local[i], local[k]);
      for (const std::size_t other : from_above) count(local[i], other);
    }
    for (std::size_t q = 0; q < 4; ++q) {
      if (below[q].empty()) continue;
      std::vector<std::size_t> reaching = from_above;
      reaching.insert(reaching.end(), local.begin(), local.end());
      if (below[q].size() > 1)
        std::erase_if(reaching, [&](std::size_t k) { return !reaches(quarters[q], boxes_[k]); });
      visit(quarters[q], depth - 1, below[q], reaching);
    }
  }
  static std::array<Rectangle, 4> quarters_of(const Rectangle& r) {
    const double x = r[0] + (r[1] - r[0]) / 2;
    const double y = r[2] + (r[3] - r[2]) / 2;
    return {{{r[0], x, r[2], y}, {r[0], x, y, r[3]}, {x, r[1], r[2], y}, {x, r[1], y, r[3]}}};
  }
  static bool holds(const Rectangle& r, const Rectangle& box) {
    return box[0] >= r[0] && box[1] < r[1] && box[2] >= r[2] && box[3] < r[3];
  }
  static bool reaches(const Rectangle& r, const Rectangle& box) {
    return box[0] < r[1] && box[1] >= r[0] && box[2] < r[3] && box[3] >= r[2];
  }
  void count(std::size_t a, std::size_t b) { count_ += crowd_.fixed[a] && crowd_.fixed[b] ? 0 : 1; }

  const Crowd& crowd_;
  std::vector<Rectangle> boxes_;
  double count_ = 0;
};

double sweep_candidates(const Crowd& crowd) {
  double count = 0;
  for (std::size_t i = 0; i < crowd.boxes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (crowd.boxes[i].min[0] <= crowd.boxes[k].max[0] && crowd.boxes[k].min[0] <= crowd.boxes[i].max[0])
        ++count;
  return count;
}

TEST(OdeCandidates, AreThoseOfTheHashTablesCells) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Crowd crowd = scatter(400, seed);
    EXPECT_EQ(Filled(OdeSpaceKind::hash, crowd).candidates(), hash_candidates(crowd)) << seed;
  }
}

TEST(OdeCandidates, AreThoseOfTheQuadtreesBlocks) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Crowd crowd = scatter(400, seed);
    EXPECT_EQ(Filled(OdeSpaceKind::quadtree, crowd).candidates(), Quadtree(crowd, 0, 2).candidates()) << seed;
    EXPECT_EQ(Filled(OdeSpaceKind::quadtree, crowd, OdePlane::xy).candidates(),
              Quadtree(crowd, 0, 1).candidates())
        << seed;
  }
}

TEST(OdeCandidates, AreThoseOfTheSweepsFirstAxis) {
  const Crowd crowd = scatter(400, 1);
  EXPECT_EQ(Filled(OdeSpaceKind::sweep_and_prune, crowd).candidates(), sweep_candidates(crowd));
}

TEST(OdeCandidates, AreCountedWithoutAnEffectOnTheSpace) {
  for (const OdeSpaceKind kind :
       {OdeSpaceKind::hash, OdeSpaceKind::quadtree, OdeSpaceKind::sweep_and_prune}) {
    Filled filled(kind, scatter(300, 9));
    const std::size_t pairs = filled.pairs();
    const double first = filled.candidates();
    EXPECT_GT(first, static_cast<double>(pairs));
    (*filled).step();
    EXPECT_EQ(filled.pairs(), pairs);
    EXPECT_EQ(filled.candidates(), first);
  }
}

/// ODE's own quadtree divides X and Y, so that it would separate what is stacked and not what lies side by
/// side along Z.
TEST(OdeCandidates, TheQuadtreeDividesThePlaneOnWhichThingsLie) {
  const Box<3> low{{{1, 1, 1}}, {{2, 2, 2}}};
  const Crowd stacked{{low, {{{1, 28, 1}}, {{2, 29, 2}}}}, {false, false}};
  const Crowd beside{{low, {{{1, 1, 28}}, {{2, 2, 29}}}}, {false, false}};
  EXPECT_EQ(Filled(OdeSpaceKind::quadtree, stacked).candidates(), 1);
  EXPECT_EQ(Filled(OdeSpaceKind::quadtree, beside).candidates(), 0);
  EXPECT_EQ(Filled(OdeSpaceKind::quadtree, stacked, OdePlane::xy).candidates(), 0);
}

TEST(OdeCandidates, OfAnEmptySpaceAndOfHugeBoxes) {
  for (const OdeSpaceKind kind :
       {OdeSpaceKind::hash, OdeSpaceKind::quadtree, OdeSpaceKind::sweep_and_prune}) {
    EXPECT_EQ(Filled(kind, {}).candidates(), 0);
    const Crowd huge{{{{{-1e30F, -1e30F, -1e30F}}, {{1e30F, 1e30F, 1e30F}}}, {{{0, 0, 0}}, {{1, 1, 1}}}},
                     {false, false}};
    EXPECT_EQ(Filled(kind, huge).candidates(), 1);
  }
}

TEST(OdeCandidates, AreUnknownWhereTheMarkerHasNoRoom) {
  const Crowd far{{{{{3e8F, 0, 0}}, {{3e8F + 64, 1, 1}}}, {{{0, 0, 0}}, {{1, 1, 1}}}}, {false, false}};
  EXPECT_LT(Filled(OdeSpaceKind::hash, far).candidates(), 0);
}

}  // namespace
}  // namespace kerf::test
