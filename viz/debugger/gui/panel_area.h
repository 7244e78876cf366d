#pragma once

namespace kerf {

/// A rectangle of the window in units of the panels, y down: pixels at a scale of 1.
struct PanelArea {
  float x = 0;
  float y = 0;
  float width = 0;
  float height = 0;

  [[nodiscard]] float right() const { return x + width; }
  [[nodiscard]] float bottom() const { return y + height; }
  [[nodiscard]] bool has(float px, float py) const {
    return px >= x && px < right() && py >= y && py < bottom();
  }
  friend bool operator==(const PanelArea&, const PanelArea&) = default;
};

}  // namespace kerf
