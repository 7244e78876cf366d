#include "frames/bench/bench_report.h"

#include "frames/bench/ablation.h"
#include "frames/bench/loop_report.h"
#include "frames/catalog/algorithm.h"
#include "frames/page/json.h"
#include "frames/support/machine.h"
#include "frames/support/printed.h"

namespace kerf {
namespace {

std::string as_text(const CellName& cell) {
  return printed("%-14s %dD %8u %2u", cell.scene.c_str(), cell.dimension, cell.objects, cell.threads);
}

Json name_json(const CellName& cell, const std::string& algorithm) {
  return {{"scene", cell.scene},
          {"dim", cell.dimension},
          {"objects", cell.objects},
          {"algorithm", algorithm},
          {"threads", cell.threads}};
}

}  // namespace

Json as_json(const BenchRow& row) {
  Json json = name_json(row.cell, row.algorithm);
  json.update({{"median_ns", row.median_ns},
               {"p90_ns", row.p90_ns},
               {"p99_ns", row.p99_ns},
               {"max_ns", row.max_ns},
               {"native_ns", row.native_ns},
               {"build_ns", row.build_ns},
               {"pairs", row.pairs},
               {"missed", row.missed},
               {"extra", row.extra},
               {"times_floor", row.times_floor},
               {"rss_bytes", row.rss_bytes},
               {"steps", row.steps},
               {"round_ns", row.round_ns}});
  if (row.tests_per_pair) json["tests_per_pair"] = *row.tests_per_pair;
  if (!row.step_ns.empty()) json["step_ns"] = row.step_ns;
  return json;
}

Json as_json(const BenchGap& gap) {
  Json json = name_json(gap.cell, gap.algorithm);
  json["reason"] = gap.reason;
  return json;
}

std::string bench_heading() {
  return "SCENE          DIM OBJECTS TH ALGORITHM                 MEDIAN      P90      P99   NATIVE  ns an "
         "object and step\n" +
         std::string(66, ' ') + "                            FLOORS      PAIRS   MISSED    EXTRA  B/OBJECT";
}

std::string as_text(const BenchRow& row) {
  return as_text(row.cell) +
         printed(" %-24s %8.1f %8.1f %8.1f %8.1f  %7.1f %10llu %8llu %8llu %9.0f", row.algorithm.c_str(),
                 row.median_ns, row.p90_ns, row.p99_ns, row.native_ns, row.times_floor,
                 static_cast<unsigned long long>(row.pairs), static_cast<unsigned long long>(row.missed),
                 static_cast<unsigned long long>(row.extra),
                 static_cast<double>(row.rss_bytes) / row.cell.objects);
}

std::string as_text(const BenchGap& gap) {
  return as_text(gap.cell) + printed(" %-24s %s", gap.algorithm.c_str(), gap.reason.c_str());
}

std::string as_json(const BenchRequest& request, const BenchResult& all, bool complete) {
  Json json;
  json["machine"] = describe_machine();
  json["settings"] = {{"rounds", request.rounds}, {"seed", request.seed}, {"patience_s", request.patience}};
  json["results"] = Json::array();
  for (const BenchRow& row : all.cells.rows) json["results"].push_back(as_json(row));
  json["gaps"] = Json::array();
  for (const BenchGap& gap : all.cells.gaps) json["gaps"].push_back(as_json(gap));
  json["simulations"] = Json::array();
  for (const LoopRow& row : all.loops) json["simulations"].push_back(as_json(row));
  json["earnings"] = Json::array();
  if (request.ablation)
    for (const Earning& earning : earnings(all.cells.rows, std::string(kTunedTree)))
      json["earnings"].push_back(as_json(earning));
  json["complete"] = complete;
  return json_text(json) + "\n";
}

}  // namespace kerf
