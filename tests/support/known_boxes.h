#pragma once

#include <vector>

#include "core/objects/broad_phase.h"
#include "core/objects/object_table.h"
#include "core/query/structure_check.h"

namespace kerf::test {

/// Passes all requests on and knows which objects are placed, and their boxes.
template <int D>
class KnownBoxes final : public BroadPhase<D> {
 public:
  explicit KnownBoxes(BroadPhase<D>& inner) : inner_(inner) {}
  [[nodiscard]] std::string_view name() const override { return inner_.name(); }
  Status insert(ObjectId object, const Box<D>& box, Mobility mobility) override {
    static_cast<void>(table_.insert(object, box, mobility));
    return inner_.insert(object, box, mobility);
  }
  Status move(ObjectId object, const Box<D>& box) override {
    static_cast<void>(table_.move(object, box));
    return inner_.move(object, box);
  }
  Status remove(ObjectId object) override {
    static_cast<void>(table_.remove(object));
    return inner_.remove(object);
  }
  void step() override { inner_.step(); }
  [[nodiscard]] std::span<const Pair> pairs() const override { return inner_.pairs(); }

  [[nodiscard]] std::vector<KnownObject<D>> objects() const {
    std::vector<KnownObject<D>> known;
    for_each_placed(table_, [&](ObjectId object) { known.push_back({object, table_.box(object)}); });
    return known;
  }

 private:
  BroadPhase<D>& inner_;
  ObjectTable<D> table_;
};

}  // namespace kerf::test
