#include "frames/sequence/pane_of.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/broad_phase/describe.h"

namespace kerf {

template <int D>
StructurePane<D> pane_of(const std::string& name, const BroadPhase<D>& broad_phase,
                         std::span<const Body<D>> bodies, const Box<D>& bounds,
                         std::optional<double> milliseconds) {
  StructurePane<D> pane;
  pane.name = name;
  pane.parts = describe(broad_phase);
  pane.pairs.assign(broad_phase.pairs().begin(), broad_phase.pairs().end());
  std::ranges::sort(pane.pairs);
  pane.rejected = rejected_of(std::exchange(pane.parts.tested, {}), pane.pairs);
  std::vector<Box<D>> boxes;
  boxes.reserve(bodies.size());
  for (const Body<D>& body : bodies) boxes.push_back(body.box);
  pane.figures = {pane.parts.tests, pane.pairs.size(), measure<D>(pane.parts, boxes, bounds),
                  pane.parts.bytes, milliseconds};
  return pane;
}

template StructurePane<2> pane_of(const std::string&, const BroadPhase<2>&, std::span<const Body<2>>,
                                  const Box<2>&, std::optional<double>);
template StructurePane<3> pane_of(const std::string&, const BroadPhase<3>&, std::span<const Body<3>>,
                                  const Box<3>&, std::optional<double>);

}  // namespace kerf
