#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "frames/bench/motion.h"

namespace kerf {

/// What of a scene decides which broad phase is fast. The size of an object is the mean of its box's extents.
struct SceneProperties {
  double objects = 0;  ///< present, on average over the steps
  double density = 0;  ///< pairs an object
  double speed = 0;    ///< the median way of the centre in a step, in sizes, of what moves
  double decades = 0;  ///< powers of ten from the size that 1 % do not exceed to the one that 99 % do not
  double resting = 0;  ///< share of the objects that keep their boxes in a step
  double churn = 0;    ///< objects that come and go in a step, as a share of those that are there
};

/// "1,000 objects, 1.9 pairs an object, 0.03 sizes a step, sizes over 0.3 decades, 12 % at rest"
std::string as_text(const SceneProperties& properties);
nlohmann::ordered_json as_json(const SceneProperties& properties);

/// Measures a motion step by step. Speeds and sizes are samples.
template <int D>
class PropertyMeter {
 public:
  /// The next step, and how many pairs it has.
  void add(const Motion<D>& motion, std::uint64_t pairs);
  [[nodiscard]] SceneProperties properties() const;

 private:
  void compare(const Box<D>& before, const Box<D>& now, bool sampled);

  std::vector<Box<D>> before_;
  std::vector<double> speeds_;
  std::vector<double> sizes_;
  std::uint64_t steps_ = 0;
  std::uint64_t objects_ = 0;  ///< these and the following: in all steps
  std::uint64_t pairs_ = 0;
  std::uint64_t compared_ = 0;  ///< that were there in the step before, too
  std::uint64_t resting_ = 0;
  std::uint64_t changes_ = 0;   ///< that came and went
  std::uint64_t changing_ = 0;  ///< objects in the steps that could have changes
};

}  // namespace kerf
