#pragma once

#include <string>

namespace CLI {
class App;
}

namespace kerf {

/// `kerf completion`: what makes a shell complete commands and options.
class CompletionCommand {
 public:
  explicit CompletionCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  void run() const;

 private:
  CLI::App& program_;
  CLI::App* command_;
  std::string shell_;
};

}  // namespace kerf
