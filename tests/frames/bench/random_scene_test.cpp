#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "core/base/config.h"
#include "core/broad_phase/brute_force.h"
#include "core/bsp/bsp.h"
#include "frames/bench/bench_cell.h"
#include "frames/bench/random/layout.h"
#include "frames/bench/random/random_motion.h"
#include "frames/bench/random/random_report.h"
#include "frames/bench/truth.h"
#include "frames/page/json.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr std::uint64_t kSeed = 20261126;

std::string drawn(std::uint64_t seed, std::uint32_t number) {
  return as_json(draw_scene(seed, number, 256000)).dump();
}

TEST(RandomScenes, AreTheSameForTheSameSeedAndNumber) {
  std::set<std::string> different;
  for (std::uint32_t number = 1; number <= 50; ++number) {
    EXPECT_EQ(drawn(kSeed, number), drawn(kSeed, number));
    different.insert(drawn(kSeed, number).substr(std::string(R"({"number":10)").size()));
    different.insert(drawn(kSeed + 1, number).substr(std::string(R"({"number":10)").size()));
  }
  EXPECT_EQ(different.size(), 100U) << "neither numbers nor seeds repeat each other";
}

TEST(RandomScenes, FillTheFamilyAndDoNotLeaveIt) {
  std::set<Scattering> layouts;
  std::set<Travel> travels;
  std::set<BoxShapes> shapes;
  std::uint32_t switching = 0;
  std::uint32_t churning = 0;
  for (std::uint32_t number = 1; number <= 400; ++number) {
    const RandomScene scene = draw_scene(kSeed, number, 256000);
    layouts.insert(scene.layout);
    travels.insert(scene.travel);
    shapes.insert(scene.shapes);
    switching += scene.other ? 1 : 0;
    churning += scene.churn > 0 ? 1 : 0;
    EXPECT_TRUE(scene.dimension == 2 || scene.dimension == 3);
    EXPECT_TRUE(scene.objects >= 16 && scene.objects <= 256000) << scene.objects;
    EXPECT_TRUE(scene.density >= 0.1 && scene.density <= 30) << scene.density;
    EXPECT_TRUE(scene.decades >= 0 && scene.decades <= 4) << scene.decades;
    EXPECT_TRUE(scene.speed >= 0.001 && scene.speed <= 2) << scene.speed;
    EXPECT_LE(draw_scene(kSeed, number, 500).objects, 500U);
    EXPECT_LE(draw_scene(kSeed, number, 16).density, 3.75);  // 7.5 would be all pairs
  }
  EXPECT_EQ(layouts.size(), 8U);
  EXPECT_EQ(travels.size(), 9U);
  EXPECT_EQ(shapes.size(), 3U);
  EXPECT_NEAR(switching, 100, 30);
  EXPECT_NEAR(churning, 100, 30);
}

template <int D>
void check_density(RandomScene scene) {
  scene.dimension = D;
  const auto motion = make_random_motion<D>(scene);
  const double pairs = static_cast<double>(true_pairs(motion->boxes(), motion->moving()).size());
  const double wanted = scene.density * scene.objects;
  // Where pairs appear several at a time, the number next to the wanted one may be farther than that.
  EXPECT_NEAR(pairs, wanted, std::max(2.0, 1.01 * kDensityTolerance * wanted)) << D << "D " << as_text(scene);
}

TEST(RandomScenes, ReachTheirDensity) {
  for (const std::uint32_t most : {20, 1500})
    for (std::uint32_t number = 1; number <= 60; ++number) {
      const RandomScene scene = draw_scene(kSeed, number, most);
      check_density<2>(scene);
      check_density<3>(scene);
    }
}

template <int D>
class Against {
 public:
  explicit Against(const Motion<D>& motion) : motion_(motion), tree_(tuned_config()) {
    for (std::uint32_t k = 0; k < motion.boxes().size(); ++k)
      if (!is_absent(motion.boxes()[k])) insert({k});
  }
  /// Passes on what the motion says has changed.
  void follow() {
    for (const ObjectId object : motion_.removed()) {
      EXPECT_EQ(tree_.remove(object), Status::ok);
      EXPECT_EQ(oracle_.remove(object), Status::ok);
    }
    for (const ObjectId object : motion_.inserted()) insert(object);
    for (const ObjectId object : motion_.moved()) {
      EXPECT_EQ(tree_.move(object, motion_.boxes()[object.index()]), Status::ok);
      EXPECT_EQ(oracle_.move(object, motion_.boxes()[object.index()]), Status::ok);
    }
  }
  /// Whether the tree has the oracle's pairs, and the oracle those of the motion's boxes.
  [[nodiscard]] bool agree() {
    tree_.step();
    oracle_.step();
    const Truth truth = truth_of(oracle_.pairs());
    return truth == truth_of(tree_.pairs()) &&
           truth == truth_of(true_pairs(motion_.boxes(), motion_.moving()));
  }

 private:
  void insert(ObjectId object) {
    EXPECT_EQ(tree_.insert(object, motion_.boxes()[object.index()], Mobility::moving), Status::ok);
    EXPECT_EQ(oracle_.insert(object, motion_.boxes()[object.index()], Mobility::moving), Status::ok);
  }

  const Motion<D>& motion_;
  Bsp<D> tree_;
  BruteForce<D> oracle_;
};

template <int D>
void check_motion(const RandomScene& scene) {
  const auto motion = make_random_motion<D>(scene);
  const auto again = make_random_motion<D>(scene);
  Against<D> against(*motion);
  for (int step = 0; step < 12; ++step) {
    ASSERT_TRUE(against.agree()) << step << ": " << as_text(scene);
    motion->advance();
    again->advance();
    ASSERT_TRUE(std::ranges::equal(motion->boxes(), again->boxes())) << as_text(scene);
    ASSERT_EQ(motion->inserted().size(), motion->removed().size());
    ASSERT_LE(2 * motion->inserted().size(), motion->most_changes());
    against.follow();
  }
  const auto present =
      std::ranges::count_if(motion->boxes(), [](const Box<D>& box) { return !is_absent(box); });
  EXPECT_EQ(present, scene.objects);
}

TEST(RandomScenes, AreExactAgainstTheOracle) {
  for (std::uint32_t number = 1; number <= 60; ++number) {
    const RandomScene scene = draw_scene(kSeed, number, 300);
    scene.dimension == 2 ? check_motion<2>(scene) : check_motion<3>(scene);
  }
}

/// Every travel moves what is awake, by about the speed of the scene.
TEST(RandomScenes, MoveAsFastAsTheySay) {
  for (const Travel travel : {Travel::brownian, Travel::streams, Travel::rotation, Travel::explosion,
                              Travel::collapse, Travel::periodic, Travel::translation}) {
    RandomScene scene;
    scene.objects = 400;
    scene.travel = travel;
    scene.speed = 0.05;
    const auto motion = make_random_motion<3>(scene);
    PropertyMeter<3> meter;
    for (int step = 0; step < 6; ++step) {
      meter.add(*motion, 0);
      motion->advance();
    }
    EXPECT_NEAR(meter.properties().speed, 0.05, 0.025) << as_text(scene);
    EXPECT_EQ(meter.properties().resting, 0) << as_text(scene);
  }
}

/// Also where others sleep.
TEST(RandomScenes, AnExplosionTakesEachObjectUpToTwiceAsFar) {
  RandomScene scene;
  scene.objects = 200;
  scene.travel = Travel::explosion;
  scene.speed = 0.3;
  scene.awake = 0.3;
  const auto motion = make_random_motion<3>(scene);
  const auto beyond = [&] {
    Scalar far = 0;
    for (const Box<3>& box : motion->boxes()) far = std::max({far, -box.min[0], box.max[0]});
    return far;
  };
  const Scalar most = 1.5F * beyond() + 2;
  for (int step = 0; step < 3000; ++step) {
    motion->advance();
    ASSERT_LT(beyond(), most) << step;
  }
}

/// A library that needs bounds gets those of the objects, not of a world that they leave or never fill.
TEST(RandomScenes, HaveTheBoundsOfTheirMotion) {
  constexpr std::uint32_t kAhead = 60;
  for (std::uint32_t number = 1; number <= 60; ++number) {
    RandomScene scene = draw_scene(kSeed, number, 200);
    if (number % 4 == 0) scene.travel = Travel::translation;
    const auto motion = make_random_motion<3>(scene, kAhead);
    Box<3> reached = motion->boxes().front();
    for (std::uint32_t step = 0; step <= kAhead; ++step) {
      for (const Box<3>& box : motion->boxes())
        if (!is_absent(box)) reached = join(reached, box);
      motion->advance();
    }
    EXPECT_TRUE(contains(motion->bounds(), reached)) << as_text(scene);
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_LE(motion->bounds().max[axis] - reached.max[axis], 2.1F * motion->box_size()) << as_text(scene);
  }
}

TEST(RandomScenes, OfObjectsThatGoAndComeAreMeasuredWithCompletePairs) {
  RandomScene scene;
  scene.objects = 300;
  scene.travel = Travel::brownian;
  scene.speed = 0.2;
  scene.churn = 0.1;
  CellPlan plan;
  plan.scene = "churn";
  plan.objects = 300;
  plan.algorithms = {"kerf", "columns", "sort-and-sweep", "bullet-dbvt", "ode-sap"};
  plan.rounds = 1;
  plan.warm_up = 2;
  plan.steps = 20;
  plan.tests = true;
  const MotionSource<3> source = [&] { return make_random_motion<3>(scene); };
  const CellResult result = measure_cell<3>(plan, source, {[](const std::string&) {}, [] { return false; }});
  EXPECT_TRUE(result.gaps.empty());
  EXPECT_NEAR(result.properties.churn, 0.2, 0.02) << "a tenth goes, a tenth comes";
  ASSERT_GE(result.rows.size(), 4U);
  for (const BenchRow& row : result.rows) EXPECT_EQ(row.missed + row.extra, 0U) << row.algorithm;
  EXPECT_TRUE(result.rows[3].tests_per_pair.has_value()) << "sort-and-sweep counts its tests";
  EXPECT_GT(*result.rows[3].tests_per_pair, 1);
}

BenchRow round_row(const std::string& name, double time) {
  BenchRow row;
  row.algorithm = name;
  row.median_ns = time;
  row.round_ns = {time, time, time};
  return row;
}

TEST(RandomReport, NamesTheWorstFirstWithTheCommandThatRepeatsIt) {
  BenchRequest request;
  request.seed = 7;
  std::vector<RandomOutcome> all;
  for (std::uint32_t number = 1; number <= 3; ++number) {
    all.push_back({draw_scene(7, number, 1000), {}});
    all.back().cell.rows = {round_row("floor", 1), round_row("kerf", 10), round_row("columns", 10.0 * number),
                            round_row("ode-sap", 1)};
    all.back().cell.rows[3].missed = 1;
  }
  const std::string text = random_summary(request, all);
  EXPECT_THAT(text, HasSubstr("geometric mean 1.82, least 1.00; 0 slower"));
  EXPECT_THAT(text.substr(text.find("THE WORST\n")),
              StartsWith("THE WORST\n  1.00  kerf bench --random 1 --first 1 --seed 7   # columns"));
  EXPECT_THAT(text, HasSubstr(" 2.00 to  3.00     1  #\n"));
  all[1].cell.rows[1].missed = 1;
  EXPECT_THAT(random_summary(request, all),
              StartsWith("THE TREE FAILED OR WAS WRONG: kerf bench --random 1 --first 2 --seed 7\n"));
}

TEST(RandomReport, ACommandThatRepeatsASceneMeasuresItInTheSameWay) {
  BenchTexts texts;
  texts.random = "5";
  texts.seed = "7";
  const RandomScene scene = draw_scene(7, 3, 256000);
  EXPECT_EQ(repeat_command(parse_bench_request(texts), scene), "kerf bench --random 1 --first 3 --seed 7");
  texts.algorithms = "columns";
  texts.steps = "12";
  texts.most = "100";
  EXPECT_EQ(repeat_command(parse_bench_request(texts), scene),
            "kerf bench --random 1 --first 3 --seed 7 --most 100 --algorithms columns --steps 12");
}

}  // namespace
}  // namespace kerf
