#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/files/part_file.h"
#include "frames/support/picture_size.h"

namespace kerf {

/// Encodes pictures to a film, of the kind that the extension says, by the program ffmpeg, fed through a
/// pipe. The file gets its name only in `finish()`; without it nothing is left behind, and a film that had
/// the name before is untouched (PartFile).
///
/// Errors are std::runtime_error with what ffmpeg said. SIGPIPE must be ignored while one lives
/// (InterruptGuard).
class Video {
 public:
  /// Starts ffmpeg. Throws if it is not installed or the folder of `path` cannot be written.
  Video(const std::filesystem::path& path, PictureSize size, int frames_per_second, Replace replace);
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  /// One picture: rows from the top, 4 bytes RGBA a pixel.
  void add(std::span<const std::uint8_t> rgba);
  /// Waits for ffmpeg and gives the film its name.
  void finish();

  /// Throws UsageError unless the extension is one of .mp4, .mkv, .mov (H.264), .webm (VP9), .gif and .apng.
  static void check_extension(const std::filesystem::path& path);

  /// The extensions of films that an ffmpeg cannot make whose list of encoders (`ffmpeg -encoders`) this is.
  static std::vector<std::string> extensions_without_encoder(const std::string& encoders);

 private:
  void start(PictureSize size, int frames_per_second);
  /// Closes the pipe and waits; true if ffmpeg was content.
  bool end();
  /// On a full disk ffmpeg prints an error and still ends with success.
  [[nodiscard]] bool has_complained() const;
  [[noreturn]] void fail();
  [[nodiscard]] std::string last_words() const;

  PartFile part_;
  pid_t process_ = -1;
  int pipe_ = -1;
  int log_ = -1;
};

}  // namespace kerf
