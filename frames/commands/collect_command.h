#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace kerf {

/// `kerf collect`: joins the frames of several folders to one complete sequence, or a film.
class CollectCommand {
 public:
  explicit CollectCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws UsageError, Interrupted, or std::runtime_error if frames are missing or damaged.
  void run() const;

 private:
  CLI::App* command_;
  std::vector<std::string> folders_;
  std::string out_;
  std::string video_;
  std::string fps_;
  std::string contact_sheet_;
  bool overwrite_ = false;
};

}  // namespace kerf
