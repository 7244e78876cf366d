#pragma once

#include "frames/sequence/render_request.h"

namespace CLI {
class App;
}

namespace kerf {

/// `kerf render`: makes a sequence of frames of a scene or a recording.
class RenderCommand {
 public:
  explicit RenderCommand(CLI::App& program);
  [[nodiscard]] bool chosen() const;
  /// Throws as `parse_request` and `render_sequence` do.
  void run() const;

 private:
  CLI::App* command_;
  RenderTexts texts_;
};

}  // namespace kerf
