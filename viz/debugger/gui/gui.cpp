#include "viz/debugger/gui/gui.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "viz/draw/font.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

// In units of the panels, the height of a line's letters and the width of each.
constexpr float kLetters = 13;
constexpr float kLetterWidth = 7;

ImVec4 color_of(Color color, double alpha = 1) {
  return {static_cast<float>(color.r) / 255, static_cast<float>(color.g) / 255,
          static_cast<float>(color.b) / 255, static_cast<float>(alpha)};
}

/// What its window shows of it: a row may be wider than its panel. (The clip of the draw list is the cell
/// alone after a row over all columns of a table.)
PanelArea last_item() {
  const ImVec2 least = ImGui::GetItemRectMin();
  const ImVec2 most = ImGui::GetItemRectMax();
  const ImVec2 origin = ImGui::GetWindowPos();
  const ImVec2 size = ImGui::GetWindowSize();
  const float left = std::max(least.x, origin.x);
  const float top = std::max(least.y, origin.y);
  return {left, top, std::min(most.x, origin.x + size.x) - left, std::min(most.y, origin.y + size.y) - top};
}

void set_colors(ImGuiStyle& style, const Theme& theme) {
  if (theme.name == ThemeName::light) {
    ImGui::StyleColorsLight(&style);
  } else {
    ImGui::StyleColorsDark(&style);
  }
  const auto set = [&](int what, Color color, double alpha = 1) {
    style.Colors[what] = color_of(color, alpha);
  };
  const Color mark = theme.mark(palette::kPartitioner);
  set(ImGuiCol_WindowBg, theme.panel);
  set(ImGuiCol_ChildBg, theme.list);
  set(ImGuiCol_PopupBg, theme.popup);
  set(ImGuiCol_Text, theme.text(palette::kInk));
  set(ImGuiCol_TextDisabled, theme.text(palette::kFaintInk));
  set(ImGuiCol_Border, theme.border);
  set(ImGuiCol_FrameBg, theme.field);
  set(ImGuiCol_FrameBgHovered, theme.row_hovered);
  set(ImGuiCol_FrameBgActive, theme.selected);
  set(ImGuiCol_Button, theme.button);
  set(ImGuiCol_ButtonHovered, theme.hovered);
  set(ImGuiCol_ButtonActive, theme.pressed);
  set(ImGuiCol_Header, theme.selected);
  set(ImGuiCol_HeaderHovered, theme.row_hovered);
  set(ImGuiCol_HeaderActive, theme.selected);
  set(ImGuiCol_TitleBg, theme.button);
  set(ImGuiCol_TitleBgActive, theme.button);
  set(ImGuiCol_Tab, theme.button);
  set(ImGuiCol_TabActive, theme.list);
  set(ImGuiCol_TabHovered, theme.hovered);
  set(ImGuiCol_TabUnfocused, theme.button);
  set(ImGuiCol_TabUnfocusedActive, theme.list);
  set(ImGuiCol_CheckMark, mark);
  set(ImGuiCol_NavHighlight, theme.divider);
  set(ImGuiCol_SliderGrab, mark, 0.3);
  set(ImGuiCol_SliderGrabActive, mark, 0.5);
  set(ImGuiCol_TextSelectedBg, mark, 0.3);
  set(ImGuiCol_TableHeaderBg, theme.table_header);
  set(ImGuiCol_TableBorderLight, theme.border);
  set(ImGuiCol_TableBorderStrong, theme.border);
  set(ImGuiCol_TableRowBgAlt, theme.odd_row);
}

void set_shapes(ImGuiStyle& style) {
  style.WindowRounding = 0;
  style.FrameRounding = 3;
  style.TabRounding = 3;
  style.ScrollbarSize = 11;
  style.WindowPadding = {6, 5};
  style.FramePadding = {5, 3};
  style.ItemSpacing = {5, 4};
  style.CellPadding = {3, 1};
  style.IndentSpacing = 12;
  style.WindowBorderSize = 1;
}

/// ImGui looks up the keys of its text fields by these names.
void map_keys(ImGuiIO& io) {
  const auto map = [&](ImGuiKey key, Key ours) { io.KeyMap[key] = static_cast<int>(ours); };
  map(ImGuiKey_Space, Key::space);
  map(ImGuiKey_Home, Key::home);
  map(ImGuiKey_End, Key::end);
  map(ImGuiKey_Escape, Key::escape);
  map(ImGuiKey_Enter, Key::enter);
  map(ImGuiKey_Backspace, Key::backspace);
  map(ImGuiKey_Delete, Key::del);
  map(ImGuiKey_LeftArrow, Key::left);
  map(ImGuiKey_RightArrow, Key::right);
  map(ImGuiKey_UpArrow, Key::up);
  map(ImGuiKey_DownArrow, Key::down);
  map(ImGuiKey_Tab, Key::tab);
}

void add_typeface(ImFontAtlas& fonts, double scale) {
  const auto file = font_file();
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = 1;
  config.PixelSnapH = true;
  const auto pixels = static_cast<float>(scale);
  config.GlyphMinAdvanceX = config.GlyphMaxAdvanceX = std::floor(kLetterWidth * pixels);
  // ImGui only reads it, but its interface takes a pointer to non-const.
  void* const data = const_cast<std::uint8_t*>(file.data());
  fonts.AddFontFromMemoryTTF(data, static_cast<int>(file.size()), std::round(kLetters * pixels), &config);
  fonts.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
}

}  // namespace

void Gui::Forget::operator()(ImGuiContext* context) const { ImGui::DestroyContext(context); }

Gui::Gui(const GlFunctions& gl) : context_(ImGui::CreateContext()) {
  ImGui::SetCurrentContext(context_.get());
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigInputTextCursorBlink = false;  // a picture must not depend on the time
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  map_keys(io);
  set_shapes(ImGui::GetStyle());
  set_theme(theme_called(ThemeName::light));
  add_typeface(*io.Fonts, scale_);
  painter_ = std::make_unique<PanelPainter>(gl);
}

Gui::~Gui() { ImGui::SetCurrentContext(context_.get()); }

void Gui::set_theme(const Theme& theme) {
  if (theme_ == &theme) return;
  theme_ = &theme;
  ImGui::SetCurrentContext(context_.get());
  ImGui::GetIO().UserData = const_cast<Theme*>(theme_);  // which the widgets only read
  set_colors(ImGui::GetStyle(), theme);
}

void Gui::set_scale(double scale) {
  if (scale == scale_) return;
  scale_ = scale;
  ImGui::SetCurrentContext(context_.get());
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  add_typeface(*io.Fonts, scale);
  io.FontGlobalScale = 1 / static_cast<float>(scale);
  ImGui::GetStyle().AntiAliasedLinesUseTex = scale == std::round(scale);
  painter_->take_typeface();
  beside_.forget();
}

void Gui::begin(const DebuggerInput& input, int width, int height) {
  ImGui::SetCurrentContext(context_.get());
  ImGuiIO& io = ImGui::GetIO();
  const auto scale = static_cast<float>(scale_);
  picture_ = {width, height, scale};
  io.DisplaySize = {std::ceil(static_cast<float>(width) / scale),
                    std::ceil(static_cast<float>(height) / scale)};
  io.DeltaTime = static_cast<float>(input.seconds);
  io.MousePos = {input.mouse_x / scale, input.mouse_y / scale};
  for (std::size_t k = 0; k < input.buttons.size(); ++k) io.MouseDown[k] = input.buttons[k];
  is_held_ = std::ranges::find(input.buttons, true) != input.buttons.end();
  io.MouseWheel = input.wheel;
  io.MouseWheelH = input.sideways;
  io.KeyShift = input.shift;
  io.KeyCtrl = input.control;
  // Arrow keys, Space and Enter belong to a menu while there is one.
  const bool has_menu = !context_->OpenPopupStack.empty();
  io.ConfigFlags = has_menu ? ImGuiConfigFlags_NavEnableKeyboard : ImGuiConfigFlags_None;
  for (int key = 0; key < static_cast<int>(Key::count); ++key) io.KeysDown[key] = false;
  if (input.key) io.KeysDown[static_cast<int>(*input.key)] = true;
  if (has_menu && input.key == Key::enter) io.KeysDown[static_cast<int>(Key::space)] = true;
  io.AddInputCharactersUTF8(input.text.c_str());
  named_.clear();
  shown_.clear();
  ImGui::NewFrame();
  io.KeyShift = input.shift;  // since 1.87 a new frame takes modifiers from key events alone
  io.KeyCtrl = input.control;
}

void Gui::end() { ImGui::Render(); }

bool Gui::is_same_beside(const PanelArea& scene) {
  ImGui::SetCurrentContext(context_.get());
  return beside_.take(*ImGui::GetDrawData(), scene);
}

void Gui::draw() const { draw_within({0, 0, picture_.width, picture_.height}); }

void Gui::draw_within(const PixelArea& part) const {
  ImGui::SetCurrentContext(context_.get());
  painter_->draw(*ImGui::GetDrawData(), picture_, part);
}

bool Gui::has_keys() const { return is_typing() || !context_->OpenPopupStack.empty(); }

bool Gui::is_typing() const {
  return context_->ActiveId != 0 && context_->InputTextState.ID == context_->ActiveId;
}

Pointer Gui::pointer() const {
  ImGui::SetCurrentContext(context_.get());
  switch (ImGui::GetMouseCursor()) {
    case ImGuiMouseCursor_TextInput:
      return Pointer::text;
    case ImGuiMouseCursor_ResizeEW:
      return Pointer::across;
    case ImGuiMouseCursor_ResizeNS:
      return Pointer::down;
    case ImGuiMouseCursor_Hand:
      return Pointer::hand;
    default:
      return Pointer::arrow;
  }
}

void Gui::name_last_item(const std::string& name, const std::string& shown) {
  if (!ImGui::IsItemVisible()) return;  // scrolled away, so it cannot be clicked
  named_[name] = last_item();
  note_last_item(shown);
}

void Gui::note_last_item(const std::string& shown) {
  const std::string text = shown.substr(0, shown.find("##"));  // the rest is never shown
  if (ImGui::IsItemVisible()) shown_.try_emplace(text.substr(0, text.find_last_not_of(' ') + 1), last_item());
}

std::optional<PanelArea> Gui::find(const std::string& name) const {
  for (const auto* areas : {&named_, &shown_})
    if (const auto found = areas->find(name); found != areas->end()) return found->second;
  return std::nullopt;
}

}  // namespace kerf
