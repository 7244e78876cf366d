#include "frames/advise/advice_report.h"

#include <algorithm>

#include "core/base/counted.h"
#include "frames/bench/bench_report.h"
#include "frames/page/json.h"
#include "frames/page/plot.h"
#include "frames/support/machine.h"
#include "frames/support/printed.h"

namespace kerf {
namespace {

unsigned long long wide_number(std::uint64_t x) { return x; }

/// Time, tails and memory of a row; its name stands before.
std::string figures_text(const BenchRow& row) {
  const std::string tests =
      row.tests_per_pair ? printed("%10.1f", *row.tests_per_pair) : printed("%10s", "-");
  return printed(" %8.1f %8.1f %s %9.0f", row.p99_ns / step_ns(row), row.max_ns / step_ns(row), tests.c_str(),
                 static_cast<double>(row.rss_bytes) / row.cell.objects);
}

std::string line_text(const Standing& standing) {
  return printed("%-24s %9.4f %8.2f  %6.2f-%-6.2f", standing.row.algorithm.c_str(),
                 step_milliseconds(standing.row), standing.times.median, standing.times.least,
                 standing.times.most) +
         figures_text(standing.row) + "\n";
}

std::string wrong_text(const BenchRow& row) {
  return printed("%-24s %9.4f %24s", row.algorithm.c_str(), step_milliseconds(row), "") + figures_text(row) +
         printed("  wrong: %llu missed, %llu extra\n", wide_number(row.missed), wide_number(row.extra));
}

}  // namespace

std::string advice_text(const AdvisedRecording& advised) {
  std::string text = printed("%dD, ", advised.dimension) + as_text(advised.cell.properties) + "\n" +
                     advised.steps_text + ", the first " + std::to_string(advised.plan.warm_up + 1) +
                     " to warm up; " + counted(advised.rounds, "round") + "\n\n";
  text +=
      "BROAD PHASE                MS/STEP    TIMES  ROUNDS            P99    WORST TESTS/PAIR  B/OBJECT\n";
  for (const Standing& standing : advised.advice.standings) text += line_text(standing);
  for (const BenchRow& row : advised.advice.wrong) text += wrong_text(row);
  for (const BenchGap& gap : advised.advice.left_out)
    text += printed("%-24s %s\n", gap.algorithm.c_str(), gap.reason.c_str());
  text += "\n";
  for (const std::string& sentence : advised.advice.sentences) text += sentence + "\n";
  return text;
}

std::string advice_json(const AdvisedRecording& advised) {
  Json json;
  json["machine"] = describe_machine();
  json["file"] = advised.file;
  json["dim"] = advised.dimension;
  json["steps"] = {advised.steps.first, advised.steps.last};
  json["warm_up"] = advised.plan.warm_up;
  json["rounds"] = advised.rounds;
  json["scene"] = as_json(advised.cell.properties);
  json["results"] = Json::array();
  for (const BenchRow& row : advised.cell.rows) {
    Json item = as_json(row);
    const auto standing = std::ranges::find_if(
        advised.advice.standings, [&](const Standing& each) { return each.row.algorithm == row.algorithm; });
    if (standing != advised.advice.standings.end())
      item.update({{"times", standing->times.median},
                   {"times_least", standing->times.least},
                   {"times_most", standing->times.most}});
    json["results"].push_back(std::move(item));
  }
  json["gaps"] = Json::array();
  for (const BenchGap& gap : advised.cell.gaps) json["gaps"].push_back(as_json(gap));
  json["advice"] = advised.advice.sentences;
  return json_text(json) + "\n";
}

std::string advice_plot(const AdvisedRecording& advised) {
  constexpr double kSlowest = 40;  // times the fastest: bars of more would hide the others
  BarPlot plot;
  plot.title = advised.plan.scene + ": a step of each broad phase";
  plot.x_label = "milliseconds, median and 99th percentile of the steps";
  std::uint64_t left_out = 0;
  for (const Standing& standing : advised.advice.standings)
    if (standing.times.median > kSlowest)
      ++left_out;
    else
      plot.bars.push_back({standing.row.algorithm, step_milliseconds(standing.row),
                           standing.row.p99_ns * standing.row.cell.objects * 1e-6});
  if (left_out > 0)
    plot.x_label +=
        printed("; %llu slower than %.0f times the fastest left out", wide_number(left_out), kSlowest);
  return draw(plot, "advice") + "\n";
}

}  // namespace kerf
