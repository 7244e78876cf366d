#include "frames/commands/memory_advice.h"

#include <algorithm>
#include <array>

namespace kerf {
namespace {

constexpr std::array<std::string_view, 7> kDrawing{"render", "collect", "film",        "film-diff",
                                                   "diff",   "debug",   "bench-frames"};
constexpr std::array<std::string_view, 8> kReading{"rerun", "step",     "explain", "compare",
                                                   "lint",  "minimize", "export",  "advise"};

template <std::size_t N>
bool is_in(const std::array<std::string_view, N>& commands, std::string_view command) {
  return std::ranges::find(commands, command) != commands.end();
}

std::string_view advice(std::string_view command) {
  if (command == "import")
    return "import fewer steps or fewer objects at a time; pairs of one step need most";
  if (command == "verify")
    return "--oracle-every 0 needs less, as does a recording of fewer steps or objects";
  if (is_in(kDrawing, command)) return "ask for smaller pictures or fewer objects";
  if (is_in(kReading, command)) return "a recording of fewer steps or objects needs less";
  return "ask for fewer steps or objects";
}

}  // namespace

std::string out_of_memory(std::string_view command) {
  return "not enough memory; " + std::string(advice(command));
}

}  // namespace kerf
