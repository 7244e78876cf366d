#include "viz/debugger/gui/progress_screen.h"

#include <imgui.h>

#include <algorithm>

#include "viz/debugger/gui/widgets.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

constexpr float kWidest = 460;  // of the card, in pixels
constexpr auto kCard = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                       ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize;

void draw_card(const ProgressWords& words, float width) {
  ImGui::TextUnformatted(words.deed.c_str());
  if (words.done) {
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, widgets::to_vector(palette::kMoving));
    ImGui::ProgressBar(static_cast<float>(std::clamp(*words.done, 0.0, 1.0)), {width, 0}, "");
    ImGui::PopStyleColor();
  }
  if (!words.state.empty()) ImGui::TextUnformatted(words.state.c_str());
  if (!words.hint.empty()) ImGui::TextDisabled("%s", words.hint.c_str());
}

}  // namespace

ProgressScreen::ProgressScreen(GlContext& context) : context_(context), gui_(context.functions()) {}

void ProgressScreen::draw(const ProgressWords& words, int width, int height) {
  context_.make_current();
  if (width != width_ || height != height_) framebuffer_.emplace(context_.functions(), width, height, 1);
  width_ = width;
  height_ = height;
  gui_.begin({}, width, height);
  const ImVec2 size{static_cast<float>(width), static_cast<float>(height)};
  const float card = std::min(kWidest, size.x);
  ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::SetNextWindowSizeConstraints({card, 0}, size);
  if (ImGui::Begin("progress", nullptr, kCard)) draw_card(words, ImGui::GetContentRegionAvail().x);
  ImGui::End();
  gui_.end();
  framebuffer_->bind();
  const auto& gl = context_.functions();
  gl.ClearColor(0.93F, 0.93F, 0.91F, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gui_.draw();
  check_gl(gl, "drawing progress");
}

Image ProgressScreen::picture() {
  context_.make_current();
  Image image;
  framebuffer_->read(image);
  return image;
}

}  // namespace kerf
