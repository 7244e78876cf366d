#include "viz/debugger/gui/layout_beside.h"

#include <imgui.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

namespace kerf {
namespace {

/// Whether all that is seen of a command's corners lies in the area.
bool is_within(const ImVec2& least, const ImVec2& most, const ImVec4& limits, const PanelArea& area) {
  return std::max(least.x, limits.x) >= area.x && std::max(least.y, limits.y) >= area.y &&
         std::min(most.x, limits.z) <= area.right() && std::min(most.y, limits.w) <= area.bottom();
}

/// Appends what a command draws, unless it is over the scene.
void append_command(const ImDrawList& list, const ImDrawCmd& command, const PanelArea& scene,
                    std::vector<float>& drawn) {
  const std::size_t size = drawn.size();
  const ImVec4& limits = command.ClipRect;
  ImVec2 least{limits.z, limits.w};
  ImVec2 most{limits.x, limits.y};
  drawn.insert(drawn.end(), {limits.x, limits.y, limits.z, limits.w});
  for (unsigned k = 0; k < command.ElemCount; ++k) {
    const ImDrawIdx index = list.IdxBuffer[static_cast<int>(command.IdxOffset + k)];
    const auto& [at, texel, color] = list.VtxBuffer[static_cast<int>(command.VtxOffset + index)];
    drawn.insert(drawn.end(), {at.x, at.y, texel.x, texel.y, std::bit_cast<float>(color)});
    least = {std::min(least.x, at.x), std::min(least.y, at.y)};
    most = {std::max(most.x, at.x), std::max(most.y, at.y)};
  }
  if (is_within(least, most, limits, scene)) drawn.resize(size);
}

}  // namespace

bool LayoutBeside::take(const ImDrawData& data, const PanelArea& scene) {
  std::swap(drawn_, before_);
  drawn_.clear();
  for (int k = 0; k < data.CmdListsCount; ++k) {
    const ImDrawList& list = *data.CmdLists[k];
    for (const ImDrawCmd& command : list.CmdBuffer) append_command(list, command, scene, drawn_);
  }
  const bool same_place = std::exchange(scene_, scene) == scene;
  return same_place && drawn_.size() == before_.size() &&
         std::memcmp(drawn_.data(), before_.data(), drawn_.size() * sizeof(float)) == 0;
}

}  // namespace kerf
