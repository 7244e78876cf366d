#include <isa-l/igzip_lib.h>
#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "viz/image/png.h"
#include "viz/image/png_format.h"

namespace kerf {
namespace {

bool is_opaque(const Image& image) {
  std::uint32_t all = UINT32_MAX;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    std::uint32_t pixel = 0;
    std::memcpy(&pixel, &image.rgba[i], 4);
    all &= pixel;
  }
  std::array<std::uint8_t, 4> channels{};
  std::memcpy(channels.data(), &all, 4);
  return channels[3] == 255;
}

/// Uninitialised bytes: a vector would first fill them with zeros, which takes half as long as compressing
/// them.
struct RawBytes {
  explicit RawBytes(std::size_t count)
      : data(std::make_unique_for_overwrite<std::uint8_t[]>(count)), size(count) {}
  std::unique_ptr<std::uint8_t[]> data;
  std::size_t size;
};

/// Rows as PNG stores them: a filter byte and the pixels. The filter is "none": on our flat drawings the
/// compressor is faster without one, and its files are smaller.
RawBytes unfiltered_rows(const Image& image, std::size_t channels) {
  const auto width = static_cast<std::size_t>(image.width);
  RawBytes rows(static_cast<std::size_t>(image.height) * (1 + channels * width));
  std::uint8_t* out = rows.data.get();
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* pixel = image.pixel(0, y);
    *out++ = 0;
    if (channels == 4) {
      std::memcpy(out, pixel, 4 * width);
      out += 4 * width;
      continue;
    }
    // Four bytes at a time, the last of which the next pixel overwrites; it must not lie beyond the row.
    for (std::size_t x = 0; x + 1 < width; ++x, pixel += 4, out += 3) std::memcpy(out, pixel, 4);
    std::memcpy(out, pixel, 3);
    out += 3;
  }
  return rows;
}

/// ISA-L at level 0, whole images at once: a quarter of libdeflate's time (docs/RENDERING.md). At levels 1
/// and 2 what it makes of a picture can depend on where its memory lies (docs/notes/rendering.md).
RawBytes compress(RawBytes& bytes) {
  isal_zstream stream{};  // its initialisation leaves a part of it as it was, on which it depends
  isal_deflate_stateless_init(&stream);
  stream.level = 0;
  stream.gzip_flag = IGZIP_ZLIB;
  stream.end_of_stream = 1;
  stream.next_in = bytes.data.get();
  stream.avail_in = static_cast<std::uint32_t>(bytes.size);
  // Incompressible bytes are stored, in blocks of less than 64 kB with five bytes each.
  RawBytes result(bytes.size + bytes.size / 4096 + 4096);
  stream.next_out = result.data.get();
  stream.avail_out = static_cast<std::uint32_t>(result.size);
  if (isal_deflate_stateless(&stream) != COMP_OK) throw std::runtime_error("a picture cannot be compressed");
  result.size = stream.total_out;
  return result;
}

void append_u32(std::vector<std::uint8_t>& out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

void append_chunk(std::vector<std::uint8_t>& out, std::string_view type, std::span<const std::uint8_t> data) {
  append_u32(out, static_cast<std::uint32_t>(data.size()));
  const std::size_t start = out.size();
  out.insert(out.end(), type.begin(), type.end());
  out.insert(out.end(), data.begin(), data.end());
  append_u32(out, libdeflate_crc32(0, out.data() + start, out.size() - start));
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image) {
  const bool opaque = is_opaque(image);
  std::vector<std::uint8_t> header;
  append_u32(header, static_cast<std::uint32_t>(image.width));
  append_u32(header, static_cast<std::uint32_t>(image.height));
  constexpr std::uint8_t kDepth = 8;
  header.insert(header.end(), {kDepth, opaque ? png::kRgb : png::kRgba, 0, 0, 0});
  RawBytes rows = unfiltered_rows(image, opaque ? 3 : 4);
  const RawBytes data = compress(rows);
  std::vector<std::uint8_t> file(png::kSignature.begin(), png::kSignature.end());
  file.reserve(file.size() + data.size + 64);
  append_chunk(file, "IHDR", header);
  append_chunk(file, "IDAT", {data.data.get(), data.size});
  append_chunk(file, "IEND", {});
  return file;
}

void write_png(const std::filesystem::path& path, const Image& image, Replace replace, Sync sync) {
  if (image.width < 1 || image.height < 1 || image.width > kMaxImageSide || image.height > kMaxImageSide ||
      image.rgba.size() != image.stride() * static_cast<std::size_t>(image.height)) {
    throw std::runtime_error("cannot write " + path.string() + ": an image of " +
                             std::to_string(image.width) + "x" + std::to_string(image.height) +
                             " pixels and " + std::to_string(image.rgba.size()) + " bytes is none");
  }
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored))
    throw std::runtime_error("cannot write " + path.string() + ": it exists and is not a file");
  PartFile part(path, replace);
  part.write(encode_png(image));
  part.keep(sync);
}

std::uint64_t pixel_hash(const Image& image) {
  constexpr std::uint64_t kPrime = 0x9e3779b97f4a7c15U;
  const auto mix = [](std::uint64_t hash, std::uint64_t word) {
    hash = (hash ^ word) * kPrime;
    return hash ^ (hash >> 29U);
  };
  std::uint64_t hash =
      mix(mix(kPrime, static_cast<std::uint64_t>(image.width)), static_cast<std::uint64_t>(image.height));
  for (std::size_t i = 0; i < image.rgba.size(); i += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, image.rgba.data() + i, std::min(sizeof word, image.rgba.size() - i));
    hash = mix(hash, word);
  }
  return mix(hash, image.rgba.size());
}

}  // namespace kerf
