#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "viz/draw/font.h"
#include "viz/draw/painter.h"

namespace kerf {

/// Paints a scene with letters of the size that its scale wants.
class ScenePainter {
 public:
  explicit ScenePainter(const GlFunctions& gl) : gl_(gl) {}

  /// Call it before anything is painted. A unit is `scale` pixels.
  void set_scale(double scale) {
    constexpr double kLetters = 12;
    const int pixels = std::clamp(static_cast<int>(std::lround(kLetters * scale)), 6, 256);
    if (std::exchange(pixels_, pixels) == pixels) return;
    painter_.reset();  // it has the old letters
    font_ = std::make_unique<Font>(pixels);
    painter_ = std::make_unique<Painter>(gl_, *font_);
  }
  [[nodiscard]] const Font& font() const { return *font_; }
  Painter* operator->() const { return painter_.get(); }

 private:
  const GlFunctions& gl_;
  int pixels_ = 0;  ///< of the font; 0: there is none yet
  std::unique_ptr<Font> font_;
  std::unique_ptr<Painter> painter_;
};

}  // namespace kerf
