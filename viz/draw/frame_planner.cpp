#include "viz/draw/frame_planner.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "core/tree/criteria.h"

namespace kerf {
namespace {

constexpr std::uint32_t kLeastRamp = 16;

/// Where each object is stored, from the leaves' entries.
template <int D>
void find_placements(const Tree<D>& tree, std::size_t objects, std::vector<Placement>& placements) {
  placements.assign(objects, {});
  for_each_node(tree, tree.root(), [&](NodeId id) {
    if (!tree[id].is_leaf()) return;
    for (const Entry& entry : tree[id].entries) {
      if (entry.object.index() >= objects) continue;
      Placement& placement = placements[entry.object.index()];
      ++placement.leaves;
      placement.population = std::max(placement.population, tree[id].population);
    }
  });
}

}  // namespace

std::uint32_t end_of_ramp(std::uint32_t objects, const Config& config) {
  return std::bit_ceil(std::max(kLeastRamp, 4 * split_threshold(objects, config)));
}

template <int D>
const FramePlan<D>& FramePlanner<D>::plan(const FrameInput<D>& input) {
  view_box_.update(input.bodies);
  if (glides_) {
    glide_.go_on(view_box_.box(), view_box_.needed());
  } else {
    glide_.jump(view_box_.box());
  }
  plan_.bounds = framed();
  plan_.outside = count_outside(input.bodies, plan_.bounds);
  plan_.names_outside |= plan_.outside > 0;
  plan_.has_tree = input.tree != nullptr;
  observe(input);
  plan_.placements.clear();
  if (input.tree != nullptr && layers_.has(Layer::leaves))
    find_placements(*input.tree, input.bodies.size(), plan_.placements);
  plan_.highlights = highlights_.all();
  choose_largest_population();
  choose_samples(input.bodies.size());
  return plan_;
}

template <int D>
void FramePlanner<D>::observe(const FrameInput<D>& input) {
  std::swap(plan_.snapshot, before_);
  plan_.snapshot.assign(input.tree);
  std::swap(plan_.crowds, crowds_before_);
  plan_.crowds.clear();
  const Box<D> bounds = framed();
  if (D == 3 && input.tree != nullptr) plan_.crowds = find_crowds(*input.tree, input.bodies, bounds);
  highlights_.update(input, {plan_.snapshot, plan_.crowds}, {before_, crowds_before_}, bounds);
}

template <int D>
void FramePlanner<D>::forget() {
  plan_.snapshot.assign(nullptr);
  before_.assign(nullptr);
  plan_.crowds.clear();
  crowds_before_.clear();
  highlights_ = {};
}

template <int D>
void FramePlanner<D>::fix_view_box(const Box<D>& box) {
  view_box_.fix(box);
  glide_.jump(view_box_.box());
}

template <int D>
void FramePlanner<D>::fix_largest_population(std::uint32_t population) {
  plan_.largest_population = population;
  plan_.ramp_is_fixed = true;
}

/// Powers of two, and a gap between growing and shrinking: the ramp rarely changes.
template <int D>
void FramePlanner<D>::choose_largest_population() {
  if (plan_.ramp_is_fixed) return;
  const std::uint64_t present = plan_.snapshot.largest_leaf();
  const std::uint32_t wanted = std::bit_ceil(std::max(kLeastRamp, plan_.snapshot.largest_leaf()));
  if (wanted > plan_.largest_population || 5 * present < 2 * std::uint64_t{plan_.largest_population})
    plan_.largest_population = wanted;
}

/// Smooth edges cost three times as much. A sequence that has switched to jagged ones keeps them.
template <int D>
void FramePlanner<D>::choose_samples(std::size_t bodies) {
  if (wanted_samples_ != 0) {
    plan_.samples = wanted_samples_;
  } else {
    plan_.samples = plan_.samples == 1 || bodies >= kManyBodies ? 1 : 4;
  }
}

template class FramePlanner<2>;
template class FramePlanner<3>;

}  // namespace kerf
