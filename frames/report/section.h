#pragma once

#include <functional>
#include <string>
#include <vector>

#include "frames/page/cell.h"
#include "frames/page/page.h"
#include "frames/report/cell_store.h"
#include "frames/report/report_request.h"

namespace kerf {

/// A motion or a scene in two or three dimensions, and what is measured of it.
struct SceneCell {
  std::string scene;
  int dimension = 3;
  Cell cell;

  /// "pile in 2D"
  [[nodiscard]] std::string title() const { return scene + " in " + std::to_string(dimension) + "D"; }
  /// "pile2", as a part of the names of plots.
  [[nodiscard]] std::string id() const { return scene + std::to_string(dimension); }
};

/// `what` ("total") and `objects` are parts of its key. The work is that of `work_of`.
SceneCell make_scene_cell(const std::string& what, const std::string& scene, int dimension,
                          std::uint32_t objects, const ReportSizes& sizes, double seconds,
                          std::function<Json(const Poll&)> measure);
/// The cells alone.
std::vector<Cell> cells_of(const std::vector<SceneCell>& scenes);

/// A part of the report: its measurements, and how they are shown.
struct Section {
  std::string name;  ///< the user's name for it
  std::string title;
  std::function<std::vector<Cell>(const ReportRequest&)> cells;
  /// All cells are in the store.
  std::function<void(const ReportRequest&, const CellStore&, Page&)> write;
};

/// All sections, in the order of the page.
const std::vector<Section>& report_sections();

/// The command that makes a section of the page.
std::string command_of(const ReportRequest& request, const std::string& section);

// One a file, in frames/report/sections.
Section missed_section();      ///< time against missed pairs
Section lag_section();         ///< time against lag of detection
Section volumes_section();     ///< time against candidates per contact
Section total_section();       ///< broad phase and narrow phase together
Section divergence_section();  ///< trajectories that part
Section physics_section();     ///< energy and penetration
Section needs_section();       ///< what each modelled need costs
Section hardcases_section();   ///< the heat map of hard cases

}  // namespace kerf
