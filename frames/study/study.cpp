#include "frames/study/study.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "core/recording/chain.h"
#include "core/recording/recording_info.h"
#include "frames/study/json_object.h"
#include "frames/study/matrix.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

bool is_plain(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '='; }

void add(std::vector<StudyCell> more, const JsonObject& matrix, std::set<std::string>& ids, Study& study) {
  for (StudyCell& cell : more) {
    if (!ids.insert(cell.id).second)
      matrix.refuse("repeats", "the cell " + cell.id + " is in this file twice; take it out of one matrix");
    study.cells.push_back(std::move(cell));
  }
  refuse_too_many(matrix, static_cast<double>(study.cells.size()));
}

}  // namespace

std::string cell_id(const std::string& words, const Json& settings) {
  constexpr std::size_t kLongest = 100;
  constexpr std::size_t kDigits = 8;
  std::string id = words.substr(0, kLongest);
  std::ranges::replace_if(
      id, [](char c) { return !is_plain(c); }, '-');
  const std::string text = settings.dump();
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  return id + "." + to_hex(hash_bytes({bytes, text.size()}, 0)).substr(0, kDigits);
}

Study read_study(const std::string& file) {
  const Json json = read_json_object(file);
  JsonObject top(json, file + ": ");
  Study study{file, std::filesystem::path(file).stem().string(), {}};
  std::set<std::string> ids;
  for (JsonObject& matrix : top.objects("matrices"))
    add(read_matrix(matrix, std::filesystem::path(file).parent_path()), matrix, ids, study);
  top.refuse_the_rest();
  return study;
}

}  // namespace kerf
