#include <algorithm>
#include <cstdio>
#include <string>
#include <variant>
#include <vector>

#include "frames/catalog/scene_catalog.h"
#include "frames/commands/command.h"
#include "frames/page/json.h"

namespace kerf {
namespace {

using Row = std::vector<std::string>;

/// The meaning of --objects, --grow and --recycle in a scene.
template <int D>
std::string parameters_of(const SceneEntry<D>& entry) {
  if (!entry.parameters.empty()) return std::string(entry.parameters);
  return "objects: those that fall; grow: steps in which they come; recycle: steps between two that fall "
         "anew";
}

Row row_of(const CatalogScene& scene) {
  return std::visit(
      [&](const auto* entry) {
        return Row{scene.name,
                   std::to_string(scene.dimension()) + "D",
                   std::to_string(entry->default_objects),
                   std::string(entry->source),
                   std::string(entry->summary),
                   describe(entry->needs),
                   parameters_of(*entry)};
      },
      scene.entry);
}

/// Columns as wide as their widest cell; the last one is not padded.
std::string table(const std::vector<Row>& rows, std::size_t columns) {
  std::string text;
  for (const Row& row : rows) {
    for (std::size_t c = 0; c < columns; ++c) {
      std::size_t width = 0;
      for (const Row& other : rows) width = std::max(width, other[c].size());
      text += row[c];
      if (c + 1 < columns) text += std::string(width - row[c].size() + 2, ' ');
    }
    text += '\n';
  }
  return text;
}

std::string as_json(const std::vector<CatalogScene>& catalog) {
  Json list = Json::array();
  for (const CatalogScene& scene : catalog) {
    std::visit(
        [&](const auto* entry) {
          list.push_back({{"name", scene.name},
                          {"dimension", scene.dimension()},
                          {"default_objects", entry->default_objects},
                          {"source", entry->source},
                          {"summary", entry->summary},
                          {"needs", describe(entry->needs)},
                          {"grows", entry->grows},
                          {"parameters", parameters_of(*entry)}});
        },
        scene.entry);
  }
  return json_text(list) + "\n";
}

std::string as_text(const std::vector<CatalogScene>& catalog, bool verbose) {
  std::vector<Row> rows{{"NAME", "DIM", "OBJECTS", "SOURCE", "SUMMARY", "NEEDS", "PARAMETERS"}};
  for (const CatalogScene& scene : catalog) rows.push_back(row_of(scene));
  return table(rows, verbose ? 7 : 5);
}

class ScenesCommand final : public Command {
 public:
  explicit ScenesCommand(CLI::App& program);
  void run() const override;

 private:
  bool verbose_ = false;
  bool json_ = false;
};

ScenesCommand::ScenesCommand(CLI::App& program)
    : Command(program, "scenes", "List the scenes that can be rendered") {
  command_->add_flag("--verbose", verbose_,
                     "Also what each scene needs of its broad phase, and what its parameters mean");
  command_->add_flag("--json", json_, "Everything, as JSON");
  command_->footer(
      "OBJECTS counts the moving objects by default; `kerf render --objects N` changes it.\n"
      "A name that exists in both dimensions is the 3D scene; NAME-2d is the 2D one.");
}

void ScenesCommand::run() const {
  const std::vector<CatalogScene> catalog = scene_catalog();
  std::fputs((json_ ? as_json(catalog) : as_text(catalog, verbose_)).c_str(), stdout);
}

}  // namespace

AnyCommand make_scenes_command(CLI::App& program) { return std::make_unique<ScenesCommand>(program); }

}  // namespace kerf
