#include "frames/bench/random/random_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/base/random.h"
#include "frames/page/json.h"
#include "frames/page/short_number.h"

namespace kerf {
namespace {

constexpr std::array<std::string_view, 3> kShapeNames{"boxes", "plates", "rods"};
constexpr std::array<std::string_view, 8> kScatteringNames{
    "uniform", "clusters", "line", "sheet", "ring", "slanted-line", "slanted-sheet", "turned-grid"};
constexpr std::array<std::string_view, 9> kTravelNames{"rest",     "brownian",  "streams",
                                                       "rotation", "explosion", "collapse",
                                                       "periodic", "teleports", "translation"};

std::string name_of(BoxShapes shapes) { return std::string(kShapeNames[static_cast<std::size_t>(shapes)]); }
std::string name_of(Scattering layout) {
  return std::string(kScatteringNames[static_cast<std::size_t>(layout)]);
}
std::string name_of(Travel travel) { return std::string(kTravelNames[static_cast<std::size_t>(travel)]); }

double log_uniform(Random& random, double low, double high) {
  return std::exp(random.uniform(std::log(low), std::log(high)));
}

bool one_in(Random& random, std::uint32_t count) { return random.below(count) == 0; }

void draw_boxes(Random& random, RandomScene& scene) {
  if (!one_in(random, 2)) scene.shapes = one_in(random, 2) ? BoxShapes::plates : BoxShapes::rods;
  if (scene.shapes != BoxShapes::boxes) scene.aspect = log_uniform(random, 4, 60);
  if (!one_in(random, 2)) scene.decades = random.uniform(0, 4);
  const double most = (scene.objects - 1) / 4.0;  // half of all pairs
  scene.density = std::min(log_uniform(random, 0.1, 30), most);
  scene.layout = static_cast<Scattering>(random.below(kScatteringNames.size()));
}

void draw_motion(Random& random, RandomScene& scene) {
  scene.travel = static_cast<Travel>(random.below(kTravelNames.size()));
  if (one_in(random, 4)) {
    scene.other = static_cast<Travel>(random.below(kTravelNames.size()));
    scene.phase = 5 + random.below(46);
  }
  scene.speed = log_uniform(random, 0.001, 2);
  if (!one_in(random, 2)) scene.awake = log_uniform(random, 0.001, 1);
  if (one_in(random, 4)) scene.churn = log_uniform(random, 0.0001, 0.1);
}

}  // namespace

RandomScene draw_scene(std::uint64_t seed, std::uint32_t number, std::uint32_t most) {
  constexpr std::uint32_t kLeast = 16;
  constexpr std::uint32_t kMost = 256000;
  constexpr std::uint64_t kApart = 0xD1B54A32D192ED03U;  // no multiple of the generator's own step
  RandomScene scene;
  scene.number = number;
  scene.seed = Random(Random(seed).bits() ^ (number * kApart)).bits();
  Random random(scene.seed);
  scene.dimension = one_in(random, 2) ? 2 : 3;
  const std::uint32_t end = std::clamp(most, kLeast, kMost);
  scene.objects = std::min(static_cast<std::uint32_t>(log_uniform(random, kLeast, end + 1)), end);
  draw_boxes(random, scene);
  draw_motion(random, scene);
  return scene;
}

std::string as_text(const RandomScene& scene) {
  std::string text = name_of(scene.shapes);
  if (scene.aspect > 1) text += " 1:" + short_number(scene.aspect);
  if (scene.decades > 0) text += ", sizes over " + short_number(scene.decades) + " decades";
  text += ", " + name_of(scene.layout) + ", " + name_of(scene.travel);
  if (scene.other) text += " and " + name_of(*scene.other) + " in turns of " + std::to_string(scene.phase);
  text += ", " + short_number(scene.speed) + " sizes a step";
  if (scene.awake < 1) text += ", " + short_number(100 * scene.awake) + " % awake";
  if (scene.churn > 0) text += ", " + short_number(100 * scene.churn) + " % go and come";
  return text;
}

nlohmann::ordered_json as_json(const RandomScene& scene) {
  return {{"number", scene.number},
          {"dim", scene.dimension},
          {"objects", scene.objects},
          {"shapes", name_of(scene.shapes)},
          {"aspect", scene.aspect},
          {"decades", scene.decades},
          {"density", scene.density},
          {"layout", name_of(scene.layout)},
          {"travel", name_of(scene.travel)},
          {"other", scene.other ? name_of(*scene.other) : ""},
          {"phase", scene.phase},
          {"speed", scene.speed},
          {"awake", scene.awake},
          {"churn", scene.churn}};
}

}  // namespace kerf
