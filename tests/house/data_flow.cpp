// The drawing of data flow in docs/ARCHITECTURE.md. Which file does each part stands in the drawing itself;
// the test `Architecture.EachPartOfTheFlowIsThere` looks for these files.
#include <stdexcept>

#include "tests/house/architecture.h"
#include "tests/house/svg.h"

namespace kerf::house {
namespace {

constexpr int kWidth = 190;
constexpr int kHeight = 54;

struct Part {
  std::string_view name;
  std::string_view file;
  Point corner;
  std::string_view fill;
};

constexpr std::string_view kScene = "#f3e8f4";
constexpr std::string_view kCore = "#e3edf7";
constexpr std::string_view kViz = "#e8f2e4";

constexpr Part kParts[] = {
    {"Scene", "core/scene/scene.h", {20, 50}, kScene},
    {"Broad phase", "core/objects/broad_phase.h", {330, 50}, kCore},
    {"Narrow phase", "sims3d/narrow_phase.h", {640, 50}, kScene},
    {"Tree and operators", "core/tree/scheduler.h", {330, 170}, kCore},
    {"Reporter", "core/trace/reporter.h", {330, 290}, kCore},
    {"Recording", "core/recording/recorder.h", {330, 410}, kCore},
    {"Cursor", "core/replay/cursor.h", {640, 410}, kCore},
    {"Pictures and films", "viz/draw/frame_renderer.h", {950, 290}, kViz},
    {"Debugger", "viz/debugger/debugger.h", {950, 410}, kViz},
    {"Questions and answers", "core/query/search.h", {950, 530}, kCore},
};

const Part& part(std::string_view name) {
  for (const Part& each : kParts)
    if (each.name == name) return each;
  throw std::logic_error("the data flow has no part " + std::string(name));
}

void draw(const Part& each, Svg& svg) {
  svg.box(each.corner, kWidth, kHeight, each.fill, "#888");
  svg.text({each.corner.x + 12, each.corner.y + 22}, each.name, "font-weight=\"bold\"");
  svg.text({each.corner.x + 12, each.corner.y + 41}, each.file, "fill=\"#444\" font-size=\"10\"");
}

/// From the right side of one part to the left side of another, with words above the arrow.
void flow_right(std::string_view from, std::string_view to, std::string_view words, Svg& svg) {
  const Point start = {part(from).corner.x + kWidth, part(from).corner.y + kHeight / 2};
  const Point end = {part(to).corner.x, part(to).corner.y + kHeight / 2};
  svg.arrow(start, end);
  svg.text({(start.x + end.x) / 2, (start.y + end.y) / 2 - 7}, words,
           "font-size=\"11\" text-anchor=\"middle\"");
}

/// From the bottom of one part to the top of another, with words beside the arrow.
void flow_down(std::string_view from, std::string_view to, std::string_view words, Svg& svg) {
  const Point start = {part(from).corner.x + kWidth / 2, part(from).corner.y + kHeight};
  const Point end = {part(to).corner.x + kWidth / 2, part(to).corner.y};
  svg.arrow(start, end);
  svg.text({start.x + 8, (start.y + end.y) / 2 + 4}, words, "font-size=\"11\"");
}

/// The way back, above the parts of the loop.
void close_the_loop(Svg& svg) {
  const Point from = {part("Narrow phase").corner.x + kWidth / 2, part("Narrow phase").corner.y};
  const Point to = {part("Scene").corner.x + kWidth / 2, part("Scene").corner.y};
  svg.path({from, {from.x, 22}, {to.x, 22}, to});
  svg.text({(from.x + to.x) / 2, 16}, "contacts move the bodies", "font-size=\"11\" text-anchor=\"middle\"");
}

}  // namespace

std::vector<std::string> data_flow_files() {
  std::vector<std::string> files;
  for (const Part& each : kParts) files.emplace_back(each.file);
  return files;
}

std::string data_flow_svg() {
  Svg svg(1160, 605);
  for (const Part& each : kParts) draw(each, svg);
  flow_right("Scene", "Broad phase", "moved boxes", svg);
  flow_right("Broad phase", "Narrow phase", "pairs", svg);
  close_the_loop(svg);
  flow_down("Broad phase", "Tree and operators", "step()", svg);
  flow_down("Tree and operators", "Reporter", "events (nothing with NoTrace)", svg);
  flow_down("Reporter", "Recording", "requests, events, keyframes, hashes", svg);
  flow_right("Recording", "Cursor", "replay", svg);
  flow_right("Cursor", "Pictures and films", "", svg);
  flow_right("Cursor", "Debugger", "any moment", svg);
  flow_right("Cursor", "Questions and answers", "", svg);
  return svg.str();
}

}  // namespace kerf::house
