#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/query/their_parts.h"
#include "viz/draw/draw_context.h"

namespace kerf {

/// A text and where it belongs.
using PlacedText = std::pair<Eigen::Vector3d, std::string>;

/// Another engine's structure as structures are drawn beside each other, as far as their layers are shown.
template <int D>
void draw_their_nodes(const DrawContext<D>& frame, const StructureParts<D>& parts, LayerSet layers,
                      Batch& areas, Batch& outlines);

/// Marks the nodes and objects with faults; what to write at the first few.
template <int D>
std::vector<PlacedText> draw_their_faults(const DrawContext<D>& frame, const StructureParts<D>& parts,
                                          std::span<const StructureFault> faults, Batch& front);

}  // namespace kerf
