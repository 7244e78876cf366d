#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace kerf::adapters {

inline constexpr int kObjects = 4250;
inline constexpr int kRays = 100;
inline constexpr double kSeconds = 1.0 / 60;

/// Where the balls of a scene are at first. All have a radius of half a unit.
struct Start {
  std::vector<std::vector<double>> positions;   ///< coordinates of each
  std::vector<std::vector<double>> velocities;  ///< units a second
  std::vector<std::vector<double>> rays;        ///< start and end of each, one behind the other
  double side = 0;                              ///< of the box around them: from 0 to `side` on each axis
  double gravity = 0;                           ///< downwards, along the second axis
};

/// `heap`: layers of balls fall on each other and come to rest. `gas`: balls fly through a room, each in a
/// direction of its own.
Start make_start(const std::string& scene, int dimension);

/// A query for each ray, by the engine's own broad phase and by ours.
struct Asked {
  std::string what;
  std::function<void(const Start&)> own;
  std::function<void(const Start&)> ours;
};

/// The same scene in an engine with its own broad phase and with ours.
struct Contest {
  std::string engine;
  std::string own;  ///< the engine's broad phase
  std::function<void()> step_own;
  std::function<void()> step_ours;
  std::vector<Asked> asked;
};

Contest bullet_contest(const Start& start);
Contest ode_contest(const Start& start, bool sweep_and_prune);
Contest fcl_contest(const Start& start);
Contest box2d_contest(const Start& start);

}  // namespace kerf::adapters
