#include "viz/debugger/gui/widgets.h"
#include "viz/debugger/model/algorithm_1.h"
#include "viz/debugger/panels/panel.h"
#include "viz/draw/palette.h"

namespace kerf {

void draw_algorithm(PanelContext& context) {
  DebuggerModel& model = context.model;
  const Algorithm1Trace trace = trace_algorithm_1(model.run());
  for (std::size_t k = 0; k < kAlgorithm1.size(); ++k) {
    const bool lit = trace.line == static_cast<int>(k) + 1;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (lit)
      ImGui::GetWindowDrawList()->AddRectFilled({at.x - 2, at.y - 1},
                                                {at.x + ImGui::GetContentRegionAvail().x, at.y + 15},
                                                widgets::to_imgui(palette::kOperator, 0.25));
    ImGui::Text("%2zu  %s", k + 1, kAlgorithm1[k].data());
    if (lit && context.memory.lit_at != model.run().position()) ImGui::SetScrollHereY(0.4F);
    if (lit) context.memory.lit_at = model.run().position();
    if (trace.decided[k].empty()) continue;
    ImGui::PushStyleColor(ImGuiCol_Text,
                          widgets::to_vector(lit ? palette::kOperator : palette::kPartitioner));
    ImGui::Indent(40);
    widgets::wrapped_text(trace.decided[k]);
    ImGui::Unindent(40);
    ImGui::PopStyleColor();
  }
  const auto selected = node_in(model.selection());
  const auto node = selected ? selected : model.run().event_node();
  if (!node || !model.run().tree().is_alive(*node)) return;
  ImGui::Separator();
  widgets::wrapped_text("n" + std::to_string(node->value) + " now: " + model.run().wish(*node));
}

}  // namespace kerf
