#include "frames/sequence/video.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

using Words = std::vector<std::string>;

/// What each kind of film is made with; what the file is called while it is made does not say its kind.
/// yuv420p is what players understand; it needs even sides, so an odd side gets one more row or column.
struct Format {
  const char* extension;
  std::string_view encoder;
  Words options;
};

const std::vector<Format>& formats() {
  static const Words h264{"-vf",       "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                          "-c:v",      "libx264",
                          "-preset",   "veryfast",
                          "-crf",      "20",
                          "-pix_fmt",  "yuv420p",
                          "-movflags", "+faststart"};
  const auto h264_in = [](const char* container) {
    Words words = h264;
    words.insert(words.end(), {"-f", container});
    return words;
  };
  // Each picture has its own 256 colours: one palette for all would need all of them in memory.
  static const std::vector<Format> all{
      {".mp4", "libx264", h264_in("mp4")},
      {".mkv", "libx264", h264_in("matroska")},
      {".mov", "libx264", h264_in("mov")},
      {".webm",
       "libvpx-vp9",
       {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-c:v", "libvpx-vp9", "-crf", "31", "-b:v", "0", "-deadline",
        "good", "-cpu-used", "5", "-row-mt", "1", "-pix_fmt", "yuv420p", "-f", "webm"}},
      {".gif",
       "gif",
       {"-vf", "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=none", "-loop",
        "0", "-f", "gif"}},
      {".apng", "apng", {"-c:v", "apng", "-pred", "up", "-pix_fmt", "rgb24", "-plays", "0", "-f", "apng"}},
  };
  return all;
}

const Format* format_of(const std::filesystem::path& path) {
  const auto format =
      std::ranges::find(formats(), path.extension().string(), [](const Format& f) { return f.extension; });
  return format == formats().end() ? nullptr : &*format;
}

/// A line of ffmpeg's list is " V....D libx264   description".
bool lists(const std::string& encoders, std::string_view name) {
  std::istringstream lines(encoders);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string flags;
    std::string encoder;
    if (words >> flags >> encoder && encoder == name) return true;
  }
  return false;
}

Words ffmpeg_arguments(const PartFile& part, PictureSize size, int rate) {
  const std::string pixels = std::to_string(size.width) + "x" + std::to_string(size.height);
  Words words{"ffmpeg", "-nostdin",   "-loglevel",          "error", "-y",
              "-f",     "rawvideo",   "-pixel_format",      "rgba",  "-video_size",
              pixels,   "-framerate", std::to_string(rate), "-i",    "pipe:0"};
  const Words& options = format_of(part.final_path())->options;
  words.insert(words.end(), options.begin(), options.end());
  words.push_back("file:" + part.path().string());
  return words;
}

/// Starts ffmpeg with `input` as its standard input and `log` as its output, in a process group of its own:
/// Ctrl-C at the terminal then reaches only this process, which ends ffmpeg in order.
int spawn_ffmpeg(std::vector<std::string> arguments, int input, int log, pid_t& process) {
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, log, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, log, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int error = posix_spawnp(&process, "ffmpeg", &files, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

std::filesystem::path in_writable_folder(const std::filesystem::path& path) {
  make_writable_folder(path.has_parent_path() ? path.parent_path() : ".", "--video");
  return path;
}

}  // namespace

Video::Video(const std::filesystem::path& path, PictureSize size, int frames_per_second, Replace replace)
    : part_(in_writable_folder(path), replace) {
  start(size, frames_per_second);
}

void Video::start(PictureSize size, int frames_per_second) {
  std::array<int, 2> ends{};
  log_ = ::memfd_create("ffmpeg-log", MFD_CLOEXEC);
  if (log_ < 0 || ::pipe2(ends.data(), O_CLOEXEC) != 0) {
    const int error = errno;
    if (log_ >= 0) ::close(log_);
    throw std::runtime_error(std::string("cannot start ffmpeg: ") + std::strerror(error));
  }
  pipe_ = ends[1];
  const int error = spawn_ffmpeg(ffmpeg_arguments(part_, size, frames_per_second), ends[0], log_, process_);
  ::close(ends[0]);
  if (error == 0) return;
  ::close(pipe_);
  ::close(log_);
  throw std::runtime_error(std::string("a film needs the program ffmpeg, which could not be started: ") +
                           std::strerror(error) + "; install it (on Debian: apt-get install ffmpeg)");
}

Video::~Video() {
  if (process_ > 0) ::kill(process_, SIGKILL);
  end();
  ::close(log_);
}

void Video::add(std::span<const std::uint8_t> rgba) {
  while (!rgba.empty()) {
    const ssize_t written = ::write(pipe_, rgba.data(), rgba.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail();
    rgba = rgba.subspan(static_cast<std::size_t>(written));
  }
}

void Video::finish() {
  if (!end() || has_complained()) fail();
  part_.keep();
}

bool Video::end() {
  if (pipe_ >= 0) ::close(pipe_);
  pipe_ = -1;
  if (process_ <= 0) return false;
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void Video::fail() {
  end();
  throw std::runtime_error("ffmpeg could not write " + part_.final_path().string() + ": " + last_words());
}

bool Video::has_complained() const { return ::lseek(log_, 0, SEEK_END) > 0; }

std::string Video::last_words() const {
  std::string text(4096, '\0');
  const off_t size = ::lseek(log_, 0, SEEK_END);
  const off_t from = std::max<off_t>(0, size - static_cast<off_t>(text.size()));
  const ssize_t got = ::pread(log_, text.data(), text.size(), from);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, got)));
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.empty() ? "it ended without a message" : text;
}

std::vector<std::string> Video::extensions_without_encoder(const std::string& encoders) {
  std::vector<std::string> missing;
  for (const Format& format : formats())
    if (!lists(encoders, format.encoder)) missing.emplace_back(format.extension);
  return missing;
}

void Video::check_extension(const std::filesystem::path& path) {
  if (format_of(path) != nullptr) return;
  throw UsageError("the film '" + path.string() +
                   "': give the file the extension .mp4, .mkv, .mov, .webm, .gif or .apng");
}

}  // namespace kerf
