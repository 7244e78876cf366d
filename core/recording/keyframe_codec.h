#pragma once

#include <memory>
#include <span>

#include "core/base/bytes.h"
#include "core/bsp/bsp_state.h"

namespace kerf {

/// A keyframe: a compressed state.
template <int D>
Bytes encode_keyframe(const BspState<D>& state);

/// The reverse, for a tree with this projector. Throws std::runtime_error for damaged bytes, and for states
/// that no tree has between two steps.
template <int D>
BspState<D> decode_keyframe(std::span<const std::uint8_t> bytes,
                            std::shared_ptr<const Projector<D>> projector);

/// Only the objects of a keyframe, as the caller of the tree sees them.
template <int D>
ObjectTable<D> decode_keyframe_objects(std::span<const std::uint8_t> bytes, VolumeKind kind);

}  // namespace kerf
