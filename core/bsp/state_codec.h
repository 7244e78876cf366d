#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "core/base/bytes.h"
#include "core/bsp/bsp_state.h"

namespace kerf {

/// A state as bytes, without the pairs of its step: equal for equal states.
template <int D>
Bytes encode_state(const BspState<D>& state);

/// How many bytes must be kept of a state: a reader refuses to make room for many objects out of fewer.
template <int D>
std::size_t least_bytes(const BspState<D>& state);

/// The reverse of `encode_state`, for a tree with this projector. `size`: how many bytes were kept; fewer, if
/// they were compressed. Throws Damage for bytes that are no state, and for states that no tree has between
/// two steps.
template <int D>
BspState<D> decode_state(std::span<const std::uint8_t> bytes, std::size_t size,
                         std::shared_ptr<const Projector<D>> projector);

/// Only the objects of a state, as the caller of the tree sees them.
template <int D>
ObjectTable<D> decode_state_objects(std::span<const std::uint8_t> bytes, std::size_t size, VolumeKind kind);

}  // namespace kerf
