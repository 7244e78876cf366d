#pragma once

namespace kerf {

/// One function made of several, for `std::visit`. With a function for each alternative and none that takes
/// everything, an alternative that is added to the variant and forgotten here does not compile.
template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

template <class Answer, class Alternative>
struct NothingForOne {
  Answer operator()(const Alternative& /*ignored*/) const { return Answer(); }
};

/// Part of an overload set: for each of these alternatives the answer is an empty one.
template <class Answer, class... Alternatives>
struct NothingFor : NothingForOne<Answer, Alternatives>... {
  using NothingForOne<Answer, Alternatives>::operator()...;
};

}  // namespace kerf
