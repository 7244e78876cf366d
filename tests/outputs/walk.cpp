#include "tests/outputs/walk.h"

#include <algorithm>
#include <csignal>
#include <fstream>
#include <map>
#include <stdexcept>

#include "core/files/part_file.h"
#include "core/recording/recording_reader.h"
#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf::faults {
namespace {

namespace fs = std::filesystem;
using test::RunOutcome;
using test::TemporaryFolder;

/// Contents by name of all files in a folder and below.
using Files = std::map<std::string, std::string>;

Files files_below(const fs::path& folder) {
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[entry.path().lexically_relative(folder).string()] = test::read_text(entry.path());
  return files;
}

/// Among them the lock that a killed writer of a recording leaves.
bool is_part(const fs::path& file) {
  return std::ranges::any_of(file, [](const fs::path& name) {
    std::string text = name.string();
    if (text.ends_with("-lock")) return true;
    for (const std::string ending : {"-wal", "-shm", "-journal"})
      if (text.ends_with(ending)) text.resize(text.size() - ending.size());
    return is_part_name(text);
  });
}

/// The part to which a file that SQLite has put beside it belongs, or the file itself.
std::string part_of(std::string name) {
  for (const std::string ending : {"-wal", "-shm", "-journal"})
    if (name.ends_with(ending)) name.resize(name.size() - ending.size());
  return name;
}

/// Of a recording that was cut short, with its log.
std::uint32_t steps_of_part(const Files& files, const std::string& part) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.kerf";
  if (!files.contains(part)) return 0;
  for (const std::string ending : {"", "-wal"})
    if (files.contains(part + ending))
      std::ofstream(file.string() + ending, std::ios::binary) << files.at(part + ending);
  try {
    if (read_recording_info(file).dimension == 2) return RecordingReader<2>(file).steps();
    return RecordingReader<3>(file).steps();
  } catch (const std::runtime_error&) {
    return 0;
  }
}

std::string errno_of(Fault fault) {
  if (fault == Fault::kill) return "kill";
  return std::to_string(fault == Fault::no_space ? ENOSPC : EIO);
}

const char* name_of(Fault fault) {
  if (fault == Fault::kill) return "killed";
  return fault == Fault::no_space ? "ENOSPC" : "EIO";
}

/// What is compared of a recording: its steps and the state after the last.
struct Gist {
  bool complete = false;
  std::uint32_t steps = 0;
  std::uint64_t last_hash = 0;
  friend bool operator==(const Gist&, const Gist&) = default;
};

Gist gist_of(const std::string& bytes) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.kerf";
  std::ofstream(file, std::ios::binary) << bytes;
  try {
    const auto gist = [](const auto& reader) -> Gist {
      return {reader.info().complete, reader.steps(), reader.rows().back().state_hash};
    };
    if (read_recording_info(file).dimension == 2) return gist(RecordingReader<2>(file));
    return gist(RecordingReader<3>(file));
  } catch (const std::runtime_error&) {
    return {};
  }
}

std::string end_of(const std::string& text) {
  constexpr std::size_t kEnd = 6;
  return text.substr(text.size() - std::min(kEnd, text.size()));
}

bool is_like(Likeness likeness, const std::string& a, const std::string& b) {
  switch (likeness) {
    case Likeness::same_bytes:
    case Likeness::same_manifest:
      return a == b;
    case Likeness::same_end:
      return end_of(a) == end_of(b);
    case Likeness::same_lines:
      return std::ranges::count(a, '\n') == std::ranges::count(b, '\n');
    case Likeness::same_recording:
      break;
  }
  const Gist gist = gist_of(a);
  return gist.complete && gist == gist_of(b);
}

/// Whether `a` is the manifest `b` before all of its frames were in their place.
bool is_midway(const std::string& a, std::string b) {
  const std::string complete = "\"complete\": true";
  const std::size_t place = b.find(complete);
  return place != std::string::npos && a == b.replace(place, complete.size(), "\"complete\": false");
}

class Walk {
 public:
  explicit Walk(const Scenario& scenario) : scenario_(scenario) {
    scenario.prepare(template_.path());
    before_ = files_below(template_.path());
    const Run run = run_with(0, "0");
    if (run.outcome.exit != 0) throw std::runtime_error(scenario.name + " fails: " + run.outcome.err);
    after_ = run.files;
    result_.calls = run.calls;
    for (const OutputFile& output : scenario.outputs)
      if (!after_.contains(output.name)) throw std::runtime_error(scenario.name + " made no " + output.name);
  }

  WalkResult run(std::uint64_t points) {
    const std::uint64_t count = std::min(points, result_.calls);
    for (std::uint64_t k = 0; k < count; ++k) {
      const std::uint64_t at = count == 1 ? 1 : 1 + k * (result_.calls - 1) / (count - 1);
      for (const Fault fault : {Fault::input_output_error, Fault::no_space, Fault::kill})
        try_fault(at, fault);
    }
    return std::move(result_);
  }

 private:
  struct Run {
    RunOutcome outcome;
    Files files;
    std::uint64_t calls = 0;
  };

  [[nodiscard]] Run run_with(std::uint64_t at, const std::string& error) const {
    const TemporaryFolder place;
    const fs::path folder = place.path() / "files";
    const fs::path count = place.path() / "count";
    fs::copy(template_.path(), folder, fs::copy_options::recursive);
    std::ofstream(count, std::ios::binary) << std::string(sizeof(std::uint64_t), '\0');
    std::vector<std::string> command{"env",
                                     std::string("LD_PRELOAD=") + KERF_FAULT_LIBRARY,
                                     "KERF_FAULT_FOLDER=" + folder.string(),
                                     "KERF_FAULT_COUNT=" + count.string(),
                                     "KERF_FAULT_AT=" + std::to_string(at),
                                     "KERF_FAULT_ERROR=" + error};
    for (const std::string& word : test::kerf_command(scenario_.arguments(folder))) command.push_back(word);
    Run run{test::Process(command).wait(), files_below(folder)};
    std::ifstream(count, std::ios::binary).read(reinterpret_cast<char*>(&run.calls), sizeof run.calls);
    return run;
  }

  void try_fault(std::uint64_t at, Fault fault) {
    ++(fault == Fault::kill ? result_.kills : fault == Fault::no_space ? result_.full : result_.errors);
    const Run run = run_with(at, errno_of(fault));
    const auto finding = [&](const std::string& what) {
      result_.findings.push_back(scenario_.name + ", call " + std::to_string(at) + " " + name_of(fault) +
                                 ": " + what + " (exit " + std::to_string(run.outcome.exit) + ", " +
                                 run.outcome.err + ")");
    };
    const bool done = run.outcome.exit == kExitHolds;
    if (done) ++result_.unharmed;
    // The process that is killed may be ffmpeg.
    const bool is_killed = fault == Fault::kill && run.outcome.exit == 128 + SIGKILL;
    if (!done && !is_killed && run.outcome.exit != kExitUnusable) finding("wrong exit code");
    for (const OutputFile& output : scenario_.outputs) check(output, run, done, finding);
    check_others(run, is_killed, finding);
  }

  template <class Finding>
  void check(const OutputFile& output, const Run& run, bool done, const Finding& finding) const {
    const auto now = run.files.find(output.name);
    const auto earlier = before_.find(output.name);
    if (now == run.files.end()) {
      if (done || earlier != before_.end()) finding(output.name + " is lost");
      return;
    }
    const bool is_new = is_like(output.likeness, now->second, after_.at(output.name));
    const bool is_earlier = earlier != before_.end() && now->second == earlier->second;
    if (done && !is_new) finding(output.name + " is not the new one");
    if (output.likeness == Likeness::same_manifest && is_midway(now->second, after_.at(output.name))) return;
    if (!is_new && !is_earlier) finding(output.name + " is neither the earlier one nor the new one");
  }

  /// Inputs and unrelated files, the files of the earlier outputs, and the new ones.
  template <class Finding>
  void check_others(const Run& run, bool is_killed, const Finding& finding) const {
    const std::string& first = scenario_.outputs.front().name;
    const bool is_earlier =
        run.files.contains(first) && before_.contains(first) && run.files.at(first) == before_.at(first);
    for (const auto& [name, contents] : before_) {
      const bool is_same = run.files.contains(name) && run.files.at(name) == contents;
      const bool stays = after_.contains(name) && after_.at(name) == contents;
      if (!is_same && (stays || (is_earlier && !after_.contains(name))))
        finding(name + " is lost or changed");
    }
    for (const auto& [name, contents] : run.files) {
      if (before_.contains(name) || after_.contains(name)) continue;
      if (!is_part(name)) finding(name + " is left over");
      if (is_part(name) && !is_killed && !is_kept(part_of(name), run))
        finding("the part " + name + " is left");
    }
  }

  /// A run that could not write to its end keeps the steps of a recording, and says where.
  static bool is_kept(const std::string& part, const Run& run) {
    const bool is_said = run.outcome.err.find(fs::path(part).filename().string()) != std::string::npos;
    return run.outcome.exit == kExitUnusable && is_said && steps_of_part(run.files, part) > 0;
  }

  const Scenario& scenario_;
  TemporaryFolder template_;
  Files before_;
  Files after_;
  WalkResult result_;
};

}  // namespace

WalkResult walk(const Scenario& scenario, std::uint64_t points) { return Walk(scenario).run(points); }

}  // namespace kerf::faults
