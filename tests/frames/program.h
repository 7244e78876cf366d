#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace kerf::test {

std::string read_text(const std::filesystem::path& file);
nlohmann::json read_json(const std::filesystem::path& file);

/// What a program did. `exit` is 128 + the signal if it was killed, as a shell has it.
struct RunOutcome {
  int exit = -1;
  std::string out;
  std::string err;
};

/// How a program is started other than usual.
struct Surroundings {
  std::uint64_t largest_file = 0;  ///< RLIMIT_FSIZE; 0: no limit
  std::string path{};              ///< PATH; empty: as it is
  std::string libraries{};         ///< LD_LIBRARY_PATH; empty: as it is
  std::uint64_t memory = 0;        ///< RLIMIT_AS; 0: no limit
  std::uint64_t seconds = 0;       ///< RLIMIT_CPU; 0: no limit
};

/// A running program, its outputs kept in files until it ends. The destructor kills it unless `wait` was
/// called.
class Process {
 public:
  explicit Process(std::vector<std::string> command, const Surroundings& surroundings = {});
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  [[nodiscard]] pid_t id() const { return pid_; }
  void signal(int number) const;
  RunOutcome wait();

 private:
  TemporaryFolder outputs_;
  pid_t pid_ = -1;
};

/// These arguments and more.
std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more);
/// Draws small pictures of few objects.
std::vector<std::string> short_render(const std::filesystem::path& out, const std::string& steps);
/// `kerf` with these arguments.
std::vector<std::string> kerf_command(const std::vector<std::string>& arguments);
RunOutcome run_kerf(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});
/// Waits until the condition holds; false after a minute in which it did not.
bool holds_within_a_minute(const std::function<bool()>& condition);
/// Interrupts it (SIGINT) when the condition holds, or after a minute.
RunOutcome interrupt_kerf(const std::vector<std::string>& arguments, const std::function<bool()>& when);
/// Whether a part of the file is there that is not empty.
bool has_written_part(const std::filesystem::path& file);

}  // namespace kerf::test
