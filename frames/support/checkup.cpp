#include "frames/support/checkup.h"

#include <sched.h>

#include <array>
#include <cstdio>
#include <exception>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <utility>

namespace kerf {
namespace {

struct ClosePipe {
  void operator()(std::FILE* pipe) const { pclose(pipe); }
};

constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kEncoders{
    {{"libx264", ".mp4, .mkv, .mov"}, {"libvpx-vp9", ".webm"}, {"gif", ".gif"}, {"apng", ".apng"}}};

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

}  // namespace

Finding look_for(const Part& part) {
  try {
    return {part.name, true, part.look(), "", part.is_needed};
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

unsigned usable_processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof set, &set) != 0) return std::thread::hardware_concurrency();
  return static_cast<unsigned>(CPU_COUNT(&set));
}

std::vector<std::string> films_without_encoder(const std::string& encoders) {
  std::vector<std::string> missing;
  for (const auto& [encoder, endings] : kEncoders)
    if (!lists(encoders, encoder)) missing.emplace_back(endings);
  return missing;
}

}  // namespace kerf
