#include "core/query/common_numbers.h"

#include <algorithm>

namespace kerf {

CommonNumbers::CommonNumbers(const GivenNames& a, const GivenNames& b)
    : are_own_(std::ranges::equal(a.objects(), b.objects())), names_{&a, &b} {}

ObjectId CommonNumbers::operator()(Of of, ObjectId object) {
  if (are_own_) return object;
  std::vector<ObjectId>& known = known_[static_cast<std::size_t>(of)];
  if (object.index() >= known.size()) known.resize(object.index() + 1);
  ObjectId& common = known[object.index()];
  if (common.is_none()) {
    const GivenId name = names_[static_cast<std::size_t>(of)]->object_id(object);
    common = numbers_.emplace(name, ObjectId{static_cast<std::uint32_t>(numbers_.size())}).first->second;
  }
  return common;
}

std::vector<JudgedPair> CommonNumbers::renumbered(Of of, std::vector<JudgedPair> judged) {
  for (JudgedPair& one : judged) one.pair = renumbered(of, one.pair);
  return judged;
}

std::vector<Pair> CommonNumbers::renumbered(Of of, std::vector<Pair> pairs) {
  for (Pair& pair : pairs) pair = renumbered(of, pair);
  std::ranges::sort(pairs);
  return pairs;
}

std::map<ObjectId, ObjectMark> CommonNumbers::renumbered(Of of, const ObjectMarks& marks) {
  std::map<ObjectId, ObjectMark> common;
  for (const auto& [object, mark] : marks.all()) common.emplace((*this)(of, object), mark);
  return common;
}

EventBody CommonNumbers::renumbered(Of of, EventBody body) {
  const auto renumber = [&](auto& event) {
    if constexpr (requires { event.object.is_none(); }) event.object = (*this)(of, event.object);
  };
  std::visit(renumber, body);
  return body;
}

CommonSteps common_steps(const GivenNames& a, std::uint32_t a_steps, const GivenNames& b,
                         std::uint32_t b_steps) {
  CommonSteps steps;
  const bool have_names = a.names_steps() || b.names_steps();
  std::uint32_t in_a = 1;
  std::uint32_t in_b = 1;
  while (in_a <= a_steps && in_b <= b_steps) {
    const long double of_a = have_names ? a.step_number(in_a) : 0;
    const long double of_b = have_names ? b.step_number(in_b) : 0;
    if (of_a < of_b) {
      steps.only_a.push_back(a.step(in_a++));
    } else if (of_b < of_a) {
      steps.only_b.push_back(b.step(in_b++));
    } else {
      steps.both.push_back({in_a++, in_b++});
    }
  }
  if (!have_names) return steps;
  while (in_a <= a_steps) steps.only_a.push_back(a.step(in_a++));
  while (in_b <= b_steps) steps.only_b.push_back(b.step(in_b++));
  return steps;
}

}  // namespace kerf
