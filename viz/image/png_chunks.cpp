#include "viz/image/png_chunks.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

#include "core/base/counted.h"
#include "viz/image/png.h"
#include "viz/image/png_format.h"

namespace kerf {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kFrame = 12;  // length, type and checksum of a chunk

/// The pixels are what these say.
constexpr std::array<std::string_view, 5> kDecoded{"IHDR", "PLTE", "tRNS", "IDAT", "IEND"};
/// Words and dates: no program draws anything else because of them.
constexpr std::array<std::string_view, 4> kRemarks{"tEXt", "zTXt", "iTXt", "tIME"};

std::uint32_t read_u32(const std::uint8_t* p) {
  return std::uint32_t{p[0]} << 24U | std::uint32_t{p[1]} << 16U | std::uint32_t{p[2]} << 8U | p[3];
}

void check_header(const std::filesystem::path& path, const std::uint8_t* header, std::size_t compressed) {
  const std::uint32_t width = read_u32(header);
  const std::uint32_t height = read_u32(header + 4);
  if (width == 0 || height == 0 || width > kMaxImageSide || height > kMaxImageSide) {
    fail_to_read_png(path, "an image of " + std::to_string(width) + "x" + std::to_string(height) +
                               " pixels; 1 to " + std::to_string(kMaxImageSide) + " a side can be read");
  }
  // Deflate shrinks at most 1032 times: what promises more pixels than its data can hold is not believed.
  constexpr std::uint64_t kDeflateLimit = 1032;
  const std::uint64_t least_bytes = std::uint64_t{height} * (1 + width * std::uint64_t{header[8]} / 8);
  if (least_bytes > kDeflateLimit * (compressed + 1))
    fail_to_read_png(path, "it has fewer pixels than it claims");
}

/// The bytes of the chunk at `at`, its length, type and checksum included.
Bytes chunk_at(Bytes bytes, std::size_t at, const std::filesystem::path& path) {
  const auto truncated = [&] {
    fail_to_read_png(path, "the file is truncated (it ends after " + counted(bytes.size(), "byte") + ")");
  };
  if (bytes.size() - at < kFrame) truncated();
  const std::size_t length = read_u32(bytes.data() + at);
  if (length > bytes.size() - at - kFrame) truncated();
  const Bytes chunk = bytes.subspan(at, kFrame + length);
  if (read_u32(chunk.data() + 8 + length) != libdeflate_crc32(0, chunk.data() + 4, length + 4))
    fail_to_read_png(path, "it is damaged (checksum of chunk " +
                               std::string(chunk.data() + 4, chunk.data() + 8) + " at byte " +
                               std::to_string(at) + ")");
  return chunk;
}

}  // namespace

void fail_to_read_png(const std::filesystem::path& path, const std::string& reason) {
  throw std::runtime_error("cannot read " + path.string() + ": " + reason);
}

std::vector<PngChunk> walk_png_chunks(std::span<const std::uint8_t> bytes,
                                      const std::filesystem::path& path) {
  std::vector<PngChunk> unseen;
  std::size_t at = png::kSignature.size();
  std::size_t compressed = 0;
  bool has_pixels = false;
  const std::uint8_t* header = nullptr;
  for (std::string type; type != "IEND";) {
    const Bytes chunk = chunk_at(bytes, at, path);
    const Bytes data = chunk.subspan(8, chunk.size() - kFrame);
    type.assign(chunk.data() + 4, chunk.data() + 8);
    if (header == nullptr) {
      if (type != "IHDR" || data.size() != 13) fail_to_read_png(path, "it does not begin with a PNG header");
      header = data.data();
    }
    if (type == "IDAT") compressed += data.size();
    has_pixels |= type == "IDAT";
    if (!std::ranges::count(kDecoded, type) && !std::ranges::count(kRemarks, type))
      unseen.push_back({type, {data.begin(), data.end()}, has_pixels});
    at += chunk.size();
  }
  check_header(path, header, compressed);
  if (at != bytes.size())
    fail_to_read_png(path,
                     counted(bytes.size() - at, "byte follows", "bytes follow") + " the end of the picture");
  return unseen;
}

}  // namespace kerf
