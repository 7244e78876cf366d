#pragma once

#include <optional>
#include <span>

#include "viz/draw/box_of_interest.h"

namespace kerf {

/// The view of a sequence of frames: everything seen so far, without following single objects. It only grows,
/// each time by more than needed, so that the picture stands still most of the time.
template <int D>
class ViewBox {
 public:
  explicit ViewBox(Framing framing = Framing::most) : framing_(framing) {}

  /// Takes a frame's bodies in, as far as they are of interest.
  void update(std::span<const Body<D>> bodies);
  /// From now on exactly this box. Throws std::invalid_argument unless it is valid and not empty.
  void fix(const Box<D>& box);
  /// A unit box before anything was seen.
  [[nodiscard]] Box<D> box() const;
  /// What the last frame needs of it; none if it has nothing of interest.
  [[nodiscard]] const std::optional<Box<D>>& needed() const { return needed_; }

 private:
  Framing framing_;
  std::optional<Box<D>> box_;
  std::optional<Box<D>> needed_;
  bool fixed_ = false;
};

/// The view of a sequence of which all frames are looked at before the first is drawn: everything seen, but
/// in 3D of what never moves only as much as lies around what does, so that a large floor leaves the picture
/// to the action.
template <int D>
class SceneBox {
 public:
  explicit SceneBox(Framing framing = Framing::most) : framing_(framing), all_(framing), action_(framing) {}

  void update(std::span<const Body<D>> bodies);
  [[nodiscard]] Box<D> box() const;

 private:
  Framing framing_;
  ViewBox<D> all_;
  ViewBox<D> action_;
  bool has_action_ = false;
};

}  // namespace kerf
