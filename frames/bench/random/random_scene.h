#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace kerf {

/// What the boxes of a random scene look like; the long or thin axis is another one for each.
enum class BoxShapes : std::uint8_t { boxes, plates, rods };

/// Where they are. A slanted one lies along no axis; in 2D sheets are lines.
enum class Scattering : std::uint8_t {
  uniform,
  clusters,
  line,
  sheet,
  ring,
  slanted_line,
  slanted_sheet,
  turned_grid
};

/// How the awake objects move.
enum class Travel : std::uint8_t {
  rest,
  brownian,
  streams,     ///< four directions, and at the end of the world anew from its beginning
  rotation,    ///< about the middle
  explosion,   ///< away from the middle, each up to twice as far, then back at once
  collapse,    ///< towards the middle, each up to 0.7 times as far, then back at once
  periodic,    ///< to and fro, each in its own direction
  teleports,   ///< each step beside another object's first place
  translation  ///< all by one vector, for ever
};

/// A member of the family of `kerf bench --random`: everything that its motion depends on.
struct RandomScene {
  std::uint32_t number = 1;             ///< among the scenes of the seed, from 1 on
  std::uint64_t seed = 1;               ///< of its own choices
  int dimension = 3;                    ///< 2 or 3, evenly
  std::uint32_t objects = 16;           ///< present, log-uniform from 16 to 256,000
  BoxShapes shapes = BoxShapes::boxes;  ///< half are boxes
  /// By which the short extents of plates and rods are divided, log-uniform from 4 to 60. Each extent was
  /// drawn from 0.5 to 1.5 before, so that long over short is a third to three times that.
  double aspect = 1;
  double decades = 0;  ///< sizes are log-uniform over them; half have none, and extents from 0.5 to 1.5
  double density =
      1;  ///< pairs an object at the beginning, log-uniform from 0.1 to 30, half of all pairs at most
  Scattering layout = Scattering::uniform;
  Travel travel = Travel::rest;
  std::optional<Travel> other;  ///< in turns with `travel`, in a quarter of the scenes
  std::uint32_t phase = 0;      ///< steps of a turn, 5 to 50
  double speed = 0;             ///< way of a step in sizes, log-uniform from 0.001 to 2
  double awake = 1;             ///< share that moves: all in half of the scenes, or log-uniform from 0.001 on
  double churn =
      0;  ///< share that goes in a step while as many come; in a quarter, log-uniform 0.0001 to 0.1
};

/// The scene of a seed that has this number, whatever the others are. `most` objects at most, at least 16.
RandomScene draw_scene(std::uint64_t seed, std::uint32_t number, std::uint32_t most);

/// "rods 1:12, sizes over 2.1 decades, slanted-sheet, brownian by 0.4 sizes, 3 % awake"
std::string as_text(const RandomScene& scene);
nlohmann::ordered_json as_json(const RandomScene& scene);

}  // namespace kerf
