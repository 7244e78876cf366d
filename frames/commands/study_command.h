#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}  // namespace CLI

namespace kerf {

struct Study;
struct StudyCell;

/// `kerf study`: measures the cells of a matrix, all or a shard of them, and joins what shards have measured.
class StudyCommand {
 public:
  explicit StudyCommand(CLI::App& program);

  [[nodiscard]] bool chosen() const;
  void run() const;

 private:
  [[nodiscard]] std::vector<const StudyCell*> chosen_cells(const Study& study) const;
  [[nodiscard]] std::filesystem::path cells_folder(const Study& study) const;
  void list(const Study& study) const;
  void print_cells(const Study& study) const;
  void measure(const Study& study) const;
  void join_shards(const Study& study) const;

  CLI::App* command_;
  std::string file_;
  std::string out_;
  std::string shard_;
  std::vector<std::string> cells_;
  std::vector<std::string> folders_;
  bool list_ = false;
  bool overwrite_ = false;
};

}  // namespace kerf
