#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/files/part_file.h"
#include "viz/image/image.h"

namespace kerf {

/// Collects about twenty frames, evenly chosen from a sequence, into one picture.
class ContactStrip {
 public:
  explicit ContactStrip(std::uint32_t frames) : frames_(frames) {}

  /// Whether the picture of frame `index` is needed.
  [[nodiscard]] bool is_chosen(std::uint32_t index) const;
  /// Takes a small copy of frame `index` if it is one of the chosen ones.
  void offer(std::uint32_t index, const Image& image);
  /// Throws std::runtime_error with path and reason.
  void save(const std::filesystem::path& path, Replace replace) const;

 private:
  std::uint32_t frames_;
  std::vector<Image> thumbs_;
};

}  // namespace kerf
