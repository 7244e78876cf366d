#pragma once

#include <optional>
#include <string>

#include "viz/debugger/gui/gui.h"
#include "viz/gl/context.h"
#include "viz/gl/framebuffer.h"
#include "viz/image/image.h"

namespace kerf {

/// What a debugger shows while there is nothing to debug yet.
struct ProgressWords {
  std::string deed;            ///< what is being done: "recording pile"
  std::optional<double> done;  ///< from 0 to 1; none: how long it takes is not known, and there is no bar
  std::string state;           ///< "step 120 of 300, about 0:04 left"
  std::string hint;            ///< what the user can do
};

/// Draws them. It ends before a Debugger begins in the same context.
class ProgressScreen {
 public:
  /// The context must outlive it.
  explicit ProgressScreen(GlContext& context);

  /// A picture of so many pixels.
  void draw(const ProgressWords& words, int width, int height);
  /// The last one.
  Image picture();
  /// Shows it in the window of the context.
  void show_in_window(int width, int height) const { framebuffer_->show_in_window(width, height); }

 private:
  GlContext& context_;
  Gui gui_;
  std::optional<Framebuffer> framebuffer_;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace kerf
