#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kerf {

/// Reads a table of numbers, separated by commas, line by line. A heading, empty lines and those that begin
/// with # are passed over. Throws UsageError that names file, line and what is wrong.
class CsvLines {
 public:
  /// Throws std::runtime_error if the file cannot be read.
  explicit CsvLines(const std::filesystem::path& path);

  /// Goes to the next line; false at the end.
  bool next();
  [[nodiscard]] std::size_t columns() const { return fields_.size(); }
  [[nodiscard]] bool is_empty(std::size_t column) const { return fields_[column].empty(); }
  /// A whole number up to `most`.
  [[nodiscard]] std::uint32_t whole(std::size_t column, std::uint32_t most) const;
  /// A float, also inf and nan.
  [[nodiscard]] float real(std::size_t column) const;
  [[noreturn]] void reject(const std::string& what) const;

 private:
  void cut();

  std::filesystem::path path_;
  std::ifstream file_;
  std::size_t number_ = 0;
  std::string line_;
  std::vector<std::string_view> fields_;
};

}  // namespace kerf
