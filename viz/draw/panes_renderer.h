#pragma once

#include <memory>
#include <string>

#include "viz/draw/frame_renderer.h"
#include "viz/draw/panes.h"

namespace kerf {

/// Draws broad phases side by side: each in a pane with its numbers, all seen by one camera. Each picture
/// follows from its frame alone.
template <int D>
class PanesRenderer {
 public:
  /// `options.samples` and `options.margins` are not read: a frame says its samples. `options.ids` needs a
  /// single pane. Throws as FrameRenderer does.
  explicit PanesRenderer(const FrameOptions& options);
  ~PanesRenderer();
  PanesRenderer(const PanesRenderer&) = delete;
  PanesRenderer& operator=(const PanesRenderer&) = delete;

  /// The picture is valid until the next call. Throws std::invalid_argument if the panes would be too small.
  const Image& render(const PanesFrame<D>& frame);
  /// Of the last frame; empty unless the options ask for it.
  [[nodiscard]] const FrameIds& ids() const;
  [[nodiscard]] std::string rasterizer() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace kerf
