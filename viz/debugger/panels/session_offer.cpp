#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/panels/panel.h"
#include "viz/draw/palette.h"

namespace kerf {

void draw_session_offer(PanelContext& context) {
  SessionMemory& session = context.memory.session;
  const auto view = context.gui.find("view");
  if (session.offer.empty() || !view) return;
  ImGui::SetNextWindowPos({view->x + 0.5F * view->width, view->y + 0.3F * view->height}, ImGuiCond_Always,
                          {0.5F, 0});
  ImGui::SetNextWindowSize({400, 0});
  constexpr auto kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;
  if (ImGui::Begin("session", nullptr, kFlags)) {
    ImGui::TextUnformatted("Go on where you were?");
    context.gui.note_last_item("Go on where you were?");
    widgets::wrapped_text(session.offer);
    if (!session.offer_warning.empty()) {
      ImGui::PushStyleColor(ImGuiCol_Text, widgets::to_vector(palette::kCandidate));
      widgets::wrapped_text(session.offer_warning);
      ImGui::PopStyleColor();
    }
    ImGui::Spacing();
    if (widgets::button(context.gui, "go on (Enter)", "", "go on")) session.answer = true;
    ImGui::SameLine();
    if (widgets::button(context.gui, "begin anew (Escape)",
                        "the earlier session gets the name FILE.session.earlier", "begin anew"))
      session.answer = false;
  }
  ImGui::End();
}

}  // namespace kerf
