#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>

#include "core/base/ids.h"
#include "core/tree/node.h"
#include "viz/draw/camera.h"
#include "viz/draw/layers.h"

namespace kerf {

/// The meaning of the colour of leaves and of the objects in them.
enum class Tint : std::uint8_t { population, balance, redundancy, cost, age };
inline constexpr std::array<std::string_view, 5> kTintNames{"population", "balance", "redundancy", "cost",
                                                            "age"};

/// A direction from which the user wants to see the scene, of `kDirectionNames`.
struct ViewFacing {
  std::string_view direction;
  std::uint32_t times = 0;  ///< that one was wished for: the same may be, after the mouse has turned the view
  friend bool operator==(const ViewFacing&, const ViewFacing&) = default;
};

/// Which parts of the scene are shown, and how.
struct ViewSettings {
  LayerSet layers = LayerSet::none()
                        .with(Layer::objects, true)
                        .with(Layer::partitioners, true)
                        .with(Layer::leaves, true)
                        .with(Layer::pairs, true)
                        .with(Layer::operators, true);
  Tint tint = Tint::population;
  bool theirs = false;  ///< another engine's structure instead of our tree
  int least_depth = 0;  ///< partitioners of other depths are left out
  int greatest_depth = static_cast<int>(kMaxHeight);
  std::optional<NodeId> isolated;  ///< only the part below it
  std::set<NodeId> hidden_nodes;   ///< with everything below them
  std::set<ObjectId> hidden_objects;
  ViewFacing facing{};
  std::string query;  ///< asked of the tree and drawn, see parse_query; empty: none

  void face(std::string_view direction) { facing = {direction, facing.times + 1}; }
  /// From the direction that follows the last one in their list, or stands before it.
  void face_next(bool forwards) {
    const auto last = std::ranges::find(kDirectionNames, facing.direction);
    const auto at = static_cast<std::size_t>(last - kDirectionNames.begin());
    const std::size_t count = kDirectionNames.size();
    face(kDirectionNames[at == count ? 0 : (at + (forwards ? 1 : count - 1)) % count]);
  }
  friend bool operator==(const ViewSettings&, const ViewSettings&) = default;
};

/// What the user chose of a camera, in either dimension.
using AnyCamera = std::variant<CameraChoice<2>, CameraChoice<3>>;

}  // namespace kerf
