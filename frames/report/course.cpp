#include "frames/report/course.h"

#include <algorithm>

#include "core/replay/oracle.h"
#include "frames/bench/truth.h"
#include "frames/report/figures.h"
#include "frames/report/meetings.h"
#include "frames/rivals/step_timer.h"

namespace kerf {
namespace {

std::vector<ObjectId> first_objects(std::uint32_t count) {
  std::vector<ObjectId> objects(count);
  for (std::uint32_t k = 0; k < count; ++k) objects[k] = {k};
  return objects;
}

template <int D>
void begin(BroadPhase<D>& broad_phase, const Course<D>& course) {
  for (std::uint32_t k = 0; k < course.first.size(); ++k)
    static_cast<void>(
        broad_phase.insert({k}, course.first[k], k < course.moving ? Mobility::moving : Mobility::fixed));
  broad_phase.step();
}

template <int D>
void advance(BroadPhase<D>& broad_phase, const typename Course<D>::Step& step) {
  static_cast<void>(broad_phase.move_many(step.moved, step.boxes));
  broad_phase.step();
}

/// Wrong and late reports.
template <int D>
Json judge(const Course<D>& course, BroadPhase<D>& broad_phase, const Poll& poll) {
  Difference errors;
  Meetings meetings;
  std::uint64_t truth = 0;
  std::uint64_t reported = 0;
  begin(broad_phase, course);
  for (std::size_t s = 0; s < course.steps.size(); ++s) {
    poll();
    advance(broad_phase, course.steps[s]);
    if (s < course.warm_up) continue;
    const std::vector<Pair> found = sorted_pairs(broad_phase.pairs());
    const Difference difference = compare(found, course.steps[s].truth);
    errors.missed += difference.missed;
    errors.extra += difference.extra;
    truth += course.steps[s].truth.size();
    reported += found.size();
    meetings.add(course.steps[s].truth, found);
  }
  const double of = std::max<double>(1, static_cast<double>(truth));
  Json figures{{"true_pairs", truth},
               {"reported", reported},
               {"missed", errors.missed},
               {"extra", errors.extra},
               {"missed_share", static_cast<double>(errors.missed) / of},
               {"extra_share", static_cast<double>(errors.extra) / of}};
  figures.update(meetings.figures());
  return figures;
}

template <int D>
void time_round(const Course<D>& course, BroadPhase<D>& broad_phase, StepTimes& times, const Poll& poll) {
  times.restart();
  begin(broad_phase, course);
  for (std::size_t s = 0; s < course.steps.size(); ++s) {
    poll();
    const StepTimer timer(true);
    advance(broad_phase, course.steps[s]);
    if (s >= course.warm_up) times.add(static_cast<double>(timer.nanoseconds()));
  }
}

}  // namespace

template <int D>
Course<D> record(Motion<D>& motion, std::uint32_t warm_up, std::uint32_t steps, const Poll& poll) {
  Course<D> course;
  course.moving = motion.moving();
  course.first.assign(motion.boxes().begin(), motion.boxes().end());
  course.warm_up = warm_up;
  const std::vector<ObjectId> all = first_objects(motion.moving());
  for (std::uint32_t s = 0; s < warm_up + steps; ++s) {
    poll();
    motion.advance();
    typename Course<D>::Step step;
    const std::span<const ObjectId> moved =
        motion.all_move() ? std::span<const ObjectId>(all) : motion.moved();
    step.moved.assign(moved.begin(), moved.end());
    for (const ObjectId object : moved) step.boxes.push_back(motion.boxes()[object.index()]);
    if (s >= warm_up) step.truth = sorted_pairs(confirmed_pairs(motion.boxes(), motion.moving()));
    course.steps.push_back(std::move(step));
  }
  return course;
}

template <int D>
Json run_course(const Course<D>& course, const std::function<std::unique_ptr<BroadPhase<D>>()>& make,
                std::uint32_t rounds, const Poll& poll) {
  StepTimes times;
  for (std::uint32_t round = 0; round < rounds; ++round) time_round(course, *make(), times, poll);
  Json figures = as_json(times.over(static_cast<double>(course.first.size())));
  figures.update(judge(course, *make(), poll));
  return figures;
}

template Course<2> record(Motion<2>&, std::uint32_t, std::uint32_t, const Poll&);
template Course<3> record(Motion<3>&, std::uint32_t, std::uint32_t, const Poll&);
template Json run_course(const Course<2>&, const std::function<std::unique_ptr<BroadPhase<2>>()>&,
                         std::uint32_t, const Poll&);
template Json run_course(const Course<3>&, const std::function<std::unique_ptr<BroadPhase<3>>()>&,
                         std::uint32_t, const Poll&);

}  // namespace kerf
