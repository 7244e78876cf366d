#pragma once

#include <cstdint>
#include <vector>

#include "core/base/append_buffer.h"
#include "core/bsp/fat_piece.h"
#include "core/bsp/kept_pairs.h"
#include "core/bsp/restless_pass.h"
#include "core/bsp/shift_pass.h"
#include "core/bsp/step_context.h"
#include "core/objects/skin.h"
#include "core/trace/reporter.h"

namespace kerf {

/// The step for objects of which most stay where they are or move little: the tree places fat boxes, and the
/// pairs of fat boxes are kept from step to step and filtered (DESIGN.md, "Speed"). Its memory is kept
/// between steps.
template <int D>
class KeptStep {
 public:
  /// Brings the entries up to date with the requests. `begins`: all objects get fat boxes, whether the tree's
  /// table has fat or tight ones. Returns how many objects were listed or placed.
  template <class Trace>
  std::uint64_t place(const StepContext<D>& step, bool begins, Reporter<Trace>& reporter);
  /// What the step costs with kept pairs, over what it would cost if all leaves were swept: an estimate by
  /// what was counted when its objects were placed; 0 in the first step with kept pairs.
  [[nodiscard]] float cost() const { return cost_; }
  /// Makes all pairs of the latest boxes out of those of the last step.
  void find(const StepContext<D>& step, PairBuffer& pairs);
  /// Forgets the pairs: the next step finds all of them anew.
  void forget_pairs() { kept_.clear(); }
  /// By object.
  [[nodiscard]] const std::vector<Skin>& skins() const { return skins_; }
  /// Goes on with these skins, for `objects` objects at least.
  void restore(const std::vector<Skin>& skins, std::size_t objects);

 private:
  [[nodiscard]] Box<D> make_fat_box(const StepContext<D>& step, ObjectId object, const Box<D>& before,
                                    bool had_fat);
  void fatten_all(const StepContext<D>& step);
  void list_sleepers(const StepContext<D>& step);
  void follow_restless(const StepContext<D>& step);
  void fatten_changed(const StepContext<D>& step);
  void take_fat_boxes(const StepContext<D>& step) const;
  template <class Trace>
  std::uint64_t place_all(const StepContext<D>& step, bool many_stay, Reporter<Trace>& reporter) const;
  template <class Trace>
  std::uint64_t place_changed(const StepContext<D>& step, Reporter<Trace>& reporter);
  void list_changes(const StepContext<D>& step, std::size_t k, FatPiece& piece) const;
  void list_entry_changes(const StepContext<D>& step, ObjectId object, FatPiece& piece) const;
  template <class Trace>
  void take_out(const StepContext<D>& step, Reporter<Trace>& reporter);
  template <class Trace>
  static void put_in(Tree<D>& tree, const FatPiece& piece, Reporter<Trace>& reporter);

  std::vector<Skin> skins_;        ///< by object
  std::vector<PackedBox<D>> fat_;  ///< of the changed objects, in their order
  std::vector<FatPiece> pieces_;
  ShiftPass<D> shift_pass_;
  RestlessPass<D> restless_pass_;
  KeptPairs<D> kept_;
  float cost_ = 0;
};

}  // namespace kerf
