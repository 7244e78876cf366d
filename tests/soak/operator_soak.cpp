// Runs random cases through the machines of tests/fuzz/tree until the time is over. What finds something is
// kept as a file that `kerf_fuzz_operators` or `kerf_fuzz_broad_phase` takes, and ends the run.

#include <chrono>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/fuzz/tree/machine_report.h"
#include "tests/fuzz/tree/random_case.h"
#include "tests/soak/options.h"

namespace kerf::test {
namespace {

struct Machine {
  const char* name;
  void (*run)(CaseBytes, MachineReport&);
  MachineReport report;
};

/// Runs one case; false if it found something.
bool try_case(Machine& machine, std::uint64_t seed, const SoakOptions& options) {
  const std::vector<std::uint8_t> bytes = random_case(seed);
  machine.run(bytes, machine.report);
  if (machine.report.finding.empty()) return true;
  const std::filesystem::path file = options.keep / (std::string(machine.name) + "-" + std::to_string(seed));
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  std::printf("finding: %s (seed %llu, kept as %s)\n", machine.report.finding.c_str(),
              static_cast<unsigned long long>(seed), file.c_str());
  return false;
}

nlohmann::json figures(const MachineReport& report) {
  nlohmann::json json{
      {"cases", report.cases},     {"requests", report.requests},       {"operators", report.operators()},
      {"refused", report.refused}, {"validations", report.validations}, {"comparisons", report.comparisons},
      {"pairs", report.pairs},     {"finding", report.finding}};
  for (std::size_t op = 0; op < report.acted.size(); ++op)
    json["acted"][std::string(to_string(static_cast<Operator>(op)))] = report.acted[op];
  return json;
}

int run(const SoakOptions& options) {
  std::array machines{Machine{"operators", run_operator_case, {}},
                      Machine{"broad_phase", run_broad_phase_case, {}}};
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [start] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  bool sound = true;
  std::uint64_t seed = options.seed << 32U;
  while (sound && seconds() < 60 * options.minutes) {
    for (int i = 0; i < 4 && sound; ++i) sound = try_case(machines[0], ++seed, options);
    if (sound) sound = try_case(machines[1], ++seed, options);
  }
  nlohmann::json report{{"program", "operators"}, {"seed", options.seed}, {"seconds", seconds()}};
  std::uint64_t operators = 0;
  for (const Machine& machine : machines) {
    report["machines"][machine.name] = figures(machine.report);
    operators += machine.report.operators();
  }
  report["executions"] = operators;
  report["findings"] = sound ? 0 : 1;
  std::printf("%s\n", report.dump(2).c_str());
  if (!options.json.empty()) std::ofstream(options.json) << report.dump(2) << '\n';
  return sound ? 0 : 1;
}

}  // namespace
}  // namespace kerf::test

int main(int argc, char** argv) { return kerf::test::run(kerf::test::soak_options(argc, argv)); }
