#include "frames/bench/scene_properties.h"

#include <algorithm>
#include <cmath>

#include "core/base/median.h"
#include "frames/bench/bench_row.h"
#include "frames/page/json.h"
#include "frames/support/printed.h"

namespace kerf {
namespace {

template <int D>
double size_of(const Box<D>& box) {
  double sum = 0;
  for (int i = 0; i < D; ++i) sum += static_cast<double>(box.max[i]) - box.min[i];
  return sum / D;
}

template <int D>
double way_between(const Box<D>& a, const Box<D>& b) {
  double square = 0;
  for (int i = 0; i < D; ++i) {
    const double way = (static_cast<double>(b.min[i]) - a.min[i] + b.max[i] - a.max[i]) / 2;
    square += way * way;
  }
  return std::sqrt(square);
}

/// Two digits, and those before the point if there are more.
std::string two_digits(double x) { return x >= 10 ? printed("%.0f", x) : printed("%.2g", x); }

double ratio_of(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

double sorted_share(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return percentile(values, share);
}

}  // namespace

std::string as_text(const SceneProperties& p) {
  std::string text = printed(
      "%.0f objects, %s pairs an object, %s sizes a step, sizes over %.1f decades, %.0f %% at rest",
      p.objects, two_digits(p.density).c_str(), two_digits(p.speed).c_str(), p.decades, 100 * p.resting);
  if (p.churn != 0) text += ", " + two_digits(100 * p.churn) + " % come and go in a step";
  return text;
}

nlohmann::ordered_json as_json(const SceneProperties& p) {
  return {{"objects", p.objects}, {"density", p.density}, {"speed", p.speed},
          {"decades", p.decades}, {"resting", p.resting}, {"churn", p.churn}};
}

template <int D>
void PropertyMeter<D>::add(const Motion<D>& motion, std::uint64_t pairs) {
  constexpr std::size_t kSamples = 256;
  const std::span<const Box<D>> boxes = motion.boxes();
  const std::size_t stride = boxes.size() / kSamples + 1;
  const bool is_first = before_.empty();
  const std::uint64_t objects = objects_;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    if (is_absent(boxes[k])) continue;
    ++objects_;
    const bool sampled = (k + steps_) % stride == 0;
    if (sampled) sizes_.push_back(size_of(boxes[k]));
    if (!is_first && !is_absent(before_[k])) compare(before_[k], boxes[k], sampled);
  }
  ++steps_;
  pairs_ += pairs;
  if (!is_first) {
    changes_ += motion.inserted().size() + motion.removed().size();
    changing_ += objects_ - objects;
  }
  before_.assign(boxes.begin(), boxes.end());
}

template <int D>
void PropertyMeter<D>::compare(const Box<D>& before, const Box<D>& now, bool sampled) {
  ++compared_;
  if (now == before) {
    ++resting_;
  } else if (const double size = size_of(now); sampled && size > 0) {
    speeds_.push_back(way_between(before, now) / size);
  }
}

template <int D>
SceneProperties PropertyMeter<D>::properties() const {
  SceneProperties found;
  found.objects = ratio_of(objects_, steps_);
  found.density = ratio_of(pairs_, objects_);
  found.speed = median(speeds_);
  const double least = sorted_share(sizes_, 0.01);
  if (least > 0) found.decades = std::log10(sorted_share(sizes_, 0.99) / least);
  found.resting = ratio_of(resting_, compared_);
  found.churn = ratio_of(changes_, changing_);
  return found;
}

template class PropertyMeter<2>;
template class PropertyMeter<3>;

}  // namespace kerf
