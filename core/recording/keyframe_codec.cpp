#include "core/recording/keyframe_codec.h"

#include <utility>

#include "core/bsp/state_codec.h"
#include "core/recording/compression.h"

namespace kerf {

template <int D>
Bytes encode_keyframe(const BspState<D>& state) {
  return compress(encode_state(state), least_bytes(state));
}

template <int D>
BspState<D> decode_keyframe(std::span<const std::uint8_t> bytes,
                            std::shared_ptr<const Projector<D>> projector) {
  return decode_state<D>(decompress(bytes), bytes.size(), std::move(projector));
}

template <int D>
ObjectTable<D> decode_keyframe_objects(std::span<const std::uint8_t> bytes, VolumeKind kind) {
  return decode_state_objects<D>(decompress(bytes), bytes.size(), kind);
}

#define KERF_INSTANTIATE(D)                                                     \
  template Bytes encode_keyframe<D>(const BspState<D>&);                        \
  template BspState<D> decode_keyframe<D>(std::span<const std::uint8_t>,        \
                                          std::shared_ptr<const Projector<D>>); \
  template ObjectTable<D> decode_keyframe_objects<D>(std::span<const std::uint8_t>, VolumeKind);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
