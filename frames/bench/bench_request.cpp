#include "frames/bench/bench_request.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>

#include "frames/bench/ablation.h"
#include "frames/catalog/algorithm.h"
#include "frames/catalog/broad_phase_choice.h"
#include "frames/support/errors.h"
#include "frames/support/parse_number.h"

namespace kerf {
namespace {

constexpr std::uint32_t kMostObjects = 4'000'000;
constexpr std::uint32_t kMostSteps = 100'000;

std::vector<std::string> items(const std::string& option, std::string_view text) {
  std::vector<std::string> found;
  for (std::string_view rest = text;;) {
    const std::size_t comma = rest.find(',');
    found.emplace_back(rest.substr(0, comma));
    if (found.back().empty())
      throw UsageError(option + " '" + std::string(text) + "': an empty name between commas");
    if (std::ranges::count(found, found.back()) > 1)
      throw UsageError(option + " '" + std::string(text) + "' names '" + found.back() + "' twice");
    if (comma == std::string_view::npos) return found;
    rest.remove_prefix(comma + 1);
  }
}

template <class Number>
Number number(const std::string& option, std::string_view text, Number least, Number most) {
  const auto value = parse_number<Number>(text);
  if (!value || *value < least || *value > most)
    throw UsageError(option + " '" + std::string(text) + "' is no whole number from " +
                     std::to_string(least) + " to " + std::to_string(most));
  return *value;
}

template <class Number>
std::vector<Number> numbers(const std::string& option, std::string_view text, Number least, Number most) {
  std::vector<Number> found;
  for (const std::string& item : items(option, text))
    found.push_back(number<Number>(option, item, least, most));
  return found;
}

std::vector<const BenchScene*> parse_scenes(const std::string& text) {
  std::vector<const BenchScene*> scenes;
  if (text.empty() || text == "all") {
    for (const BenchScene& scene : bench_scenes()) scenes.push_back(&scene);
    return scenes;
  }
  for (const std::string& name : items("--scenes", text)) scenes.push_back(&find_bench_scene(name));
  return scenes;
}

/// The algorithms that are measured by default in some dimension, or all.
std::vector<std::string> usual_algorithms(bool all) {
  std::vector<std::string> names;
  const auto add = [&](const auto& algorithm) {
    const bool known = std::find(names.begin(), names.end(), algorithm.name) != names.end();
    if ((all || algorithm.by_default) && !known) names.push_back(algorithm.name);
  };
  for (const auto& algorithm : algorithms<3>()) add(algorithm);
  for (const auto& algorithm : algorithms<2>()) add(algorithm);
  return names;
}

std::vector<std::string> parse_algorithms(const std::string& text) {
  if (text.empty() || text == "all") return usual_algorithms(text == "all");
  std::vector<std::string> names = items("--algorithms", text);
  for (const std::string& name : names) check_algorithm(name);
  return names;
}

/// What has no meaning for simulations is refused, and each broad phase must be one that a scene can have.
void parse_simulations(const BenchTexts& texts, BenchRequest& request) {
  for (const auto& [option, text] :
       {std::pair{"--scenes", &texts.scenes}, {"--dims", &texts.dimensions}, {"--threads", &texts.threads}})
    if (!text->empty())
      throw UsageError(std::string(option) + ": --simulations names what is measured; leave one of them out");
  if (texts.trace || !texts.patience.empty())
    throw UsageError(std::string(texts.trace ? "--trace" : "--patience") +
                     " has no meaning for simulations; leave it or --simulations out");
  if (texts.simulations == "all") {
    request.simulations = scene_catalog();
  } else {
    for (const std::string& name : items("--simulations", texts.simulations))
      request.simulations.push_back(find_scene(name));
  }
  request.algorithms = {std::string(kTunedTree), std::string(kPaperTree)};
  if (!texts.algorithms.empty()) request.algorithms = items("--algorithms", texts.algorithms);
  for (const CatalogScene& scene : request.simulations)
    for (const std::string& name : request.algorithms)
      std::visit([&](const auto* entry) { (void)choose_with_parameters(name, entry->needs, "--algorithms"); },
                 scene.entry);
  request.scenes.clear();
  request.objects = {0};
}

/// What has no meaning for queries is refused.
void parse_queries(const BenchTexts& texts, BenchRequest& request) {
  for (const auto& [option, text] : {std::pair{"--algorithms", &texts.algorithms},
                                     {"--random", &texts.random},
                                     {"--simulations", &texts.simulations},
                                     {"--threads", &texts.threads},
                                     {"--steps", &texts.steps},
                                     {"--patience", &texts.patience}})
    if (!text->empty())
      throw UsageError(std::string(option) + " has no meaning for queries; leave it or --queries out");
  if (texts.ablation || texts.trace)
    throw UsageError(std::string(texts.ablation ? "--ablation" : "--trace") +
                     " has no meaning for queries; leave it or --queries out");
  request.queries = true;
  request.scenes = parse_scenes(texts.scenes.empty() ? "uniform,settled,needles" : texts.scenes);
  request.objects = {4250, 64000};
  request.rounds = 15;
}

/// Random scenes have sizes of their own; the tree is compared with what users would take instead.
void parse_random(const BenchTexts& texts, BenchRequest& request) {
  for (const auto& [option, text] : {std::pair{"--scenes", &texts.scenes},
                                     {"--simulations", &texts.simulations},
                                     {"--objects", &texts.objects},
                                     {"--dims", &texts.dimensions},
                                     {"--threads", &texts.threads}})
    if (!text->empty())
      throw UsageError(std::string(option) + ": --random draws its scenes; leave one of them out");
  if (texts.ablation || texts.trace)
    throw UsageError(std::string(texts.ablation ? "--ablation" : "--trace") +
                     " has no meaning for random scenes; leave it or --random out");
  request.scenes.clear();
  request.patience = 5;
  request.algorithms = {std::string(kTunedTree), "columns", "sort-and-sweep"};
  const auto add_libraries = [&](const auto& algorithms) {
    for (const auto& algorithm : algorithms)
      if (algorithm.origin == Origin::library && algorithm.by_default &&
          std::ranges::count(request.algorithms, algorithm.name) == 0)
        request.algorithms.push_back(algorithm.name);
  };
  add_libraries(algorithms<2>());
  add_libraries(algorithms<3>());
  for (const auto& [option, text] : {std::pair{"--algorithms", &texts.algorithms},
                                     {"--rounds", &texts.rounds},
                                     {"--steps", &texts.steps},
                                     {"--warm-up", &texts.warm_up},
                                     {"--patience", &texts.patience}})
    if (!text->empty()) request.measured_otherwise += " " + std::string(option) + " " + *text;
  if (texts.algorithms.empty()) return;
  request.algorithms = parse_algorithms(texts.algorithms);
  if (std::ranges::count(request.algorithms, std::string(kTunedTree)) == 0)
    request.algorithms.insert(request.algorithms.begin(), std::string(kTunedTree));
}

/// Whether an algorithm runs in one of the dimensions by one of the numbers of threads.
template <int D>
bool runs(const std::string& name, const BenchRequest& request) {
  const auto algorithm = find_algorithm<D>(name);
  return algorithm && std::ranges::count(request.dimensions, D) > 0 &&
         std::ranges::min(request.threads) <= algorithm->max_threads;
}

/// An algorithm that was named would be missing from all tables.
void refuse_idle(const BenchRequest& request) {
  for (const std::string& name : request.algorithms)
    if (!runs<2>(name, request) && !runs<3>(name, request))
      throw UsageError("--algorithms: '" + name +
                       "' does not run in these dimensions by so many threads; change --dims or --threads, "
                       "or leave it out");
}

}  // namespace

std::uint32_t BenchRequest::steps_for(std::uint32_t count) const {
  constexpr std::uint32_t kObjectSteps = 4'000'000;
  return steps != 0 ? steps : std::clamp(kObjectSteps / std::max(count, 1U), 12U, 300U);
}

std::uint32_t BenchRequest::warm_up_for(std::uint32_t count) const {
  constexpr std::uint32_t kObjectSteps = 4'000'000;
  return warm_up != 0 ? warm_up : std::clamp(kObjectSteps / std::max(count, 1U), 8U, 48U);
}

BenchRequest parse_bench_request(const BenchTexts& texts) {
  BenchRequest request;
  if (texts.queries) {
    parse_queries(texts, request);
  } else if (!texts.random.empty()) {
    parse_random(texts, request);
  } else if (texts.simulations.empty()) {
    request.scenes = parse_scenes(texts.scenes);
    request.algorithms = parse_algorithms(texts.algorithms);
  } else {
    parse_simulations(texts, request);
  }
  const auto many = [](auto& list, const char* option, const std::string& text, auto least, auto most) {
    using Number = typename std::remove_reference_t<decltype(list)>::value_type;
    if (!text.empty()) list = numbers<Number>(option, text, Number(least), Number(most));
  };
  const auto one = [](auto& value, const char* option, const std::string& text, auto least, auto most) {
    using Number = std::remove_reference_t<decltype(value)>;
    if (!text.empty()) value = number<Number>(option, text, Number(least), Number(most));
  };
  many(request.objects, "--objects", texts.objects, 20, kMostObjects);
  many(request.dimensions, "--dims", texts.dimensions, 2, 3);
  many(request.threads, "--threads", texts.threads, 1, 256);
  one(request.rounds, "--rounds", texts.rounds, 1, 1000);
  one(request.steps, "--steps", texts.steps, 1, kMostSteps);
  one(request.warm_up, "--warm-up", texts.warm_up, 1, kMostSteps);
  one(request.seed, "--seed", texts.seed, 0, UINT32_MAX);
  one(request.patience, "--patience", texts.patience, 1, 3600);
  one(request.random, "--random", texts.random, 1, 1'000'000);
  one(request.first, "--first", texts.first, 1, 1'000'000);
  one(request.most, "--most", texts.most, 16, 256'000);
  if (texts.random.empty() && !(texts.first + texts.most).empty())
    throw UsageError("--first and --most choose among random scenes; add --random N");
  if (texts.trace && texts.json.empty())
    throw UsageError("--trace: the times of the steps are in the JSON; add --json FILE");
  request.json = texts.json;
  request.trace = texts.trace;
  request.ablation = texts.ablation;
  const bool are_named = !texts.algorithms.empty() && texts.algorithms != "all";
  if (are_named && request.simulations.empty()) refuse_idle(request);
  if (!texts.ablation) return request;
  if (!texts.algorithms.empty())
    throw UsageError("--ablation chooses the algorithms; leave --algorithms out");
  request.algorithms = ablation_algorithms();
  return request;
}

}  // namespace kerf
