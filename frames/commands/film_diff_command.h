#pragma once

#include <string>

namespace CLI {
class App;
}

namespace kerf {

/// `kerf film-diff`: two sequences side by side with a panel that shows where they differ, as a film.
class FilmDiffCommand {
 public:
  explicit FilmDiffCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws UsageError, Interrupted, or std::runtime_error if a picture or the film cannot be.
  void run() const;

 private:
  CLI::App* command_;
  std::string a_;
  std::string b_;
  std::string out_;
  std::string fps_;
  std::string contact_sheet_;
  bool overwrite_ = false;
};

}  // namespace kerf
