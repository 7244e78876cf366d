// Tries the property of hard pairs on every kind of volume, in turn, until the time is over.

#include <chrono>
#include <cstdio>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/property/pair_property.h"
#include "tests/soak/options.h"

namespace kerf::test {
namespace {

struct Subject {
  std::string name;
  std::function<void()> try_tree;
  std::function<const PropertyCount&()> count;
};

template <int D>
void add_subjects(std::vector<Subject>& subjects, std::uint64_t seed) {
  for (const VolumeKind kind : volume_kinds<D>()) {
    auto property = std::make_shared<PairProperty<D>>(kind, seed);
    subjects.push_back({std::to_string(D) + "D " + std::string(to_string(kind)),
                        [property] { property->try_tree(); },
                        [property]() -> const PropertyCount& { return property->count(); }});
  }
}

void try_until(std::chrono::steady_clock::time_point end, std::vector<Subject>& subjects) {
  constexpr int kTreesInTurn = 512;
  while (std::chrono::steady_clock::now() < end)
    for (const Subject& subject : subjects)
      for (int i = 0; i < kTreesInTurn; ++i) subject.try_tree();
}

nlohmann::json figures(const PropertyCount& c) {
  return {{"trees", c.trees}, {"pairs", c.pairs},       {"intervals", c.intervals}, {"missed", c.missed},
          {"twice", c.twice}, {"invented", c.invented}, {"apart", c.apart},         {"first", c.first}};
}

void add(PropertyCount& sum, const PropertyCount& c) {
  sum.trees += c.trees;
  sum.pairs += c.pairs;
  sum.intervals += c.intervals;
  sum.missed += c.missed;
  sum.twice += c.twice;
  sum.invented += c.invented;
  sum.apart += c.apart;
  if (sum.first.empty()) sum.first = c.first;
}

void print(const std::string& name, const PropertyCount& c) {
  std::printf("%-16s %12llu %12llu %14llu %7llu %7llu %9llu %7llu\n", name.c_str(),
              static_cast<unsigned long long>(c.trees), static_cast<unsigned long long>(c.pairs),
              static_cast<unsigned long long>(c.intervals), static_cast<unsigned long long>(c.missed),
              static_cast<unsigned long long>(c.twice), static_cast<unsigned long long>(c.invented),
              static_cast<unsigned long long>(c.apart));
}

int run(const SoakOptions& options) {
  std::vector<Subject> subjects;
  add_subjects<2>(subjects, options.seed);
  add_subjects<3>(subjects, options.seed);
  const auto start = std::chrono::steady_clock::now();
  try_until(start + std::chrono::duration_cast<std::chrono::nanoseconds>(
                        std::chrono::duration<double, std::ratio<60>>(options.minutes)),
            subjects);

  PropertyCount sum;
  nlohmann::json report{{"program", "property"}, {"seed", options.seed}};
  std::printf("%-16s %12s %12s %14s %7s %7s %9s %7s\n", "volume", "trees", "pairs", "intervals", "missed",
              "twice", "invented", "apart");
  for (const Subject& subject : subjects) {
    add(sum, subject.count());
    print(subject.name, subject.count());
    report["volumes"][subject.name] = figures(subject.count());
  }
  print("all", sum);
  if (!sum.first.empty()) std::printf("first finding: %s\n", sum.first.c_str());
  report["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  report["all"] = figures(sum);
  report["executions"] = sum.pairs;
  report["findings"] = sum.findings();
  if (!options.json.empty()) std::ofstream(options.json) << report.dump(2) << '\n';
  return sum.findings() == 0 ? 0 : 1;
}

}  // namespace
}  // namespace kerf::test

int main(int argc, char** argv) { return kerf::test::run(kerf::test::soak_options(argc, argv)); }
