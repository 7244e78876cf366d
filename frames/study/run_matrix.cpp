#include <algorithm>
#include <utility>

#include "frames/catalog/algorithm.h"
#include "frames/catalog/broad_phase_choice.h"
#include "frames/study/matrix.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

constexpr std::uint64_t kMostMoving = 4'000'000;

/// Runs what may throw a UsageError without a place, and adds the place.
template <class Work>
auto at_key(const JsonObject& matrix, const std::string& key, std::size_t item, Work work) {
  try {
    return work();
  } catch (const UsageError& error) {
    matrix.refuse(key, item, error.what());
  }
}

using SceneChoice = std::variant<const BenchScene*, CatalogScene>;

/// A motion in a dimension, or a scene, which has one of its own.
struct Place {
  SceneChoice scene;
  std::string name;
  int dimension = 3;
  std::vector<std::string> broad_phases{};  ///< those that there are in this dimension

  [[nodiscard]] bool is_motion() const { return scene.index() == 0; }
  [[nodiscard]] bool grows() const {
    return !is_motion() &&
           std::visit([](const auto* entry) { return entry->grows; }, std::get<CatalogScene>(scene).entry);
  }
};

std::vector<Place> read_places(JsonObject& matrix) {
  std::vector<Place> places;
  const auto motions = matrix.words("motions", {});
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const BenchScene* const scene =
        at_key(matrix, "motions", k, [&] { return &find_bench_scene(motions[k]); });
    for (const std::uint64_t dimension : matrix.numbers("dimensions", 2, 3, {2, 3}))
      places.push_back({scene, motions[k], static_cast<int>(dimension)});
  }
  const auto scenes = matrix.words("scenes", {});
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const CatalogScene scene = at_key(matrix, "scenes", k, [&] { return find_scene(scenes[k]); });
    places.push_back({scene, scene.name, scene.dimension()});
  }
  return places;
}

bool takes_parameters(const std::string& broad_phase) {
  const std::string name = broad_phase.substr(0, broad_phase.find(':'));
  return name == kTunedTree || name == kPaperTree;
}

/// Trees with each of the parameters, and all others as they are.
std::vector<std::string> read_broad_phases(JsonObject& matrix) {
  const auto names = matrix.words("broad_phases", {std::string(kTunedTree), std::string(kPaperTree)});
  const auto parameters = matrix.words("parameters", {""});
  std::vector<std::string> found;
  for (std::size_t k = 0; k < names.size(); ++k) {
    at_key(matrix, "broad_phases", k, [&] { check_algorithm(names[k]); });
    if (!takes_parameters(names[k])) found.push_back(names[k]);
    for (std::size_t p = 0; takes_parameters(names[k]) && p < parameters.size(); ++p) {
      std::string text = names[k] + (parameters[p].empty() ? "" : ":") + parameters[p];
      std::ranges::replace(text, ',', ':');
      at_key(matrix, "parameters", p, [&] { check_algorithm(text); });
      found.push_back(std::move(text));
    }
  }
  if (matrix.has("parameters") && std::ranges::none_of(names, takes_parameters))
    matrix.refuse("parameters", "none of the broad phases takes any; kerf and kerf-paper do");
  return found;
}

Measures read_measures(JsonObject& matrix) {
  Measures measures{false, false, false};
  const auto words = matrix.words("measure", {"times", "counts"});
  for (std::size_t k = 0; k < words.size(); ++k) {
    bool* const chosen = words[k] == "times"    ? &measures.times
                         : words[k] == "counts" ? &measures.counts
                         : words[k] == "errors" ? &measures.errors
                                                : nullptr;
    if (chosen == nullptr) matrix.refuse("measure", k, "choose from \"times\", \"counts\", \"errors\"");
    *chosen = true;
  }
  return measures;
}

bool exists_in(const std::string& broad_phase, int dimension) {
  return dimension == 2 ? find_algorithm<2>(broad_phase).has_value()
                        : find_algorithm<3>(broad_phase).has_value();
}

/// Three of FCL's broad phases do not survive what a scene does (`broad_phase_names`).
void check_in_scene(const JsonObject& matrix, const std::string& broad_phase, const Place& place) {
  if (place.is_motion() || takes_parameters(broad_phase)) return;
  const auto& entry = std::get<CatalogScene>(place.scene).entry;
  at_key(matrix, "broad_phases", 0, [&] {
    std::visit(
        [&](const auto* scene) { (void)choose_broad_phase(broad_phase, scene->needs, "broad_phases"); },
        entry);
  });
}

void give_broad_phases(JsonObject& matrix, std::vector<Place>& places) {
  for (const std::string& broad_phase : read_broad_phases(matrix))
    for (Place& place : places) {
      if (!exists_in(broad_phase, place.dimension)) continue;
      check_in_scene(matrix, broad_phase, place);
      place.broad_phases.push_back(broad_phase);
    }
  if (std::ranges::all_of(places, [](const Place& place) { return place.broad_phases.empty(); }))
    matrix.refuse("broad_phases", "none of them exists in the dimension of the scenes");
}

/// The options that all cells of the matrix share.
RunCell read_run(JsonObject& matrix) {
  if (matrix.has("grow") && matrix.has("motions"))
    matrix.refuse("grow", "motions have all their objects from the first step; leave the key out");
  RunCell run;
  run.warm_up = static_cast<std::uint32_t>(matrix.number("warm_up", 0, kMaxStep, 32));
  run.steps = static_cast<std::uint32_t>(matrix.number("steps", 1, kMaxStep, 100));
  run.measures = read_measures(matrix);
  return run;
}

std::string names_of(const Measures& measures) {
  std::string names;
  const auto add = [&names](bool chosen, const char* name) {
    if (chosen) names += (names.empty() ? "" : " ") + std::string(name);
  };
  add(measures.times, "times");
  add(measures.counts, "counts");
  add(measures.errors, "errors");
  return names;
}

StudyCell make_cell(const Place& place, const RunCell& run, std::uint64_t repeat) {
  StudyCell cell;
  cell.settings = {{"kind", place.is_motion() ? "motion" : "scene"},
                   {"scene", place.name},
                   {"dimension", place.dimension},
                   {"objects", run.options.objects},
                   {"seed", run.options.seed},
                   {"broad_phase", run.broad_phase},
                   {"repeat", repeat},
                   {"warm_up", run.warm_up},
                   {"steps", run.steps},
                   {"grow", run.options.steps},
                   {"measure", names_of(run.measures)}};
  cell.id = cell_id(place.name + "-" + std::to_string(place.dimension) + "d." +
                        std::to_string(run.options.objects) + ".s" + std::to_string(run.options.seed) + "." +
                        run.broad_phase + ".r" + std::to_string(repeat),
                    cell.settings);
  cell.work = run;
  return cell;
}

}  // namespace

std::vector<StudyCell> read_runs(JsonObject& matrix) {
  auto places = read_places(matrix);
  give_broad_phases(matrix, places);
  const bool scenes = matrix.has("scenes");
  const auto objects =
      matrix.numbers("objects", scenes ? 1 : 20, scenes ? kMaxRequestedObjects : kMostMoving, {1000});
  const auto seeds = matrix.numbers("seeds", 0, UINT32_MAX, {1});
  const std::uint64_t repeats = matrix.number("repeats", 1, 10'000, 1);
  const auto grow = static_cast<std::uint32_t>(matrix.number("grow", 0, kMaxStep, 0));
  RunCell run = read_run(matrix);
  if (matrix.has("grow") && std::ranges::none_of(places, &Place::grows))
    matrix.refuse("grow", "none of the scenes grows; leave the key out");
  std::size_t runs = 0;  // of a repeat with one seed and one number of objects
  for (const Place& place : places) runs += place.broad_phases.size();
  refuse_too_many(matrix,
                  static_cast<double>(repeats) * static_cast<double>(runs * objects.size() * seeds.size()));
  std::vector<StudyCell> cells;
  for (std::uint64_t repeat = 1; repeat <= repeats; ++repeat)
    for (const Place& place : places)
      for (const std::uint64_t count : objects)
        for (const std::uint64_t seed : seeds)
          for (const std::string& broad_phase : place.broad_phases) {
            run.scene = place.scene;
            run.dimension = place.dimension;
            run.options.objects = static_cast<std::uint32_t>(count);
            run.options.seed = seed;
            run.options.steps = place.grows() ? grow : 0;
            run.broad_phase = broad_phase;
            cells.push_back(make_cell(place, run, repeat));
          }
  return cells;
}

}  // namespace kerf
