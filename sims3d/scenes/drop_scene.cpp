#include "sims3d/scenes/drop_scene.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/scene/nudge.h"
#include "sims3d/scenes/random_body.h"

namespace kerf {
namespace {

constexpr std::uint32_t kMaxObjects = 100'000;
constexpr std::uint32_t kMaxSteps = 1'000'000;
constexpr double kJitter = 0.45;  // keeps neighbours and walls clear, and heaps from becoming towers
constexpr double kSpin = 3;
constexpr double kWindow = 0.3;  // of a shower, in which the drops of one site fall
constexpr float kDropSpeed = 8;
constexpr float kFallPerStep = kDropSpeed * 0.04F;
constexpr float kClearance = 2;  // between the centres of two objects that appear on one site

void limit(std::uint32_t value, std::uint32_t maximum, const char* what) {
  if (value <= maximum) return;
  throw std::invalid_argument(std::to_string(value) + " " + what + " are too many: at most " +
                              std::to_string(maximum) + " are possible");
}

Twist random_fall(Random& random) { return {{{0, -kDropSpeed, 0}}, random_vector(random, kSpin)}; }

}  // namespace

SceneOptions resolve(const SceneOptions& options, std::uint32_t default_objects,
                     std::uint32_t default_steps) {
  limit(options.objects, kMaxObjects, "objects");
  limit(options.steps, kMaxSteps, "steps of growth");
  SceneOptions resolved = options;
  if (resolved.objects == 0) resolved.objects = default_objects;
  if (resolved.steps == 0) resolved.steps = default_steps;
  return resolved;
}

DropScene::DropScene(BroadPhase<3>& broad_phase, const Needs& needs, std::uint64_t seed, Drop drop)
    : WorldScene(broad_phase, needs, seed, drop.physics),
      random_(seed),
      drop_(std::move(drop)),
      last_height_(drop_.sites.size(), std::numeric_limits<float>::lowest()),
      last_step_(drop_.sites.size(), 0) {
  if (drop_.sites.empty() || drop_.steps == 0 || drop_.objects == 0)
    throw std::invalid_argument("a drop needs objects, sites and steps");
}

std::uint32_t DropScene::due(std::uint32_t step) const {
  if (step >= drop_.steps) return drop_.objects;
  const std::uint64_t numerator = std::uint64_t{drop_.objects} * step;
  return static_cast<std::uint32_t>((numerator + drop_.steps - 1) / drop_.steps);
}

void DropScene::act() {
  const std::uint32_t wanted = due(step() + 1);
  while (dropped_.size() < wanted) drop_one();
  put_back_strays();
  recycle();
}

/// Keeps a full scene in motion: the oldest object is taken out of the heap and falls again.
void DropScene::recycle() {
  if (drop_.recycle == 0 || step() < drop_.steps || step() % drop_.recycle != 0) return;
  drop_anew(dropped_[recycled_++ % dropped_.size()]);
}

void DropScene::drop_anew(ObjectId object) {
  const Twist motion = random_fall(random_);
  world().place(object, next_place(), motion);
}

void DropScene::drop_one() {
  const Shape<3> shape = random_shape(random_);
  const auto axes = random_turn(random_);
  const Twist motion = random_fall(random_);
  const Vector<3> place = nudged(next_place(), dropped_.empty() ? drop_.nudge : 0);
  dropped_.push_back(world().add_moving(shape, {place, axes}, motion));
}

/// Uses the poses of the step before: one step late is soon enough.
void DropScene::put_back_strays() {
  for (const ObjectId object : dropped_) {
    const Vector<3> center = bodies()[object.index()].pose.position;
    if (contains(drop_.inside, {center, center})) continue;
    drop_anew(object);
    ++put_back_;
  }
}

Vector<3> DropScene::next_place() {
  if (next_ == shower_.size()) plan_shower();
  const std::size_t site = shower_[next_++];
  Vector<3> place = drop_.sites[site];
  place[0] += static_cast<Scalar>(random_.uniform(-kJitter, kJitter));
  place[2] += static_cast<Scalar>(random_.uniform(-kJitter, kJitter));
  // The last object that appeared here has fallen at least this far, unless something was in its way.
  const float fallen = kFallPerStep * static_cast<float>(step() - last_step_[site]);
  place[1] = std::max(place[1], last_height_[site] - fallen + kClearance);
  last_height_[site] = place[1];
  last_step_[site] = step();
  return place;
}

/// A site's drops are spread over a window of the shower that begins when the shower reaches the site.
void DropScene::plan_shower() {
  const std::size_t sites = drop_.sites.size();
  const std::size_t drops_a_site = (drop_.objects + sites - 1) / sites;
  std::vector<std::pair<double, std::uint32_t>> drops;  // when, where
  drops.reserve(sites * drops_a_site);
  for (std::uint32_t site = 0; site < sites; ++site) {
    const double reached = static_cast<double>(site) / static_cast<double>(sites);
    for (std::size_t i = 0; i < drops_a_site; ++i)
      drops.emplace_back(reached + kWindow * random_.unit(), site);
  }
  std::sort(drops.begin(), drops.end());
  shower_.clear();
  for (const auto& [when, site] : drops) shower_.push_back(site);
  next_ = 0;
}

}  // namespace kerf
