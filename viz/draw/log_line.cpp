
#include "core/base/counted.h"
#include "viz/draw/flow.h"
#include "viz/draw/letters.h"
#include "viz/draw/overlay.h"

namespace kerf {
namespace {

/// What an operator of an earlier step made may have changed since, so that step is named.
std::string dated_sentence(const Highlight& highlight) {
  const std::string when = highlight.age == 0 ? "" : counted(highlight.age, "step") + " ago ";
  return when + highlight.sentence();
}

/// What the first `shown` operators did, and the number of the others.
std::string sentences(const std::vector<Highlight>& highlights, std::size_t shown) {
  std::string text = dated_sentence(highlights.front());
  for (std::size_t k = 1; k < shown; ++k) text += "; " + dated_sentence(highlights[k]);
  const std::size_t more = highlights.size() - shown;
  return more == 0 ? text : text + "; and " + std::to_string(more) + " more";
}

/// The names of the first `shown` operators, and the number of the others.
std::string acted_text(const std::vector<Highlight>& highlights, std::size_t shown) {
  std::string text;
  for (std::size_t k = 0; k < shown; ++k) text += (k == 0 ? "acted: " : ", ") + highlights[k].label();
  const std::size_t more = highlights.size() - shown;
  if (more == 0) return text;
  return shown == 0 ? "acted: " + counted(more, "operator") : text + " and " + std::to_string(more) + " more";
}

}  // namespace

std::string log_line(const Font& font, int picture_width, const std::string& note,
                     const std::vector<Highlight>& highlights) {
  const int width = picture_width - 2 * flow::padding(font);
  for (std::size_t shown = note.empty() ? highlights.size() : 0; shown > 0; --shown)
    if (std::string text = sentences(highlights, shown); font.width(text) <= width) return text;
  const std::string begin = note.empty() || highlights.empty() ? note : note + "   ";
  for (std::size_t shown = highlights.size(); shown > 0; --shown)
    if (std::string text = begin + acted_text(highlights, shown); font.width(text) <= width) return text;
  return shortened(highlights.empty() ? begin : begin + acted_text(highlights, 0), font.letters(width));
}

}  // namespace kerf
