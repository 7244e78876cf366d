#pragma once

namespace CLI {
class App;
}

namespace kerf {

/// `kerf scenes`: which scenes there are.
class ScenesCommand {
 public:
  explicit ScenesCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Prints the table. Throws std::runtime_error if standard output cannot be written.
  void run() const;

 private:
  CLI::App* command_;
  bool verbose_ = false;
  bool json_ = false;
};

}  // namespace kerf
