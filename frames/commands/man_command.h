#pragma once

namespace CLI {
class App;
}

namespace kerf {

/// `kerf man`: the man page, for `man -l` and packages.
class ManCommand {
 public:
  explicit ManCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  void run() const;

 private:
  CLI::App& program_;
  CLI::App* command_;
};

}  // namespace kerf
