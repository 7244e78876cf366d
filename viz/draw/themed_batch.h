#pragma once

#include <span>

#include "viz/draw/batch.h"
#include "viz/draw/overlay.h"
#include "viz/draw/theme.h"

namespace kerf {

/// Colours of the palette become those of the theme; all others stay, such as those of lit faces.
inline void put_on(const Theme& theme, std::span<Batch> batches) {
  if (theme.name == ThemeName::light) return;
  for (Batch& batch : batches)
    for (Vertex& vertex : batch.vertices) vertex.color = theme.mark(vertex.color);
}
inline void put_on(const Theme& theme, Overlay& overlay) {
  put_on(theme, std::span(&overlay.shapes, 1));
  if (theme.name == ThemeName::light) return;
  for (TextBatch::Vertex& vertex : overlay.text.vertices) vertex.color = theme.text(vertex.color);
}

}  // namespace kerf
