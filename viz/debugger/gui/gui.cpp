#include "viz/debugger/gui/gui.h"

#include <imgui.h>
#include <imgui_internal.h>

#include "viz/draw/font.h"
#include "viz/draw/palette.h"

namespace kerf {
namespace {

constexpr float kLetters = 13;  // height of a line's letters in pixels

ImVec4 color_of(Color color, double alpha = 1) {
  return {static_cast<float>(color.r) / 255, static_cast<float>(color.g) / 255,
          static_cast<float>(color.b) / 255, static_cast<float>(alpha)};
}

PanelArea last_item() {
  const ImVec2 least = ImGui::GetItemRectMin();
  const ImVec2 size = ImGui::GetItemRectSize();
  return {least.x, least.y, size.x, size.y};
}

void set_colors(ImGuiStyle& style) {
  ImGui::StyleColorsLight(&style);
  const auto set = [&](int what, ImVec4 color) { style.Colors[what] = color; };
  set(ImGuiCol_WindowBg, color_of(palette::kPanel));
  set(ImGuiCol_ChildBg, color_of({248, 248, 245}));
  set(ImGuiCol_PopupBg, color_of({252, 252, 250}));
  set(ImGuiCol_Text, color_of(palette::kInk));
  set(ImGuiCol_TextDisabled, color_of({105, 105, 105}));
  set(ImGuiCol_Border, color_of({200, 200, 194}));
  set(ImGuiCol_FrameBg, color_of({255, 255, 255}));
  set(ImGuiCol_Button, color_of({222, 226, 230}));
  set(ImGuiCol_ButtonHovered, color_of({190, 214, 232}));
  set(ImGuiCol_ButtonActive, color_of({150, 195, 225}));
  set(ImGuiCol_Header, color_of(palette::kMoving, 0.35));
  set(ImGuiCol_HeaderHovered, color_of(palette::kMoving, 0.25));
  set(ImGuiCol_HeaderActive, color_of(palette::kMoving, 0.5));
  set(ImGuiCol_Tab, color_of({222, 226, 230}));
  set(ImGuiCol_TabActive, color_of({248, 248, 245}));
  set(ImGuiCol_TabHovered, color_of({190, 214, 232}));
  set(ImGuiCol_CheckMark, color_of(palette::kPartitioner));
  set(ImGuiCol_SliderGrab, color_of(palette::kPartitioner, 0.3));
  set(ImGuiCol_TableHeaderBg, color_of({228, 228, 222}));
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

void add_typeface(ImFontAtlas& fonts) {
  const auto file = font_file();
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = 1;
  config.PixelSnapH = true;
  // ImGui only reads it, but its interface takes a pointer to non-const.
  void* const data = const_cast<std::uint8_t*>(file.data());
  fonts.AddFontFromMemoryTTF(data, static_cast<int>(file.size()), kLetters, &config);
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
  set_colors(ImGui::GetStyle());
  set_shapes(ImGui::GetStyle());
  add_typeface(*io.Fonts);
  painter_ = std::make_unique<PanelPainter>(gl);
}

Gui::~Gui() { ImGui::SetCurrentContext(context_.get()); }

void Gui::begin(const DebuggerInput& input, int width, int height) {
  ImGui::SetCurrentContext(context_.get());
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  io.DeltaTime = static_cast<float>(input.seconds);
  io.MousePos = {input.mouse_x, input.mouse_y};
  for (std::size_t k = 0; k < input.buttons.size(); ++k) io.MouseDown[k] = input.buttons[k];
  io.MouseWheel = input.wheel;
  io.MouseWheelH = input.sideways;
  io.KeyShift = input.shift;
  io.KeyCtrl = input.control;
  for (int key = 0; key < static_cast<int>(Key::count); ++key) io.KeysDown[key] = false;
  if (input.key) io.KeysDown[static_cast<int>(*input.key)] = true;
  io.AddInputCharactersUTF8(input.text.c_str());
  named_.clear();
  shown_.clear();
  ImGui::NewFrame();
  io.KeyShift = input.shift;  // since 1.87 a new frame takes modifiers from key events alone
  io.KeyCtrl = input.control;
}

void Gui::end() { ImGui::Render(); }

void Gui::draw() const {
  ImGui::SetCurrentContext(context_.get());
  painter_->draw(*ImGui::GetDrawData());
}

bool Gui::is_typing() const {
  return context_->ActiveId != 0 && context_->InputTextState.ID == context_->ActiveId;
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
