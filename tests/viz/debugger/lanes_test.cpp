#include "viz/debugger/model/lanes.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/random.h"
#include "viz/debugger/model/ribbons.h"
#include "viz/debugger/model/step_span.h"

namespace kerf {
namespace {

using ::testing::ElementsAre;

constexpr float kAbsent = std::numeric_limits<float>::quiet_NaN();

LaneRange by_reading_all(const std::vector<float>& values, std::size_t first, std::size_t last) {
  LaneRange range;
  for (std::size_t k = first; k < std::min(last, values.size()); ++k)
    if (std::isfinite(values[k])) range.add({values[k], values[k]});
  return range;
}

std::vector<float> rough_values(std::size_t count) {
  Random random(5);
  std::vector<float> values;
  for (std::size_t k = 0; k < count; ++k)
    values.push_back(random.bits() % 7 == 0 ? kAbsent : static_cast<float>(random.bits() % 1000));
  return values;
}

TEST(LanePyramid, AnyStretchHasTheExtremesOfItsValues) {
  for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 63U, 64U, 65U, 130U}) {
    const std::vector<float> values = rough_values(count);
    const LanePyramid pyramid(values);
    for (std::size_t first = 0; first <= count + 1; ++first)
      for (std::size_t last = 0; last <= count + 2; ++last)
        ASSERT_EQ(pyramid.range(first, last), by_reading_all(values, first, last))
            << count << ": " << first << " to " << last;
  }
}

TEST(LanePyramid, AStretchOfAHundredThousandStepsIsFewBlocks) {
  constexpr std::size_t kCount = 100'000;
  const LanePyramid pyramid(rough_values(kCount));
  for (std::size_t first = 0; first < kCount; first += 777) {
    std::size_t blocks = 0;
    pyramid.for_each_block(first, kCount - first / 3, [&](const LaneRange&) { ++blocks; });
    EXPECT_LE(blocks, 6 * 2 * LanePyramid::kBlock) << first;
  }
}

TEST(Lanes, NoPeakIsLostWhereStepsShareAColumn) {
  std::vector<float> values(1000, 1.0F);
  values[537] = 9;
  const Lane lane("peak", values);
  const TimeWindow all(1000);
  const auto columns = lane.columns(all, 100);
  ASSERT_EQ(columns.size(), 100U);
  EXPECT_EQ(columns[53], (LaneRange{1, 9}));
  EXPECT_EQ(std::ranges::count(columns, LaneRange{1, 1}), 99);
  EXPECT_EQ(lane.columns(all, 3000).size(), 3000U);
  TimeWindow part = all;
  part.show(530, 540);
  const auto seen = lane.columns(part, 20);
  EXPECT_EQ(std::ranges::count(seen, LaneRange{9, 9}), 2) << "each of ten steps has two columns";
  EXPECT_EQ(seen[14], (LaneRange{9, 9}));
  part.pan(-10);
  EXPECT_EQ(std::ranges::count(lane.columns(part, 20), LaneRange{1, 1}), 20) << "seen is another part";
  EXPECT_EQ(lane.columns(all, 100), columns) << "columns of another window are not kept for this one";
}

TEST(Lanes, EachStepIsInAColumnWhateverIsSeen) {
  Random random(3);
  for (int k = 0; k < 200; ++k) {
    TimeWindow window(1 + random.below(5000));
    window.zoom(1 + random.uniform(0, 50), random.uniform(0, window.whole()), 0.01);
    const std::size_t columns = 1 + random.below(900);
    std::uint32_t reached = window.column(0, columns).before;
    EXPECT_LE(reached, window.first());
    for (std::size_t column = 0; column < columns; ++column) {
      const TimeWindow::Column steps = window.column(column, columns);
      ASSERT_LE(steps.before, reached) << "no step is left out";
      ASSERT_LT(steps.before, steps.last);
      reached = steps.last;
    }
    EXPECT_GE(reached, std::floor(window.last()));
    EXPECT_LE(reached, window.whole());
  }
}

TEST(Lanes, ExtremesAreAtTheirFirstSteps) {
  const Lane lane("values", {kAbsent, 3, 1, 7, 1, 7, kAbsent});
  EXPECT_EQ(lane.least_step(), 3U);
  EXPECT_EQ(lane.greatest_step(), 4U);
  EXPECT_EQ(lane.value(1), std::nullopt);
  EXPECT_EQ(lane.value(2), 3.0);
  EXPECT_EQ(lane.value(0), std::nullopt);
  EXPECT_EQ(lane.value(8), std::nullopt);
  EXPECT_EQ(lane.range(2, 3), (LaneRange{1, 3}));
  EXPECT_TRUE(lane.range(1, 1).is_absent());
}

TEST(Lanes, OutliersAreClippedAtThe99thPercentileAndCounted) {
  std::vector<float> values(300, 2.0F);
  values[10] = 50;
  values[20] = 60;
  values[30] = 3;
  const Lane lane("outliers", values);
  EXPECT_EQ(lane.scale_end(true), 2);
  EXPECT_EQ(lane.above(), 3U);
  EXPECT_EQ(lane.scale_end(false), 60);
  values[10] = values[20] = 4;
  EXPECT_EQ(Lane("even", values).scale_end(true), 4) << "twice the percentile is no outlier";
  EXPECT_EQ(Lane("even", values).above(), 0U);
  std::vector<float> rare(300, 0.0F);
  rare[7] = 5;
  EXPECT_EQ(Lane("rare", rare).scale_end(true), 5) << "a scale that ends at 0 shows nothing";
}

TEST(Lanes, AnEmptyRunAndAbsentValuesHaveNoExtremesAndNoNan) {
  for (const std::vector<float>& values : {std::vector<float>{}, std::vector<float>(5, kAbsent)}) {
    const Lane lane("absent", values);
    EXPECT_EQ(lane.least_step(), 0U);
    EXPECT_EQ(lane.greatest_step(), 0U);
    EXPECT_EQ(lane.scale_end(true), 0);
    EXPECT_EQ(lane.scale_end(false), 0);
    EXPECT_EQ(lane.above(), 0U);
    for (const LaneRange& column : lane.columns(TimeWindow(static_cast<std::uint32_t>(values.size())), 40))
      EXPECT_TRUE(column.is_absent());
  }
  EXPECT_EQ(make_lanes({}).size(), 6U);
}

TEST(StepSpan, AreTheStepsThatTwoTimesLieAround) {
  EXPECT_EQ(steps_between(2.5, 4.5, 10), (StepSpan{3, 5}));
  EXPECT_EQ(steps_between(4.5, 2.5, 10), (StepSpan{3, 5}));
  EXPECT_EQ(steps_between(2, 4, 10), (StepSpan{3, 4}));
  EXPECT_EQ(steps_between(1.95, 4.05, 10), (StepSpan{3, 4}));
  EXPECT_EQ(steps_between(2, 2, 10), (StepSpan{3, 3}));
  EXPECT_EQ(steps_between(10, 10, 10), (StepSpan{10, 10}));
  EXPECT_EQ(steps_between(-5, 50, 10), (StepSpan{1, 10}));
}

TEST(StepSpan, FiguresAreThoseOfReadingEachStep) {
  Random random(9);
  std::vector<StepRow> rows(200);
  std::array<std::uint64_t, kOperatorCount> acted{};
  for (StepRow& row : rows) {
    for (std::uint64_t& count : acted) count += random.below(3);
    row.statistics.operators = acted;
    row.pairs = random.below(900);
    row.statistics.height = random.below(12);
    row.statistics.redundancy = random.unit();
    row.statistics.phase_seconds[2] = random.unit();
  }
  const std::vector<Lane> lanes = make_lanes(rows);
  for (const StepSpan span : {StepSpan{1, 1}, StepSpan{1, 200}, StepSpan{17, 93}, StepSpan{200, 200}}) {
    const SpanFigures figures = figures_of(span, rows, lanes);
    SpanFigures read;
    for (std::uint32_t step = span.first; step <= span.last; ++step) {
      const StepRow& row = rows[step - 1];
      for (std::size_t k = 0; k < acted.size(); ++k)
        read.operators[k] +=
            row.statistics.operators[k] - (step == 1 ? 0 : rows[step - 2].statistics.operators[k]);
      read.pairs.add({static_cast<float>(row.pairs), static_cast<float>(row.pairs)});
      const auto height = static_cast<float>(row.statistics.height);
      read.height.add({height, height});
      const auto percent = static_cast<float>(100 * row.statistics.redundancy);
      read.redundancy.add({percent, percent});
      read.seconds += row.seconds();
    }
    EXPECT_EQ(figures.operators, read.operators);
    EXPECT_EQ(figures.pairs, read.pairs);
    EXPECT_EQ(figures.height, read.height);
    EXPECT_EQ(figures.redundancy, read.redundancy);
    EXPECT_NEAR(figures.seconds, read.seconds, 1e-4);
  }
}

TEST(StepSpan, AbsentFiguresAreADash) {
  std::vector<StepRow> rows(2);
  rows[0].statistics.redundancy = std::numeric_limits<double>::quiet_NaN();
  rows[0].statistics.phase_seconds[0] = std::numeric_limits<double>::infinity();
  const std::string text = to_text(figures_of({1, 1}, rows, make_lanes(rows)), {});
  EXPECT_EQ(text, "1 step: no operator; pairs 0; height 0; redundancy -; 0 ms; steps 1 to 1");
}

TEST(Ribbons, NoMoreAreDrawnThanThereArePixels) {
  using Kind = Ribbon::Kind;
  std::vector<Ribbon> ribbons{{1, 100'000, Kind::life}};
  for (std::uint32_t step = 1; step <= 100'000; ++step)
    ribbons.push_back({step, step, step % 2 == 0 ? Kind::acted : Kind::listed});
  TimeScale scale{TimeWindow(100'000), 900};
  const auto seen = thin_out(ribbons, scale);
  EXPECT_LE(seen.size(), 2 * 901U + 1);
  std::vector<int> pixels(900);
  for (const Ribbon& ribbon : seen)
    if (ribbon.kind == Kind::acted) ++pixels[static_cast<std::size_t>(scale.x_of(ribbon.begin()))];
  EXPECT_EQ(std::ranges::count(pixels, 0), 0) << "no pixel of those is left out";
  EXPECT_EQ(seen[0], ribbons[0]);
  scale.window.show(10, 20);
  EXPECT_EQ(thin_out(ribbons, scale).size(), 1 + 10U) << "those that reach into the window";
}

std::vector<StepRow> rows_with_events(const std::vector<std::uint64_t>& events) {
  std::vector<StepRow> rows(events.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].step = static_cast<std::uint32_t>(k + 1);
    rows[k].events = events[k];
    rows[k].first_event = k == 0 ? 0 : rows[k - 1].first_event + rows[k - 1].events;
  }
  return rows;
}

TEST(TimeWindow, ZoomKeepsTheTimeAtTheMouseAndStaysWithinTheRun) {
  TimeWindow window(100'000);
  window.zoom(1000, 40'000, 0.1);
  EXPECT_NEAR(window.span(), 100, 1e-9);
  EXPECT_NEAR((40'000 - window.first()) / window.span(), 0.4, 1e-9);
  window.zoom(1e9, 40'000, 0.1);
  EXPECT_NEAR(window.span(), 0.1, 1e-9);
  window.pan(-1e9);
  EXPECT_EQ(window.first(), 0);
  window.pan(1e9);
  EXPECT_NEAR(window.last(), 100'000, 1e-9);
  window.zoom(1e-9, 7, 0.1);
  EXPECT_TRUE(window.shows_all());
  EXPECT_EQ(window, TimeWindow(100'000));
}

TEST(TimeWindow, ItFollowsAMomentThatLeavesIt) {
  TimeWindow window(1000);
  window.show(100, 200);
  window.reveal(150);
  EXPECT_EQ(window.first(), 100);
  window.reveal(201);
  EXPECT_LE(window.first(), 201);
  EXPECT_GE(window.last(), 201);
  EXPECT_EQ(window.span(), 100);
  window.reveal(3);
  EXPECT_EQ(window.first(), 0);
}

TEST(TimeWindow, MomentsHaveTimesAndTimesMoments) {
  const auto rows = rows_with_events({3, 0, 9});
  for (const Position& moment : {Position::end_of(0), Position{1, 0}, Position{1, 2}, Position::end_of(1),
                                 Position::end_of(2), Position{3, 3}, Position{3, 11}, Position::end_of(3)})
    EXPECT_EQ(moment_at(time_of(moment, rows), 1000, rows), moment) << to_string(moment, {});
  EXPECT_EQ(time_of({1, 1}, rows), 0.5);
  EXPECT_EQ(moment_at(0.5, 15, rows), Position::end_of(1)) << "its events are not apart yet";
  EXPECT_EQ(moment_at(0.5, 16, rows), (Position{1, 1}));
  EXPECT_EQ(moment_at(99, 1000, rows), Position::end_of(3));
  EXPECT_EQ(moment_at(-9, 1000, rows), Position::end_of(0));
  EXPECT_EQ(moment_at(0.5, 1000, {}), Position::end_of(0));
}

TEST(TimeWindow, TheHighestMagnificationShowsAFewEvents) {
  const auto rows = rows_with_events({3, 5999});
  EXPECT_EQ(least_span(0.5, rows), 1);
  EXPECT_NEAR(least_span(1.5, rows), 0.001, 1e-9);
  EXPECT_EQ(least_span(0, {}), 1);
}

TEST(TimeWindow, AnAxisHasRoundNumbers) {
  EXPECT_THAT(axis_steps(TimeWindow(100), 5, {}), ElementsAre(0, 20, 40, 60, 80, 100));
  TimeWindow window(100'000);
  EXPECT_THAT(axis_steps(window, 4, {}), ElementsAre(0, 50'000, 100'000));
  window.show(4321.5, 4324.5);
  EXPECT_THAT(axis_steps(window, 10, {}), ElementsAre(4322, 4323, 4324));
  window.show(4321.2, 4321.4);
  EXPECT_TRUE(axis_steps(window, 10, {}).empty());
  window.show(4321.5, 4338.5);
  EXPECT_THAT(axis_steps(window, 1, {}), ElementsAre(4338)) << "the round numbers are outside";
  EXPECT_THAT(axis_steps(TimeWindow(0), 10, {}), ElementsAre(0, 1));
}

TEST(TimeWindow, AnAxisIsRoundInTheOtherEnginesSteps) {
  std::vector<std::string> steps;
  for (int k = -25; k < 35; ++k) steps.push_back(std::to_string(k));
  const GivenNames counted({}, steps);
  std::vector<std::string> labels;
  for (const std::uint32_t step : axis_steps(TimeWindow(60), 6, counted))
    labels.push_back(counted.step(step));
  EXPECT_THAT(labels, ElementsAre("-20", "-10", "0", "10", "20", "30"));
  const GivenNames gaps({}, {"3", "7", "20"});
  EXPECT_THAT(axis_steps(TimeWindow(3), 3, gaps), ElementsAre(1, 2, 3)) << "step 0 has no name";
}

}  // namespace
}  // namespace kerf
