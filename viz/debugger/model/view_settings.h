#pragma once

#include <array>
#include <optional>
#include <set>
#include <string_view>

#include "core/base/ids.h"
#include "core/tree/node.h"
#include "viz/draw/layers.h"

namespace kerf {

/// The meaning of the colour of leaves and of the objects in them.
enum class Tint : std::uint8_t { population, balance, redundancy, cost, age };
inline constexpr std::array<std::string_view, 5> kTintNames{"population", "balance", "redundancy", "cost",
                                                            "age"};

/// Which parts of the scene are shown, and how.
struct ViewSettings {
  LayerSet layers = LayerSet::none()
                        .with(Layer::objects, true)
                        .with(Layer::partitioners, true)
                        .with(Layer::leaves, true)
                        .with(Layer::pairs, true)
                        .with(Layer::operators, true);
  Tint tint = Tint::population;
  int least_depth = 0;  ///< partitioners of other depths are left out
  int greatest_depth = static_cast<int>(kMaxHeight);
  std::optional<NodeId> isolated;  ///< only the part below it
  std::set<NodeId> hidden_nodes;   ///< with everything below them
  std::set<ObjectId> hidden_objects;
  friend bool operator==(const ViewSettings&, const ViewSettings&) = default;
};

}  // namespace kerf
