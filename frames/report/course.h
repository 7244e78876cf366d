#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/objects/broad_phase.h"
#include "frames/bench/motion.h"
#include "frames/page/cell.h"

namespace kerf {

/// The boxes of a run, step by step, with the true pairs: all settings are measured on them.
template <int D>
struct Course {
  struct Step {
    std::vector<ObjectId> moved;
    std::vector<Box<D>> boxes;  ///< of those that moved
    std::vector<Pair> truth;    ///< by brute force, sorted
  };
  std::uint32_t moving = 0;   ///< objects below this number are moving, the others fixed
  std::vector<Box<D>> first;  ///< all boxes before the first step
  std::uint32_t warm_up = 0;  ///< steps at the beginning that do not count
  std::vector<Step> steps;
};

/// `warm_up` and then `steps` steps of a motion.
template <int D>
Course<D> record(Motion<D>& motion, std::uint32_t warm_up, std::uint32_t steps, const Poll& poll);

/// Runs a broad phase over the course: once to judge it, then `rounds` times to time it. The figures are
/// those of `StepTimes` (an object and step), of `Meetings`, and "true_pairs", "reported" (the reported
/// pairs), "missed" and "extra", in all steps that count, with "missed_share" and "extra_share" of the true
/// pairs.
template <int D>
Json run_course(const Course<D>& course, const std::function<std::unique_ptr<BroadPhase<D>>()>& make,
                std::uint32_t rounds, const Poll& poll);

}  // namespace kerf
