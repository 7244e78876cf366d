#include "frames/story/story_words.h"

namespace kerf {
namespace {

std::string sentence_of(const Highlight& highlight, std::uint32_t step, const GivenNames& names) {
  return "Step " + names.step(step) + ": " + highlight.sentence();
}

}  // namespace

template <int D>
void tell_operator(const FramePlan<D>& plan, std::uint32_t step, const GivenNames& names,
                   StoryInsert& insert) {
  if (insert.moment) {
    Highlight highlight;
    highlight.acted = insert.moment->acted;
    insert.acting = highlight.acted.node.node;
    insert.sentence = sentence_of(highlight, insert.moment->step, names);
  } else if (!plan.highlights.empty()) {
    const Highlight& newest = plan.highlights.front();
    if (plan.snapshot.is_alive(newest.acted.node)) insert.acting = newest.acted.node.node;
    insert.sentence = sentence_of(newest, step - newest.age, names);
  }
}

template void tell_operator<2>(const FramePlan<2>&, std::uint32_t, const GivenNames&, StoryInsert&);
template void tell_operator<3>(const FramePlan<3>&, std::uint32_t, const GivenNames&, StoryInsert&);

}  // namespace kerf
