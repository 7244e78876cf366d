#include "viz/debugger/gui/widgets.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "viz/debugger/gui/wrap.h"
#include "viz/draw/letters.h"
#include "viz/draw/palette.h"

namespace kerf::widgets {

constexpr std::size_t kHintColumns = 70;

void hint(const char* text) {
  constexpr float kPatience = 0.6F;  // seconds
  if (*text != '\0' && ImGui::IsItemHovered() && ImGui::GetCurrentContext()->HoveredIdTimer > kPatience)
    ImGui::SetTooltip("%s", text);
}

bool button(Gui& gui, const char* label, const char* text, const std::string& name) {
  const bool pressed = ImGui::Button(label);
  gui.name_last_item(name.empty() ? label : name, label);
  hint(text);
  return pressed;
}

bool checkbox(Gui& gui, const char* label, bool& value, const char* text, const std::string& name) {
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1);
  ImGui::PushStyleColor(ImGuiCol_Border, to_imgui(palette::kFaintInk));
  const bool changed = ImGui::Checkbox(label, &value);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  gui.name_last_item(name.empty() ? label : name);
  hint(text);
  return changed;
}

bool text_field(Gui& gui, const char* name, std::string& text, const char* inside, float width) {
  ImGui::SetNextItemWidth(width);
  const std::string id = std::string("##") + name;
  const std::string shown = elided(inside, ImGui::CalcItemWidth() - 2 * ImGui::GetStyle().FramePadding.x);
  const bool entered =
      ImGui::InputTextWithHint(id.c_str(), shown.c_str(), &text, ImGuiInputTextFlags_EnterReturnsTrue);
  gui.name_last_item(name);
  if (text.empty() && shown != inside) hint(inside);
  return entered;
}

namespace {

/// The share of a slider's way that lies before its value.
float share_before(float value, const SliderRange& range) {
  const float inside = std::clamp(value, range.least, range.most);
  return range.logarithmic ? std::log(inside / range.least) / std::log(range.most / range.least)
                           : (inside - range.least) / (range.most - range.least);
}

/// Below the letters, and those that reach below their line.
void draw_bar(float share) {
  constexpr float kHeight = 2;
  constexpr float kAround = 2;
  const ImVec2 a = ImGui::GetItemRectMin();
  const ImVec2 b = ImGui::GetItemRectMax();
  const float way = b.x - a.x - 2 * kAround - ImGui::GetStyle().GrabMinSize;  // of the middle of the grab
  const float end = a.x + kAround + 0.5F * ImGui::GetStyle().GrabMinSize + share * way;
  const double alpha = ImGui::IsItemHovered() || ImGui::IsItemActive() ? 1 : 0.7;
  ImGui::GetWindowDrawList()->AddRectFilled({a.x + kAround, b.y - kHeight}, {end, b.y},
                                            to_imgui(palette::kPartitioner, alpha));
}

}  // namespace

bool slider(Gui& gui, const char* name, float& value, const SliderRange& range, const char* format,
            float width) {
  ImGui::SetNextItemWidth(width);
  for (const ImGuiCol grab : {ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive})
    ImGui::PushStyleColor(grab, ImVec4{0, 0, 0, 0});
  const std::string id = std::string("##") + name;
  const bool changed =
      ImGui::SliderFloat(id.c_str(), &value, range.least, range.most, format,
                         range.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
  ImGui::PopStyleColor(2);
  gui.name_last_item(name);
  if (!ImGui::TempInputIsActive(ImGui::GetItemID())) draw_bar(share_before(value, range));
  return changed;
}

void go_on_typing() {
  ImGuiInputTextState* const state = ImGui::GetInputTextState(ImGui::GetItemID());
  if (state != nullptr && ImGui::IsItemActivated()) state->ClearSelection();
}

bool row(Gui& gui, const std::string& label, const std::string& name, bool selected) {
  const float room = ImGui::GetContentRegionAvail().x;
  const bool is_cut = ImGui::CalcTextSize(label.c_str()).x > room;
  const bool scrolls = (ImGui::GetCurrentWindow()->Flags & ImGuiWindowFlags_HorizontalScrollbar) != 0;
  const std::string& shown = is_cut && !scrolls ? elided(label, room) : label;
  const bool pressed = ImGui::Selectable((shown + "##" + name).c_str(), selected);
  gui.name_last_item(name, label);
  if (is_cut) gui.note_last_item(shown);
  if (is_cut) hint(wrap_at_spaces(label, kHintColumns).c_str());
  return pressed;
}

void beside_or_below(float width) {
  ImGui::SameLine();
  if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
}

void wrapped_text(const std::string& text) {
  const float columns = ImGui::GetContentRegionAvail().x / ImGui::CalcTextSize("m").x;
  ImGui::TextUnformatted(wrap_at_spaces(text, static_cast<std::size_t>(std::max(1.0F, columns))).c_str());
}

void text_within(Gui& gui, const std::string& text, Color color, float width) {
  const std::string shown = elided(text, width);
  ImGui::TextColored(to_vector(color), "%s", shown.c_str());
  if (shown == text) return;
  gui.note_last_item(shown);
  hint(wrap_at_spaces(text, kHintColumns).c_str());
}

std::string elided(const std::string& text, float width) {
  return shortened(text, static_cast<std::size_t>(std::max(3.0F, width / ImGui::CalcTextSize("m").x)));
}

void draw_error_sample(ImVec2 left, Color color) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 middle{left.x + 8, left.y};
  const auto fill = [&](Color ink, float width, float radius) {
    const ImU32 of = to_imgui(ink);
    list.AddLine(left, {left.x + 16, left.y}, of, width);
    list.AddQuadFilled({middle.x - radius, middle.y}, {middle.x, middle.y - radius},
                       {middle.x + radius, middle.y}, {middle.x, middle.y + radius}, of);
  };
  fill(palette::kInk, 5, 7);
  fill(color, 2.5F, 5);
}

const Theme& theme() { return *static_cast<const Theme*>(ImGui::GetIO().UserData); }

ImU32 exactly(Color color, double alpha) {
  return IM_COL32(color.r, color.g, color.b, static_cast<int>(255 * alpha));
}

ImU32 to_imgui(Color color, double alpha) { return exactly(theme().mark(color), alpha); }

ImU32 ink(Color color) { return exactly(theme().text(color)); }

ImVec4 to_vector(Color color) { return ImGui::ColorConvertU32ToFloat4(ink(color)); }

}  // namespace kerf::widgets
