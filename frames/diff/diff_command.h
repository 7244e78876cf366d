#pragma once

#include <string>

namespace CLI {
class App;
}

namespace kerf {

/// `kerf diff`: whether two pictures, or the frames of two folders, are the same.
class DiffCommand {
 public:
  explicit DiffCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws PicturesDiffer, UnusableInput, UsageError or Interrupted.
  void run() const;

 private:
  CLI::App* command_;
  std::string reference_;
  std::string test_;
  std::string gate_;
  std::string flip_limit_;
  bool json_ = false;
};

}  // namespace kerf
