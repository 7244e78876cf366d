#include "frames/report/section.h"

#include <utility>

#include "core/base/counted.h"

namespace kerf {

SceneCell make_scene_cell(const std::string& what, const std::string& scene, int dimension,
                          std::uint32_t objects, const ReportSizes& sizes, double seconds,
                          std::function<Json(const Poll&)> measure) {
  const std::string key = what + " " + scene + " " + std::to_string(dimension) + "D, " +
                          std::to_string(objects) + " objects, " + std::to_string(sizes.steps) + " steps, " +
                          counted(sizes.rounds, "round");
  return {scene, dimension, {key, std::move(measure), work_of(seconds, objects, sizes.steps)}};
}

std::vector<Cell> cells_of(const std::vector<SceneCell>& scenes) {
  std::vector<Cell> cells;
  for (const SceneCell& scene : scenes) cells.push_back(scene.cell);
  return cells;
}

const std::vector<Section>& report_sections() {
  static const std::vector<Section> sections{missed_section(), lag_section(),        volumes_section(),
                                             total_section(),  divergence_section(), physics_section(),
                                             needs_section(),  hardcases_section()};
  return sections;
}

std::string command_of(const ReportRequest& request, const std::string& section) {
  return "kerf report " + section + request.options;
}

}  // namespace kerf
