#include "frames/bench/loop_report.h"

#include <nlohmann/json.hpp>

#include "frames/support/printed.h"

namespace kerf {

std::string loop_heading() {
  return "SIMULATION     DIM OBJECTS BROAD PHASE              IN LOOP    ALONE  RATIO  SHARE OF STEP   ns an "
         "object and step";
}

std::string as_text(const LoopRow& row) {
  return printed("%-14s %dD %8u %-24s %8.1f %8.1f %6.2f %13.1f%%", row.scene.c_str(), row.dimension,
                 row.objects, row.broad_phase.c_str(), row.loop_ns, row.alone_ns, row.ratio, 100 * row.share);
}

nlohmann::ordered_json as_json(const LoopRow& row) {
  return {{"scene", row.scene},     {"dim", row.dimension},
          {"objects", row.objects}, {"broad_phase", row.broad_phase},
          {"loop_ns", row.loop_ns}, {"alone_ns", row.alone_ns},
          {"ratio", row.ratio},     {"share", row.share},
          {"steps", row.steps}};
}

}  // namespace kerf
