#include "tests/frames/program.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "core/files/part_file.h"
#include "core/files/whole_file.h"

namespace kerf::test {
namespace {

/// Runs in the child, after fork and before the program.
void enter(const Surroundings& surroundings, const std::filesystem::path& outputs) {
  const int in = ::open("/dev/null", O_RDONLY);
  const int out = ::open((outputs / "out").c_str(), O_WRONLY | O_CREAT, 0600);
  const int err = ::open((outputs / "err").c_str(), O_WRONLY | O_CREAT, 0600);
  ::dup2(in, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  if (!surroundings.path.empty()) ::setenv("PATH", surroundings.path.c_str(), 1);
  if (!surroundings.libraries.empty()) ::setenv("LD_LIBRARY_PATH", surroundings.libraries.c_str(), 1);
  const auto limit = [](auto resource, std::uint64_t most) {
    const rlimit both{most, most};
    if (most != 0) ::setrlimit(resource, &both);
  };
  limit(RLIMIT_FSIZE, surroundings.largest_file);
  limit(RLIMIT_AS, surroundings.memory);
  limit(RLIMIT_CPU, surroundings.seconds);
}

}  // namespace

std::string read_text(const std::filesystem::path& file) { return read_whole_file(file); }

nlohmann::json read_json(const std::filesystem::path& file) { return nlohmann::json::parse(read_text(file)); }

Process::Process(std::vector<std::string> command, const Surroundings& surroundings) {
  std::vector<char*> argv;
  for (std::string& word : command) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_ = ::fork();
  if (pid_ < 0) throw std::runtime_error("cannot fork");
  if (pid_ > 0) return;
  enter(surroundings, outputs_.path());
  ::execvp(argv[0], argv.data());
  ::_exit(127);
}

Process::~Process() {
  if (pid_ <= 0) return;
  ::kill(pid_, SIGKILL);
  wait();
}

void Process::signal(int number) const { ::kill(pid_, number); }

RunOutcome Process::wait() {
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          read_text(outputs_.path() / "out"), read_text(outputs_.path() / "err")};
}

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::vector<std::string> short_render(const std::filesystem::path& out, const std::string& steps) {
  return {"render", "pile", "--steps", steps, "--objects", "50", "--size", "160x120", "--out", out};
}

std::vector<std::string> kerf_command(const std::vector<std::string>& arguments) {
  std::vector<std::string> command{KERF_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

RunOutcome run_kerf(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
  return Process(kerf_command(arguments), surroundings).wait();
}

bool holds_within_a_minute(const std::function<bool()>& condition) {
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > give_up) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

RunOutcome interrupt_kerf(const std::vector<std::string>& arguments, const std::function<bool()>& when) {
  Process process(kerf_command(arguments));
  holds_within_a_minute(when);
  process.signal(SIGINT);
  return process.wait();
}

bool has_written_part(const std::filesystem::path& file) {
  const auto parts = parts_of(file);
  std::error_code none;
  return !parts.empty() && std::filesystem::file_size(parts.front(), none) > 0 && !none;
}

}  // namespace kerf::test
