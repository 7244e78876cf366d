#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "core/recording/recording_reader.h"

namespace kerf {

/// One numbering of the objects of two recordings, by what they are called. A recording numbers its objects
/// as their names rise, so one that only one of two recordings names gives all later ones other numbers.
class CommonNumbers {
 public:
  enum class Of : std::uint8_t { a, b };

  CommonNumbers(const GivenNames& a, const GivenNames& b);

  /// The own numbers of the two are the common ones: all objects are called the same in both.
  [[nodiscard]] bool are_own() const { return are_own_; }
  ObjectId operator()(Of of, ObjectId object);

  template <int D>
  StepRequests<D> renumbered(Of of, StepRequests<D> requests) {
    for (ObjectId& object : requests.objects) object = (*this)(of, object);
    return requests;
  }
  template <int D>
  TheirChanges<D> renumbered(Of of, TheirChanges<D> changes) {
    for (auto& change : changes.boxes) change.object = (*this)(of, change.object);
    for (auto& change : changes.filters) change.object = (*this)(of, change.object);
    return changes;
  }
  template <int D>
  std::optional<TheirStructure<D>> renumbered(Of of, std::optional<TheirStructure<D>> structure) {
    if (!structure) return structure;
    for (TheirNode<D>& node : structure->nodes)
      for (ObjectId& object : node.objects) object = (*this)(of, object);
    return structure;
  }
  template <int D>
  std::vector<LookChange<D>> renumbered(Of of, std::vector<LookChange<D>> looks) {
    for (LookChange<D>& change : looks) change.object = (*this)(of, change.object);
    return looks;
  }
  std::vector<JudgedPair> renumbered(Of of, std::vector<JudgedPair> judged);
  /// In the order of the common numbers.
  std::vector<Pair> renumbered(Of of, std::vector<Pair> pairs);
  std::map<ObjectId, ObjectMark> renumbered(Of of, const ObjectMarks& marks);
  EventBody renumbered(Of of, EventBody body);

 private:
  Pair renumbered(Of of, const Pair& pair) { return make_pair((*this)(of, pair.a), (*this)(of, pair.b)); }

  bool are_own_;
  std::array<const GivenNames*, 2> names_;
  std::array<std::vector<ObjectId>, 2> known_;  ///< by own number; none: not asked yet
  std::map<GivenId, ObjectId> numbers_;
};

/// The steps that two recordings both have, by what they are called, and those that one of them has.
struct CommonSteps {
  struct Step {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
  };
  std::vector<Step> both;
  std::vector<std::string> only_a;  ///< by their names; none where neither recording names its steps
  std::vector<std::string> only_b;
};
CommonSteps common_steps(const GivenNames& a, std::uint32_t a_steps, const GivenNames& b,
                         std::uint32_t b_steps);

}  // namespace kerf
