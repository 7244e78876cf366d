#include <libdeflate.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "viz/image/png.h"
#include "viz/image/png_format.h"

// The only user of stb_image: the implementation lives here.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_MAX_DIMENSIONS 16384
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace kerf {
namespace {

static_assert(STBI_MAX_DIMENSIONS == kMaxImageSide);

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kMaxBytes = std::size_t{1} << 30U;  // the limit of stb_image; a device may be endless

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw std::runtime_error("cannot read " + path.string() + ": " + reason);
}

bool starts_like_png(Bytes bytes) {
  return bytes.size() >= png::kSignature.size() &&
         std::equal(png::kSignature.begin(), png::kSignature.end(), bytes.begin());
}

/// Reads no further than the first block if it is not a PNG.
std::vector<std::uint8_t> read_whole_file(const std::filesystem::path& path) {
  struct Close {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) fail(path, "it is a folder");
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  if (file == nullptr) fail(path, std::generic_category().message(errno));
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint8_t> block(1U << 16U);
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
    bytes.insert(bytes.end(), block.begin(), block.begin() + static_cast<std::ptrdiff_t>(count));
    if (!starts_like_png(bytes)) fail(path, "it is not a PNG");
    if (bytes.size() > kMaxBytes) break;
  }
  if (std::ferror(file.get()) != 0) fail(path, std::generic_category().message(errno));
  return bytes;
}

std::uint32_t read_u32(const std::uint8_t* p) {
  return std::uint32_t{p[0]} << 24U | std::uint32_t{p[1]} << 16U | std::uint32_t{p[2]} << 8U | p[3];
}

void check_header(const std::filesystem::path& path, const std::uint8_t* header, std::size_t compressed) {
  const std::uint32_t width = read_u32(header);
  const std::uint32_t height = read_u32(header + 4);
  if (width == 0 || height == 0 || width > kMaxImageSide || height > kMaxImageSide) {
    fail(path, "an image of " + std::to_string(width) + "x" + std::to_string(height) + " pixels; 1 to " +
                   std::to_string(kMaxImageSide) + " a side can be read");
  }
  // Deflate shrinks at most 1032 times: a header that promises more pixels than its data can hold is refused.
  constexpr std::uint64_t kDeflateLimit = 1032;
  const std::uint64_t least_bytes = std::uint64_t{height} * (1 + width * std::uint64_t{header[8]} / 8);
  if (least_bytes > kDeflateLimit * (compressed + 1)) fail(path, "it has fewer pixels than it claims");
}

/// Walks the chunks: they must be whole and undamaged, begin with a possible header and end with IEND.
void check_chunks(const std::filesystem::path& path, Bytes bytes) {
  const auto truncated = [&path, &bytes] {
    fail(path, "the file is truncated (it ends after " + std::to_string(bytes.size()) + " bytes)");
  };
  constexpr std::size_t kFrame = 12;  // length, type and checksum of a chunk
  std::size_t at = png::kSignature.size();
  std::size_t compressed = 0;
  const std::uint8_t* header = nullptr;
  for (bool end = false; !end;) {
    if (bytes.size() - at < kFrame) truncated();
    const std::uint8_t* chunk = bytes.data() + at;
    const std::size_t length = read_u32(chunk);
    if (length > bytes.size() - at - kFrame) truncated();
    const std::string type(chunk + 4, chunk + 8);
    if (read_u32(chunk + 8 + length) != libdeflate_crc32(0, chunk + 4, length + 4))
      fail(path, "it is damaged (checksum of chunk " + type + " at byte " + std::to_string(at) + ")");
    if (header == nullptr) {
      if (type != "IHDR" || length != 13) fail(path, "it does not begin with a PNG header");
      header = chunk + 8;
    }
    // Allowed, but no program writes it, and stb_image copies it to nowhere.
    if (type == "IDAT" && length == 0) fail(path, "a chunk of its picture data is empty");
    if (type == "IDAT") compressed += length;
    end = type == "IEND";
    at += kFrame + length;
  }
  check_header(path, header, compressed);
}

}  // namespace

Image read_png(const std::filesystem::path& path) { return read_png(read_whole_file(path), path); }

Image read_png(std::span<const std::uint8_t> bytes, const std::filesystem::path& path) {
  if (bytes.empty()) fail(path, "the file is empty");
  if (bytes.size() > kMaxBytes) fail(path, "the file is too long for a PNG");
  if (!starts_like_png(bytes)) fail(path, "it is not a PNG");
  check_chunks(path, bytes);
  Image image;
  struct Free {
    void operator()(stbi_uc* p) const { stbi_image_free(p); }
  };
  int channels = 0;
  const std::unique_ptr<stbi_uc, Free> pixels(stbi_load_from_memory(
      bytes.data(), static_cast<int>(bytes.size()), &image.width, &image.height, &channels, 4));
  if (pixels == nullptr) fail(path, std::string("it is damaged (") + stbi_failure_reason() + ")");
  image.rgba.assign(pixels.get(), pixels.get() + image.stride() * static_cast<std::size_t>(image.height));
  return image;
}

}  // namespace kerf
