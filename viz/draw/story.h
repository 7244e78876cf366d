#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/tree/tree_snapshot.h"
#include "viz/draw/camera.h"
#include "viz/draw/color.h"
#include "viz/draw/font.h"
#include "viz/draw/frame_renderer.h"
#include "viz/draw/overlay.h"

namespace kerf {

/// A count for each step, from step 1 on; negative: not counted.
struct StoryCurve {
  std::string name;
  Color color;
  std::vector<float> values;
};

/// What a picture of a story shows beside and below its scene.
struct StoryPanels {
  std::string title;                     ///< above the scene, in ink
  std::string figures;                   ///< behind it, fainter
  std::string sentence;                  ///< below the scene; empty: nothing happens
  const TreeSnapshot* tree = nullptr;    ///< of the icicle
  std::uint32_t largest_population = 1;  ///< end of the ramp
  std::uint32_t levels = 1;              ///< for which the icicle has room
  std::optional<NodeId> acting;          ///< the node that the sentence is about
  const std::vector<StoryCurve>* curves = nullptr;
  std::uint32_t step = 1;           ///< up to which the curves are drawn
  std::array<std::string, 2> ends;  ///< the names of the first and the last step of the curves
};

/// The height of its letters: that of a picture 16:9 which fits into it.
int story_letters(int width, int height);

/// The margins of such a picture: a line above the scene, two below it, and a third of the width at the
/// right.
Margins story_margins(int width, int height);

/// Draws into the margins: the icicle above the curves, which have a logarithmic scale.
void draw_story(const View& view, const Font& font, const StoryPanels& panels, Overlay& overlay);

/// "1,124,250".
std::string with_commas(std::uint64_t number);

}  // namespace kerf
