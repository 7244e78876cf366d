#include "frames/import/their_nodes.h"

#include <algorithm>

#include "core/base/counted.h"
#include "core/geometry/given_box.h"
#include "core/query/their_parts.h"

namespace kerf {

template <int D>
TheirNode<D> TheirNodes<D>::node_of(const GivenNode& given) const {
  GivenBox<D> box;
  std::copy_n(given.min.begin(), D, box.min.begin());
  std::copy_n(given.max.begin(), D, box.max.begin());
  TheirNode<D> node{given.node, given.parent, round_outward(box),
                    {},         given.leaf,   static_cast<Scalar>(given.margin)};
  for (const GivenId& object : given.objects)
    if (survey_.is_object(object)) node.objects.push_back(survey_.object(object));
  return node;
}

template <int D>
std::optional<TheirStructure<D>> TheirNodes<D>::take(const GivenStep& step, const ObjectTable<D>& objects) {
  const bool is_next = is_known_;
  is_known_ = next_ < steps_.size() && steps_[next_].step.time == step.time;
  if (!is_known_) return std::nullopt;
  TheirStructure<D> structure;
  structure.digits = survey_.digits;
  for (const GivenNode& given : steps_[next_].nodes) structure.nodes.push_back(node_of(given));
  ++next_;
  nodes_ += structure.nodes.size();
  const TheirPast<D> past{before_ ? &*before_ : nullptr, is_next, held_fixed_};
  const auto faults = check_theirs<D>(structure, objects, survey_.names, past);
  faults_ += faults.size();
  wrong_steps_ += faults.empty() ? 0 : 1;
  if (!faults.empty() && first_.empty())
    first_ = "first in step " + step.text + ": " + std::string(to_string(faults.front().kind)) + ": " +
             faults.front().text + "\n";
  held_fixed_ = held_fixed_ || holds_fixed(structure, objects);
  before_ = structure;
  return structure;
}

template <int D>
std::string TheirNodes<D>::text() const {
  std::string text = "its structure has " + counted(nodes_, "node") + " in " + counted(steps_.size(), "step");
  if (steps_.empty()) return text + "\n";
  text += ": " + counted(faults_, "fault");
  if (faults_ > 0) text += " in " + counted(wrong_steps_, "step") + "; `kerf lint --structure` lists them";
  return text + "\n" + first_;
}

template class TheirNodes<2>;
template class TheirNodes<3>;

}  // namespace kerf
