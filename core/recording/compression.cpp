#include "core/recording/compression.h"

#include <zstd.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace kerf {
namespace {

struct FreeContext {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
};

/// No block or keyframe is larger; a damaged length must not ask for all memory.
constexpr unsigned long long kLargest = 1ULL << 32U;

}  // namespace

Bytes compress(std::span<const std::uint8_t> bytes) {
  thread_local const std::unique_ptr<ZSTD_CCtx, FreeContext> context(ZSTD_createCCtx());
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, 1);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  Bytes frame(ZSTD_compressBound(bytes.size()));
  const std::size_t size =
      ZSTD_compress2(context.get(), frame.data(), frame.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(size) != 0)
    throw std::runtime_error(std::string("cannot compress a block: ") + ZSTD_getErrorName(size));
  frame.resize(size);
  return frame;
}

Bytes decompress(std::span<const std::uint8_t> frame) {
  const unsigned long long size = ZSTD_getFrameContentSize(frame.data(), frame.size());
  if (size > kLargest) throw std::runtime_error("the recording is damaged: a block is no Zstandard frame");
  Bytes bytes(size);
  const std::size_t got = ZSTD_decompress(bytes.data(), bytes.size(), frame.data(), frame.size());
  if (ZSTD_isError(got) != 0 || got != size)
    throw std::runtime_error("the recording is damaged: a block cannot be decompressed");
  return bytes;
}

}  // namespace kerf
