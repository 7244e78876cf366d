#pragma once

#include <string>

#include "frames/diff/frame_diff.h"

namespace CLI {
class App;
}

namespace kerf {

/// `kerf diff`: whether two pictures, or the frames of two folders, are the same.
class DiffCommand {
 public:
  explicit DiffCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws DoesNotHold, UsageError or Interrupted.
  void run() const;

 private:
  CLI::App* command_;
  std::string reference_;
  std::string test_;
  std::string gate_;
  std::string flip_limit_;
  std::string report_;
  bool json_ = false;
  bool overwrite_ = false;
  bool approve_ = false;
};

}  // namespace kerf
