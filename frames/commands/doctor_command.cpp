#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/counted.h"
#include "core/files/temporary_folder.h"
#include "core/kernels/machine.h"
#include "frames/commands/command.h"
#include "frames/page/json.h"
#include "frames/sequence/video.h"
#include "frames/support/errors.h"
#include "frames/support/machine.h"
#include "frames/support/parse_number.h"
#include "frames/support/version.h"
#include "viz/debugger/gui/glfw_window.h"
#include "viz/gl/context.h"

namespace kerf {
namespace {

/// Something that Kerf uses.
struct Part {
  std::string name;                   ///< "display"
  std::function<std::string()> look;  ///< says what is there; throws, with the reason, if nothing is
  std::string advice;                 ///< what to do if nothing is
  bool is_needed = false;             ///< for pictures and recordings; all else is for some commands
};

/// Thrown by `look` where something else than the advice of the part helps.
struct OtherProblem : std::runtime_error {
  OtherProblem(const std::string& what, std::string what_to_do)
      : std::runtime_error(what), advice(std::move(what_to_do)) {}
  std::string advice;
};

/// What was found of it.
struct Finding {
  std::string name;
  bool is_there = false;
  std::string what;    ///< or why nothing is
  std::string advice;  ///< empty if it is there
  bool is_needed = false;
};

struct ClosePipe {
  void operator()(std::FILE* pipe) const { pclose(pipe); }
};

Finding look_for(const Part& part) {
  try {
    return {part.name, true, part.look(), "", part.is_needed};
  } catch (const OtherProblem& problem) {
    return {part.name, false, problem.what(), problem.advice, part.is_needed};
  } catch (const std::exception& error) {
    return {part.name, false, error.what(), part.advice, part.is_needed};
  }
}

/// What a program prints. Throws std::runtime_error if it cannot be run or fails.
std::string output_of(const std::string& command) {
  std::unique_ptr<std::FILE, ClosePipe> pipe(popen((command + " 2>/dev/null </dev/null").c_str(), "r"));
  if (!pipe) throw std::runtime_error("no process can be started");
  std::string text;
  std::array<char, 4096> part{};
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), pipe.get()))
    text.append(part.data(), size);
  if (pclose(pipe.release()) != 0) throw std::runtime_error("`" + command + "` cannot be run");
  return text;
}

std::string first_line_of(const std::string& command) {
  const std::string text = output_of(command);
  return text.substr(0, text.find('\n'));
}

std::string vectors_here() {
  const std::vector<std::string> all = kernels();
  if (all.size() < 2) throw std::runtime_error("none that the kernels know: they work, several times slower");
  std::string text = kernel() + " is used, of";
  for (const std::string& name : all) text += " " + name;
  return text;
}

std::string renderer_of(GlBackend backend) { return make_offscreen_context(backend)->description(); }

std::string encoders_here() {
  const std::string version = first_line_of("ffmpeg -version");
  const std::vector<std::string> missing =
      Video::extensions_without_encoder(output_of("ffmpeg -hide_banner -encoders"));
  if (missing.empty()) return version.substr(0, version.find(" Copyright"));
  std::string text = "ffmpeg has no encoder for";
  for (const std::string& ending : missing) text += " " + ending;
  throw std::runtime_error(text);
}

/// Imports the module. The last line begins with what became of it; a folder of its name is no module.
constexpr const char* kImport = R"(python3 -c '
import sys
try:
    import kerf
    if getattr(kerf, "__file__", None) is None:
        raise ModuleNotFoundError(name="kerf")
    print("\nfound", "kerf", kerf.__version__, "for Python", sys.version.split()[0])
except BaseException as error:
    is_missing = isinstance(error, ModuleNotFoundError) and error.name == "kerf"
    print("\nmissing" if is_missing else "\nbroken", type(error).__name__ + ":", *str(error).split())
')";

std::string last_line_of(const std::string& command) {
  std::string text = output_of(command);
  text.resize(text.find_last_not_of('\n') + 1);
  return text.substr(text.rfind('\n') + 1);
}

std::string module_here() {
  std::string python;
  try {
    python = first_line_of("python3 -c 'import sys; print(sys.executable)'");
  } catch (const std::runtime_error&) {
    throw std::runtime_error("python3 cannot be run");
  }
  std::string answer;
  try {
    answer = last_line_of(kImport);
  } catch (const std::runtime_error&) {
    answer = "broken it ends without an answer";
  }
  const std::size_t blank = std::min(answer.find(' '), answer.size());
  const std::string fate = answer.substr(0, blank);
  answer.erase(0, blank + 1);
  if (fate == "found") return answer;
  if (fate == "missing") throw std::runtime_error(python + " does not find the module kerf");
  throw OtherProblem(
      python + " cannot import the module kerf: " + answer,
      "only your programs in Python need it: `python3 -c \"import kerf\"` says more; numpy must be "
      "there, and the module be built for this Python");
}

std::string room_for_files(std::uintmax_t gibibytes) {
  const std::filesystem::path folder = temporary_folder();
  const std::uintmax_t free = std::filesystem::space(folder).available;
  if (free >> 30U < gibibytes)
    throw std::runtime_error("less than " + std::to_string(gibibytes) + " GiB is free in " + folder.string());
  return std::to_string(free >> 30U) + " GiB free in " + folder.string();
}

/// In the order in which a user meets them.
std::vector<Part> parts(std::uintmax_t gibibytes) {
  return {
      {"vectors", vectors_here, "use a processor with SSE4, AVX2 or NEON where speed matters"},
      {"threads", [] { return counted(std::thread::hardware_concurrency(), "processor"); }, ""},
      {"drawing", [] { return renderer_of(GlBackend::any); },
       "install OSMesa (Debian: libosmesa6) or Mesa's EGL (Debian: libegl1 libegl-mesa0)", true},
      {"room", [gibibytes] { return room_for_files(gibibytes); },
       "free some space, or set TMPDIR to another folder", true},
      {"drawing by EGL", [] { return renderer_of(GlBackend::egl); },
       "only --backend egl needs it: install Mesa's EGL (Debian: libegl1 libegl-mesa0)"},
      {"display", GlfwWindow::try_out,
       "only the window of `kerf debug` needs it: set DISPLAY, or run it by xvfb-run (Debian: xvfb xauth)"},
      {"films", encoders_here, "install ffmpeg (Debian: ffmpeg); frames are made without it"},
      {"plots", [] { return first_line_of("gnuplot --version"); },
       "only reports, experiments, studies and `kerf advise --plot` need it: install gnuplot (Debian: "
       "gnuplot-nox)"},
      {"Python module", module_here,
       "only your programs in Python need it: install it (Debian: python3-kerf), or set PYTHONPATH to the "
       "folder python of a build"},
  };
}

const char* word_for(const Finding& finding) {
  if (finding.is_there) return "ok      ";
  return finding.is_needed ? "MISSING " : "missing ";
}

std::string as_text(const std::vector<Finding>& findings) {
  std::size_t width = 0;
  for (const Finding& finding : findings) width = std::max(width, finding.name.size());
  std::string text;
  for (const Finding& finding : findings) {
    text += word_for(finding) + finding.name + std::string(width + 2 - finding.name.size(), ' ') +
            finding.what + "\n";
    if (!finding.is_there) text += std::string(width + 10, ' ') + finding.advice + "\n";
  }
  return text;
}

std::string as_json(const std::vector<Finding>& findings) {
  Json json{{"machine", describe_machine()}, {"parts", Json::array()}};
  for (const Finding& finding : findings) {
    Json part{{"name", finding.name},
              {"there", finding.is_there},
              {"needed", finding.is_needed},
              {"what", finding.what}};
    if (!finding.is_there) part["advice"] = finding.advice;
    json["parts"].push_back(std::move(part));
  }
  return json_text(json) + "\n";
}

class DoctorCommand final : public Command {
 public:
  explicit DoctorCommand(CLI::App& program);
  void run() const override;

 private:
  std::string room_;
  bool json_ = false;
};

DoctorCommand::DoctorCommand(CLI::App& program)
    : Command(program, "doctor", "What is there on this machine, and what to do about the rest") {
  option("--room", room_, "So much free space is needed (default 1)", "GIB");
  command_->add_flag("--json", json_, "The same as JSON, with the machine");
  command_->footer("It changes nothing. What only some commands need may be missing.");
}

void DoctorCommand::run() const {
  std::vector<Finding> findings;
  const std::uint32_t room = room_.empty() ? 1 : parse_whole<std::uint32_t>("--room", room_, 1, 1'000'000);
  std::ranges::transform(parts(room), std::back_inserter(findings), look_for);
  if (!json_) std::printf("kerf %s\n", version());
  std::fputs((json_ ? as_json(findings) : as_text(findings)).c_str(), stdout);
  const auto is_lacking = [](const Finding& of) { return of.is_needed && !of.is_there; };
  const auto lacking = static_cast<std::uint64_t>(std::ranges::count_if(findings, is_lacking));
  if (lacking > 0) throw DoesNotHold(counted(lacking, "part") + " that pictures need: see MISSING");
}

}  // namespace

AnyCommand make_doctor_command(CLI::App& program) { return std::make_unique<DoctorCommand>(program); }

}  // namespace kerf
