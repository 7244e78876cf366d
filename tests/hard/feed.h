#pragma once

#include "core/objects/broad_phase.h"
#include "tests/hard/script.h"

namespace kerf::test {

/// What a broad phase of some volume kind is given for the boxes of a script.
enum class Feed : std::uint8_t {
  boxes,  ///< the boxes, which it encloses itself
  posed,  ///< volumes of its kind around a brick of the box's size that is turned, differently for each
          ///< object
};

/// The volume that `posed` gives. Where the request has a margin, the volume reaches that far beyond the
/// brick while its box stays the request's.
template <int D>
Volume<D> posed_volume(VolumeKind kind, const Request<D>& request);

/// Makes one request.
template <int D>
Status ask(BroadPhase<D>& broad_phase, const Request<D>& request, Feed feed);

}  // namespace kerf::test
