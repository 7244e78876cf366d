#pragma once

#include <memory>
#include <string>
#include <vector>

#include "frames/sequence/film.h"
#include "frames/sequence/side_by_side.h"
#include "viz/draw/panes.h"

namespace kerf {

/// What films of panes share, wherever the boxes come from: the panes' frames.
template <int D>
class PanesFilm : public Film {
 public:
  void finish(bool /*whole*/) final {}

 protected:
  PanesFilm(const RenderRequest& request, std::vector<std::unique_ptr<BroadPhase<D>>> broad_phases);

  /// Describes and packs the broad phases at the present step. `frame` has all but its panes; its samples are
  /// the request's.
  std::vector<std::uint8_t> pack_with_panes(PanesFrame<D> frame);
  [[nodiscard]] SideBySide<D>& broad_phases() { return broad_phases_; }

 private:
  std::vector<std::string> names_;
  bool is_timed_;
  int samples_;  ///< 0: as bodies allow
  PictureSize size_;
  int columns_ = 0;  ///< chosen at the first frame, so that panes stay where they are
  bool has_strips_ = false;
  SideBySide<D> broad_phases_;
};

}  // namespace kerf
