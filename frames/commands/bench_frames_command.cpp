#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <exception>
#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/base/counted.h"
#include "frames/bench_frames/frame_loops.h"
#include "frames/commands/command.h"
#include "frames/page/json.h"
#include "frames/support/atomic_file.h"
#include "frames/support/errors.h"
#include "frames/support/interrupt.h"
#include "frames/support/machine.h"
#include "frames/support/outputs.h"
#include "frames/support/parse_number.h"
#include "frames/support/progress.h"
#include "frames/support/result_file.h"
#include "frames/support/scratch_folder.h"

namespace kerf {
namespace {

/// The time of a piece of work, all its processes together.
struct ProcessTimes {
  double wall = 0;  ///< seconds
  double cpu = 0;   ///< of all processors
};

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Does the work in a process of its own, so that it inherits no GL, threads or memory. Throws
/// std::runtime_error if it fails; Interrupted after SIGINT or SIGTERM.
ProcessTimes run_timed(const std::function<void()>& work) {
  std::fflush(nullptr);
  const auto start = std::chrono::steady_clock::now();
  const pid_t process = fork();
  if (process < 0) throw std::runtime_error("no process can be made");
  if (process == 0) {
    try {
      work();
      _exit(0);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "kerf: %s\n", error.what());
      _exit(1);
    }
  }
  int status = 0;
  rusage usage{};
  while (wait4(process, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::runtime_error("the process that draws did not end well");
  return {wall.count(), seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

/// The first frames include starting up; they are measured alone and subtracted.
constexpr std::uint32_t kWarmUp = 4;
/// Two starts of a process differ by up to 20 ms, so less than this is noise, or below zero.
constexpr double kLeastSeconds = 0.05;
constexpr std::uint32_t kMostFrames = 100'000;

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

/// Times of one frame, in milliseconds.
struct Row {
  FrameLoop loop;
  double naive = 0;
  double pipeline = 0;
  double floor = 0;  ///< processor time by cores: no order of work could be faster
  double encoding = 0;
  double encoding_share = 0;  ///< of the processor time
};

std::uint32_t frames_for(std::uint32_t boxes) { return boxes > 50'000 ? 12 : boxes > 5'000 ? 40 : 60; }

[[noreturn]] void refuse(const FrameLoop& loop) {
  throw std::runtime_error(counted(loop.frames, "frame") + " of " + std::to_string(loop.size.width) + "x" +
                           std::to_string(loop.size.height) + " with " + counted(loop.boxes, "box", "boxes") +
                           ": too little to measure, since it takes less than starting up varies by; give "
                           "more --frames, or larger --sizes");
}

/// The better of two, because other programs only ever add to a time.
ProcessTimes run_twice(const FrameLoop& loop, void (*run)(const FrameLoop&)) {
  const ProcessTimes first = run_timed([&] { run(loop); });
  const ProcessTimes second = run_timed([&] { run(loop); });
  return {std::min(first.wall, second.wall), std::min(first.cpu, second.cpu)};
}

/// For one frame, without starting up; nothing where all frames take less than that varies by.
std::optional<ProcessTimes> per_frame(const FrameLoop& loop, void (*run)(const FrameLoop&)) {
  FrameLoop some = loop;
  some.frames = kWarmUp;
  const ProcessTimes start = run_twice(some, run);
  some.frames = kWarmUp + loop.frames;
  const ProcessTimes all = run_twice(some, run);
  const ProcessTimes spent{all.wall - start.wall, all.cpu - start.cpu};
  if (std::min(spent.wall, spent.cpu) < kLeastSeconds) return std::nullopt;
  return ProcessTimes{spent.wall / loop.frames, spent.cpu / loop.frames};
}

/// Nothing where the frames are too few.
std::optional<Row> try_measure(const FrameLoop& loop) {
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const std::optional<ProcessTimes> naive = per_frame(loop, run_naive_loop);
  if (!naive) return std::nullopt;
  const std::optional<ProcessTimes> pipeline = per_frame(loop, run_pipeline);
  if (!pipeline) return std::nullopt;
  Row row{loop, 1e3 * naive->wall, 1e3 * pipeline->wall, 1e3 * pipeline->cpu / cores, 0, 0};
  double encoding = 0;
  run_timed(
      [&] { write_file_atomically(loop.folder / "encoding.txt", std::to_string(measure_encoding(loop))); });
  std::FILE* const file = std::fopen((loop.folder / "encoding.txt").c_str(), "r");
  if (file == nullptr || std::fscanf(file, "%lf", &encoding) != 1)
    throw std::runtime_error("the worker did not report the time of encoding");
  std::fclose(file);
  row.encoding = 1e3 * encoding;
  row.encoding_share = encoding / pipeline->cpu;
  return row;
}

/// Of as many frames as asked for. Where nothing was asked, of four times as many until they can be measured.
Row measure(FrameLoop loop, const std::optional<std::uint32_t>& frames) {
  loop.frames = frames.value_or(frames_for(loop.boxes));
  for (;; loop.frames = std::min(4 * loop.frames, kMostFrames)) {
    if (const std::optional<Row> row = try_measure(loop)) return *row;
    if (frames || loop.frames == kMostFrames) refuse(loop);
  }
}

void print(const Row& row) {
  std::printf("%4dx%-4d  %6u  %8.1f  %8.1f  %8.1f  %8.2f  %8.2f  %8.2f  %7.1f %%\n", row.loop.size.width,
              row.loop.size.height, row.loop.boxes, row.naive, row.pipeline, row.floor,
              row.pipeline / row.floor, row.naive / row.pipeline, row.encoding, 100 * row.encoding_share);
  std::fflush(stdout);
}

Json to_json(const Row& row) {
  return {{"width", row.loop.size.width}, {"height", row.loop.size.height},
          {"boxes", row.loop.boxes},      {"frames", row.loop.frames},
          {"workers", row.loop.workers},  {"naive_ms", row.naive},
          {"pipeline_ms", row.pipeline},  {"floor_ms", row.floor},
          {"encoding_ms", row.encoding},  {"encoding_share", row.encoding_share}};
}

/// What was measured, as JSON after each row.
class Results {
 public:
  Results(const std::filesystem::path& file, Replace replace) : file_(file, replace) {}

  void add(const Row& row) {
    rows_.push_back(to_json(row));
    save(false);
  }
  void finish() { save(true); }
  std::string end_early() { return file_.end_early(); }

 private:
  void save(bool complete) {
    const Json json{{"machine", describe_machine()}, {"rows", rows_}, {"complete", complete}};
    file_.save(json_text(json) + "\n", complete);
  }

  ResultFile file_;
  Json rows_ = Json::array();
};

class BenchFramesCommand final : public Command {
 public:
  explicit BenchFramesCommand(CLI::App& program);
  void run() const override;

 private:
  std::string sizes_ = "640x360,1280x720,1920x1080";
  std::string boxes_ = "1000,10000,100000";
  std::string frames_;
  std::string workers_;
  std::string out_;
  std::string json_;
  bool overwrite_ = false;
};

BenchFramesCommand::BenchFramesCommand(CLI::App& program)
    : Command(program, "bench-frames", "Measure how fast frames are made") {
  option("--sizes", sizes_, "Sizes of pictures (default 640x360,1280x720,1920x1080)", "WxH,...");
  option("--boxes", boxes_, "Numbers of boxes (default 1000,10000,100000)", "N,...");
  option("--frames", frames_, "Frames of each (default: enough to measure)", "N");
  option("--workers", workers_, "Processes that draw (default: one a core)", "N");
  output("--out", out_, "Where the frames go, and are removed again (default: a temporary folder)", "DIR");
  output("--json", json_, "Also the results and the machine, after each row");
  command_->add_flag("--overwrite", overwrite_, "Replace earlier results");
  command_->footer(
      "Milliseconds a frame: 'naive' simulates, draws, reads and encodes by stb in one loop; 'pipeline' is\n"
      "what `kerf render` does; 'floor' is its processor time by the cores, which nothing can beat;\n"
      "'encode' is the processor time of one PNG, and its share of a frame's. Meant for an idle machine.");
}

void BenchFramesCommand::run() const {
  Outputs outputs({}, overwrite_);
  outputs.add_folder(out_);
  outputs.add_file(json_);
  std::vector<PictureSize> sizes;
  for (const std::string& size : split(sizes_)) sizes.push_back(parse_picture_size(size));
  std::vector<std::uint32_t> boxes;
  for (const std::string& count : split(boxes_))
    boxes.push_back(parse_whole("--boxes", count, 1U, 1'000'000U));
  FrameLoop loop;
  loop.workers = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  if (!workers_.empty()) loop.workers = parse_whole("--workers", workers_, 1, 256);
  std::optional<std::uint32_t> frames;
  if (!frames_.empty()) frames = parse_whole("--frames", frames_, 1U, kMostFrames);
  const InterruptGuard interrupt;
  const std::filesystem::path parent = out_.empty() ? temporary_folder() : std::filesystem::path(out_);
  Results results(json_, outputs.replace());
  make_writable_folder(parent);
  const ScratchFolder scratch(parent);
  loop.folder = scratch.path();
  std::printf("%9s  %6s  %8s  %8s  %8s  %8s  %8s  %8s  %9s\n", "size", "boxes", "naive", "pipeline", "floor",
              "of floor", "faster", "encode", "share");
  const ProgressLine progress;
  for (const PictureSize& size : sizes) {
    for (const std::uint32_t count : boxes) {
      if (interrupt.requested()) throw Interrupted("interrupted; " + results.end_early());
      loop.size = size;
      loop.boxes = count;
      const Row row = measure(loop, frames);
      progress.clear();
      print(row);
      results.add(row);
    }
  }
  results.finish();
}

}  // namespace

AnyCommand make_bench_frames_command(CLI::App& program) {
  return std::make_unique<BenchFramesCommand>(program);
}

}  // namespace kerf
