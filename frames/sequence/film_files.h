#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "frames/sequence/contact_strip.h"
#include "frames/sequence/video.h"
#include "frames/support/outputs.h"
#include "frames/support/picture_size.h"

namespace kerf {

/// The files that are made from the pictures of a sequence.
struct FilmRequest {
  std::filesystem::path video;          ///< empty: none
  std::filesystem::path contact_sheet;  ///< empty: none
  int fps = 25;
  Replace replace = Replace::nothing;

  [[nodiscard]] bool wants_any() const { return !video.empty() || !contact_sheet.empty(); }
};

/// From the options of those names, empty ones not given. Throws UsageError for a file that cannot be.
/// Touches no file.
FilmRequest parse_film_request(const std::string& video, const std::string& fps,
                               const std::string& contact_sheet, bool overwrite);

/// Throws UsageError if one of the files may not be written.
void add_outputs(const FilmRequest& request, Outputs& outputs);

/// Makes film and contact sheet from the pictures of a sequence.
class FilmFiles {
 public:
  /// Throws std::runtime_error if there can be no such files.
  FilmFiles(const FilmRequest& request, PictureSize size, std::uint32_t frames);

  /// Whether `add` looks at the pixels of that frame.
  [[nodiscard]] bool wants(std::uint32_t index) const {
    return video_ || (!request_.contact_sheet.empty() && strip_.is_chosen(index));
  }
  /// Frames come in their order.
  void add(std::uint32_t index, const Image& image);
  /// Gives the files their names.
  void finish();
  [[nodiscard]] bool has_video() const { return video_.has_value(); }

 private:
  FilmRequest request_;
  ContactStrip strip_;
  std::optional<Video> video_;
};

}  // namespace kerf
