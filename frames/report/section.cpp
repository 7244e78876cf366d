#include "frames/report/section.h"

namespace kerf {

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
