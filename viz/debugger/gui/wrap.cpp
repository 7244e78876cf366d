#include "viz/debugger/gui/wrap.h"

#include <algorithm>
#include <utility>

#include "viz/draw/letters.h"

namespace kerf {
namespace {

/// The end of a line that is too long: the last space with a word before it.
std::size_t end_of_line(std::string_view line, std::size_t columns) {
  const std::size_t end = first_letters(line, columns).size();
  const std::size_t space = line.rfind(' ', end);
  const bool is_indent = space == std::string_view::npos || line.find_first_not_of(' ') > space;
  return is_indent ? end : space;
}

void wrap_line(std::string_view line, std::size_t columns, std::string& out) {
  const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
  const std::string indent(2 * begin < columns ? begin : 0, ' ');
  bool is_first = true;
  while (count_letters(line) + (is_first ? 0 : indent.size()) > columns) {
    const std::size_t room = columns - (std::exchange(is_first, false) ? 0 : indent.size());
    const std::size_t end = end_of_line(line, room);
    out += std::string(line.substr(0, end)) + "\n" + indent;
    line.remove_prefix(end);
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
  }
  out += line;
}

}  // namespace

std::string wrap_at_spaces(std::string_view text, std::size_t columns) {
  columns = std::max<std::size_t>(1, columns);
  std::string out;
  while (true) {
    const std::size_t end = text.find('\n');
    wrap_line(text.substr(0, end), columns, out);
    if (end == std::string_view::npos) return out;
    out += '\n';
    text.remove_prefix(end + 1);
  }
}

}  // namespace kerf
