#include "core/recording/compression.h"

#include <zstd.h>
#include <zstd_errors.h>

#include <algorithm>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

#include "core/base/counted.h"

namespace kerf {
namespace {

struct FreeContext {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
};

// The most bytes that a reader accepts for so many compressed ones. Boxes compress by less than ten, boxes at
// rest by thousands: such blocks are padded, which costs a few bytes a step.
constexpr std::size_t kAlwaysBelieved = std::size_t{64} << 10U;
constexpr std::size_t kBelievedRatio = 256;

std::size_t least_size(std::size_t content) {
  return content <= kAlwaysBelieved ? 0 : (content - kAlwaysBelieved + kBelievedRatio - 1) / kBelievedRatio;
}

/// Says nothing of the bytes.
void refuse_lack_of_memory(std::size_t result) {
  if (ZSTD_getErrorCode(result) == ZSTD_error_memory_allocation) throw std::bad_alloc();
}

/// Appends a skippable frame, so that there are at least `least` bytes.
void pad(Bytes& frame, std::size_t least) {
  constexpr std::size_t kHeader = 8;
  if (frame.size() >= least) return;
  const std::size_t zeros = std::max(least - frame.size(), kHeader) - kHeader;
  ByteWriter header;
  header.u32(ZSTD_MAGIC_SKIPPABLE_START);
  header.u32(static_cast<std::uint32_t>(zeros));
  frame.insert(frame.end(), header.bytes().begin(), header.bytes().end());
  frame.resize(frame.size() + zeros);
}

}  // namespace

Bytes compress(std::span<const std::uint8_t> bytes, std::size_t least) {
  thread_local std::unique_ptr<ZSTD_CCtx, FreeContext> context;
  if (!context) context.reset(ZSTD_createCCtx());
  if (!context) throw std::bad_alloc();
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, 1);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  Bytes frame(ZSTD_compressBound(bytes.size()));
  const std::size_t size =
      ZSTD_compress2(context.get(), frame.data(), frame.size(), bytes.data(), bytes.size());
  refuse_lack_of_memory(size);
  if (ZSTD_isError(size) != 0)
    throw std::runtime_error(std::string("cannot compress a block: ") + ZSTD_getErrorName(size));
  frame.resize(size);
  pad(frame, std::max(least, least_size(bytes.size())));
  return frame;
}

Bytes decompress(std::span<const std::uint8_t> frames) {
  const unsigned long long size = ZSTD_getFrameContentSize(frames.data(), frames.size());
  if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN)
    fail_damaged("a block is no Zstandard frame");
  if (size > kAlwaysBelieved && frames.size() < least_size(size))
    fail_damaged("a block of " + counted(frames.size(), "byte") + " says that it holds " +
                 std::to_string(size));
  Bytes bytes(size);
  const std::size_t got = ZSTD_decompress(bytes.data(), bytes.size(), frames.data(), frames.size());
  refuse_lack_of_memory(got);
  if (ZSTD_isError(got) != 0 || got != size) fail_damaged("a block cannot be decompressed");
  return bytes;
}

}  // namespace kerf
