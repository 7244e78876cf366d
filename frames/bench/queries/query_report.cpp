#include "frames/bench/queries/query_report.h"

#include <optional>

#include "frames/page/json.h"
#include "frames/support/machine.h"
#include "frames/support/printed.h"

namespace kerf {
namespace {

Json number(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

std::string cell(const std::optional<double>& value) { return value ? printed("%.2f", *value) : "-"; }

Json as_json(const QueryRow& row) {
  Json json{{"scene", row.scene},
            {"dim", row.dimension},
            {"objects", row.objects},
            {"kind", row.kind},
            {"found", row.found},
            {"over_fastest", number(row.over_fastest())},
            {"over_embree", number(row.over_embree())}};
  json["structures"] = Json::array();
  for (const QueryTime& time : row.times)
    json["structures"].push_back({{"name", time.structure},
                                  {"least_ns", time.least_ns},
                                  {"median_ns", time.median_ns},
                                  {"differs", time.differs}});
  return json;
}

}  // namespace

std::string query_heading() {
  return "SCENE          DIM OBJECTS QUERY         FOUND   FASTEST    EMBREE  times as long as kerf (the "
         "fastest of the others, Embree); then ns a query (build, move: an object)";
}

std::string as_text(const QueryRow& row) {
  std::string text =
      printed("%-14s %dD %8u %-10s %8.1f %9s %9s ", row.scene.c_str(), row.dimension, row.objects,
              row.kind.c_str(), row.found, cell(row.over_fastest()).c_str(), cell(row.over_embree()).c_str());
  for (const QueryTime& time : row.times) {
    text += printed(" %s %.0f", time.structure.c_str(), time.least_ns);
    if (time.differs > 0) text += printed(" (differs %u times)", time.differs);
  }
  return text;
}

std::string as_json(const BenchRequest& request, const std::vector<QueryRow>& rows, bool complete) {
  Json json;
  json["machine"] = describe_machine();
  json["settings"] = {{"rounds", request.rounds}, {"seed", request.seed}};
  json["queries"] = Json::array();
  for (const QueryRow& row : rows) json["queries"].push_back(as_json(row));
  json["complete"] = complete;
  return json_text(json) + "\n";
}

}  // namespace kerf
