#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/base/ids.h"
#include "core/base/rgb.h"
#include "core/geometry/box.h"
#include "core/objects/broad_phase.h"
#include "core/scene/needs.h"
#include "core/scene/shape.h"

namespace kerf {

/// One object of a scene, as it stands after the last `advance()`.
template <int D>
struct Body {
  Shape<D> shape;
  Pose<D> pose;
  Box<D> box;  ///< the box that the broad phase holds for it
  Mobility mobility = Mobility::moving;
  std::optional<Rgb> color{};  ///< its own; none: as its mobility has it
};

/// The options that the user may vary for any scene.
struct SceneOptions {
  std::uint32_t objects = 0;  ///< moving objects at the end of the run; 0: the scene's own default
  std::uint32_t steps = 0;    ///< steps over which a growing scene reaches its number; 0: its own default
  std::uint32_t recycle = 0;  ///< once all have come, every so many steps the oldest falls again; 0: never
  std::uint64_t seed = 1;     ///< of every random choice
  std::uint32_t nudge = 0;    ///< ulps by which the first object is moved aside: a control for chaos
};

/// A simulated world in which the given broad phase, and no other, proposes the pairs.
/// Body k is object k of the broad phase.
template <int D>
class Scene {
 public:
  Scene() = default;
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  virtual ~Scene() = default;

  [[nodiscard]] virtual Needs needs() const = 0;
  /// One step of 1/25 s: add objects that are due, update boxes, ask the broad phase, run the narrow phase on
  /// its pairs, resolve contacts and integrate.
  virtual void advance() = 0;
  [[nodiscard]] virtual std::uint32_t step() const = 0;

  /// Bodies at the poses that the last broad phase and narrow phase saw, together with their boxes.
  [[nodiscard]] virtual std::span<const Body<D>> bodies() const = 0;
  /// Candidate pairs of the last step, sorted.
  [[nodiscard]] virtual std::span<const Pair> pairs() const = 0;
  /// Those of them that touch by the narrow phase, sorted.
  [[nodiscard]] virtual std::span<const Pair> contacts() const = 0;
};

/// How a scene is found and made: each room of scenes gives a list of these.
template <int D>
struct SceneEntry {
  std::string_view name;
  std::string_view summary;           ///< one line
  std::string_view source;            ///< the paper's simulation that it follows, or "ours"
  std::uint32_t default_objects = 0;  ///< moving objects
  Needs needs;
  std::unique_ptr<Scene<D>> (*make)(BroadPhase<D>& broad_phase, const SceneOptions& options) = nullptr;
  bool grows =
      true;  ///< objects come over `steps` and may `recycle`; false: all are there from the first step
  std::string_view parameters{};  ///< what the options mean here, where it is not obvious
};

}  // namespace kerf
