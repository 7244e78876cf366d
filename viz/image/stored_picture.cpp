#include "viz/image/stored_picture.h"

#include <algorithm>
#include <set>

namespace kerf {
namespace {

const std::uint8_t* lower_half(const StoredPicture& picture) {
  return picture.lower.empty() ? picture.image.rgba.data() : picture.lower.data();
}

std::vector<PngChunk> chunks_of(const StoredPicture& picture, const std::string& type) {
  std::vector<PngChunk> chunks;
  std::ranges::copy_if(picture.chunks, std::back_inserter(chunks),
                       [&](const PngChunk& chunk) { return chunk.type == type; });
  return chunks;
}

}  // namespace

std::uint64_t count_different_lower(const StoredPicture& a, const StoredPicture& b) {
  const std::uint8_t* const lower_a = lower_half(a);
  const std::uint8_t* const lower_b = lower_half(b);
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < a.image.rgba.size(); i += 4) {
    const auto differs = [i](const std::uint8_t* p, const std::uint8_t* q) {
      return !std::equal(p + i, p + i + 4, q + i);
    };
    if (!differs(a.image.rgba.data(), b.image.rgba.data()) && differs(lower_a, lower_b)) ++count;
  }
  return count;
}

std::string different_chunks(const StoredPicture& a, const StoredPicture& b) {
  std::set<std::string> types;
  for (const StoredPicture* picture : {&a, &b})
    for (const PngChunk& chunk : picture->chunks) types.insert(chunk.type);
  std::string names;
  for (const std::string& type : types)
    if (chunks_of(a, type) != chunks_of(b, type)) names += (names.empty() ? "" : ", ") + type;
  return names;
}

}  // namespace kerf
