#pragma once

#include <string>

namespace CLI {
class App;
}

namespace kerf {

/// `kerf bench-frames`: how fast frames are made, and how fast they could be.
class BenchFramesCommand {
 public:
  explicit BenchFramesCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws UsageError, Interrupted or std::runtime_error.
  void run() const;

 private:
  CLI::App* command_;
  std::string sizes_ = "640x360,1280x720,1920x1080";
  std::string boxes_ = "1000,10000,100000";
  std::string frames_;
  std::string workers_;
  std::string out_;
  std::string json_;
  bool overwrite_ = false;
};

}  // namespace kerf
