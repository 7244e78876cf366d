#include "viz/draw/layers.h"

#include <array>
#include <optional>
#include <stdexcept>

namespace kerf {
namespace {

constexpr std::array<std::string_view, kLayerCount> kLayerNames{
    "objects", "partitioners", "leaves", "pairs", "contacts", "operators", "legend", "caption"};

Layer layer_at(int index) { return static_cast<Layer>(index); }

std::optional<Layer> find_layer(std::string_view name) {
  for (int i = 0; i < kLayerCount; ++i)
    if (kLayerNames[static_cast<std::size_t>(i)] == name) return layer_at(i);
  return std::nullopt;
}

[[noreturn]] void fail(std::string_view what) {
  std::string message(what);
  message += "; layers are";
  for (const std::string_view name : kLayerNames) message.append(" ").append(name);
  message += ", or all, or none; +NAME and -NAME change what is shown";
  throw std::invalid_argument(message);
}

std::string_view without_outer_spaces(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// Applies one item of the list. `first`: a plain name then starts from the empty set.
void apply_item(LayerSet& layers, std::string_view item, bool first) {
  if (item.empty()) fail("an empty layer name");
  if (item == "all" || item == "none") {
    if (!first) fail("\"" + std::string(item) + "\" can only come first");
    layers = item == "all" ? LayerSet::all() : LayerSet::none();
    return;
  }
  const bool is_change = item.front() == '+' || item.front() == '-';
  const bool shown = item.front() != '-';
  if (is_change) item.remove_prefix(1);
  const std::optional<Layer> layer = find_layer(item);
  if (!layer) fail("there is no layer \"" + std::string(item) + "\"");
  if (first && !is_change) layers = LayerSet::none();
  layers.set(*layer, shown);
}

}  // namespace

std::string_view to_string(Layer layer) { return kLayerNames[static_cast<std::size_t>(layer)]; }

LayerSet LayerSet::parse(std::string_view text, LayerSet base) {
  LayerSet layers = base;
  bool first = true;
  for (bool more = true; more; first = false) {
    const std::size_t comma = text.find(',');
    apply_item(layers, without_outer_spaces(text.substr(0, comma)), first);
    more = comma != std::string_view::npos;
    if (more) text.remove_prefix(comma + 1);
  }
  return layers;
}

std::string to_string(LayerSet layers) {
  std::string text;
  for (int i = 0; i < kLayerCount; ++i) {
    if (!layers.has(layer_at(i))) continue;
    if (!text.empty()) text += ",";
    text += kLayerNames[static_cast<std::size_t>(i)];
  }
  return text.empty() ? "none" : text;
}

}  // namespace kerf
