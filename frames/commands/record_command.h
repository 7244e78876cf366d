#pragma once

#include <string>

#include "frames/sequence/render_request.h"

namespace CLI {
class App;
}

namespace kerf {

/// `kerf record`: runs a scene and records it, without pictures.
class RecordCommand {
 public:
  explicit RecordCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws UsageError, Interrupted, or std::runtime_error if the file cannot be written.
  void run() const;

 private:
  CLI::App* command_;
  RenderTexts texts_;
};

}  // namespace kerf
