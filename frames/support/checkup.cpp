#include "frames/support/checkup.h"

#include <array>
#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>

namespace kerf {
namespace {

struct ClosePipe {
  void operator()(std::FILE* pipe) const { pclose(pipe); }
};

}  // namespace

Finding look_for(const Part& part) {
  try {
    return {part.name, true, part.look(), "", part.is_needed};
  } catch (const OtherProblem& problem) {
    return {part.name, false, problem.what(), problem.advice, part.is_needed};
  } catch (const std::exception& error) {
    return {part.name, false, error.what(), part.advice, part.is_needed};
  }
}

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

}  // namespace kerf
