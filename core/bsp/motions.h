#pragma once

#include <cstdint>

#include "core/base/config.h"
#include "core/bsp/requests.h"

namespace kerf {

/// How objects move, by a sample of them.
struct Motions {
  float speed = 0;  ///< mean of speed over size; objects too fast for any skin count as if they stood
  float fast = 0;   ///< the share of those. If the tree does not follow them, they count as others do
};

/// The objects that left their fat boxes in a step.
struct Leaving {
  float share = 0;  ///< of all objects
  Motions motions;  ///< of those that left; sampled only where they are many
};

/// The motions of at most `count` objects from the tree's boxes to the latest ones. Each step samples other
/// objects, so that a sample that happens to miss the fast ones is not believed twice. Where most ids have no
/// object, those that changed are sampled: the others stood.
template <int D>
Motions sample_motions(const Requests<D>& requests, const ObjectTable<D>& tree, const Config& config,
                       std::uint32_t step, std::uint32_t count);

/// Of the changed objects of a step with kept pairs.
template <int D>
Leaving sample_leaving(const Requests<D>& requests, const Config& config);

/// Whether most objects of a sample moved so far that few of them can stay in their leaves.
template <int D>
bool most_jump(const ObjectTable<D>& latest, const ObjectTable<D>& tree);

}  // namespace kerf
