#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "tests/house/include_graph.h"

namespace kerf::house {

/// The drawing of rooms and layers with what includes what, as SVG. Arrows that a longer path implies are
/// left out.
std::string layers_svg(const IncludeGraph& graph);

/// The tables of layers, in Markdown.
std::string layer_tables(const IncludeGraph& graph);

/// The layers of each room in one line, in Markdown for README.md.
std::string floor_lines();

/// `text` with what stands between the lines `<!-- made: NAME -->` and `<!-- end -->` replaced by `content`.
/// Throws std::runtime_error when there is no such part.
std::string with_part(const std::string& text, const std::string& name, const std::string& content);

/// The files that `kerf_architecture` makes (paths from the root), with what they should contain now.
std::map<std::filesystem::path, std::string> architecture_files(const std::filesystem::path& root);

}  // namespace kerf::house
