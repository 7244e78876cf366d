#include "frames/import/given_mesh.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/whole_file.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

/// Up to a # that begins a comment.
std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view kBlanks = " \t";
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(kBlanks); at < line.size() && line[at] != '#';
       at = line.find_first_not_of(kBlanks, at)) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

/// What a double cannot hold is a number, too.
bool is_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error != std::errc::invalid_argument && end == word.data() + word.size() && std::isfinite(value);
}

/// "3", "3/1", "3//2" or "3/1/2"
bool is_corner(std::string_view word) {
  for (int part = 0; part < 3; ++part) {
    const std::size_t slash = std::min(word.find('/'), word.size());
    const std::string_view number = word.substr(0, slash);
    int value = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (!(part > 0 && number.empty()) && (error != std::errc{} || end != number.data() + number.size()))
      return false;
    if (slash == word.size()) return true;
    word.remove_prefix(slash + 1);
  }
  return false;
}

/// What is wrong with a line; empty: nothing.
std::string complaint_about(std::string_view line) {
  const std::vector<std::string_view> words = words_of(line);
  if (words.empty()) return "";
  const bool is_long = words.size() > 3;
  if (words[0] == "v" && !(is_long && std::all_of(words.begin() + 1, words.end(), is_number)))
    return "is no vertex such as v 0 1.5 0: three numbers, with decimal points";
  if (words[0] == "f" && !(is_long && std::all_of(words.begin() + 1, words.end(), is_corner)))
    return "is no face such as f 1 2 3: the numbers of three vertices or more";
  return "";
}

/// The reader of OBJ takes 0 for what is no number, and passes over faces with too few corners.
void check_lines(std::string_view text, const std::filesystem::path& path) {
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view content = text.substr(0, end);
    if (const std::string complaint = complaint_about(content); !complaint.empty())
      throw UsageError(path.string() + ", line " + std::to_string(line) + ": '" + std::string(content) +
                       "' " + complaint);
    text.remove_prefix(end);
    text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(text.size(), 1));
  }
}

tinyobj::ObjReader parse(const std::filesystem::path& path) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";  // of UTF-8
  std::string text = read_whole_file(path);
  if (text.starts_with(kMark)) text.erase(0, kMark.size());
  check_lines(text, path);
  tinyobj::ObjReaderConfig config;
  config.vertex_color = false;
  tinyobj::ObjReader reader;
  if (!reader.ParseFromString(text, "", config)) throw UsageError(path.string() + ": " + reader.Error());
  return reader;
}

}  // namespace

std::shared_ptr<const Surface> read_mesh(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) throw UsageError("there is no file " + path.string());
  const tinyobj::ObjReader reader = parse(path);
  auto surface = std::make_shared<Surface>();
  const std::vector<tinyobj::real_t>& numbers = reader.GetAttrib().vertices;
  for (std::size_t k = 0; k + 2 < numbers.size(); k += 3) {
    surface->vertices.push_back({numbers[k], numbers[k + 1], numbers[k + 2]});
    if (!is_finite(surface->vertices.back()))
      throw UsageError(path.string() + " has a vertex that is nowhere");
  }
  for (const tinyobj::shape_t& shape : reader.GetShapes()) {
    const std::vector<tinyobj::index_t>& corners = shape.mesh.indices;
    for (std::size_t k = 0; k + 2 < corners.size(); k += 3) {
      auto& triangle = surface->triangles.emplace_back();
      for (std::size_t corner = 0; corner < triangle.size(); ++corner) {
        const int vertex = corners[k + corner].vertex_index;
        if (vertex < 0 || static_cast<std::size_t>(vertex) >= surface->vertices.size())
          throw UsageError(path.string() + " has a face without a vertex");
        triangle[corner] = static_cast<std::uint32_t>(vertex);
      }
    }
  }
  if (surface->triangles.empty()) throw UsageError(path.string() + " has no face");
  return surface;
}

}  // namespace kerf
