#pragma once

#include "core/related/cut_tree_policy.h"

namespace kerf {

/// A tree that is built from nothing in each step: the yardstick for all that keep one.
template <int D>
class RebuiltTree final : public CutTreePolicy<D> {
 public:
  [[nodiscard]] std::string_view name() const override { return "rebuilt-tree"; }

 private:
  void arrange() override {
    static_cast<void>(this->take_changes());
    this->rebuild();
  }
};

}  // namespace kerf
