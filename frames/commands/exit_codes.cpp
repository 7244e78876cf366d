#include "frames/commands/exit_codes.h"

#include <algorithm>
#include <stdexcept>

namespace kerf {
namespace {

constexpr ExitMeaning kMeanings[] = {
    {"advise", "the broad phases were measured and the advice was printed", ""},
    {"bench", "everything asked for was measured, or is named as left out", ""},
    {"bench-frames", "everything asked for was measured", ""},
    {"collect", "every frame is there with the pixels that were drawn",
     "a frame is missing or has other pixels"},
    {"compare",
     "the recordings are of the same run, two that are unfinished as far as they go; times do not count",
     "the runs differ, or only one was ended in order"},
    {"completion", "the script was printed", ""},
    {"debug", "the window was closed, or all that the script expects holds", "an expectation does not hold"},
    {"diff", "all frames are the same, or were approved", "a frame or a manifest differs or has no partner"},
    {"doctor", "all that pictures and recordings need is there", "some of it is missing"},
    {"experiment", "the runs, figures and pages are there, whatever they show", ""},
    {"explain", "the explanation was printed", ""},
    {"export", "everything was written", ""},
    {"film", "the film is made", ""},
    {"film-diff", "the film is made of two sequences of equal steps, whether they differ or not",
     "the film is made, and a frame has no partner"},
    {"import", "the recording is complete, whatever the other engine's pairs are", ""},
    {"lint", "nothing was found", "something was found"},
    {"man", "the page was printed", ""},
    {"minimize", "a smaller recording shows the condition", "the condition never holds"},
    {"record", "the recording is complete", ""},
    {"render", "all frames and files are there", ""},
    {"report", "the page is there", ""},
    {"rerun", "the recording is complete", ""},
    {"scenes", "the scenes were listed", ""},
    {"step", "a moment was found", "there is no such moment"},
    {"study", "every cell asked for is there", "a cell is missing, or could not be measured"},
    {"verify", "the replay is the run that was recorded, and its pairs are exact where the oracle was asked",
     "it is not, or they are not"},
};

constexpr std::string_view kUnusable =
    "no answer: wrong usage, unusable input, or a file that cannot be written";
constexpr std::string_view kInterrupted = "interrupted";

const ExitMeaning& meaning_of(std::string_view command) {
  const auto* const found = std::ranges::find(kMeanings, command, &ExitMeaning::command);
  if (found == std::end(kMeanings)) throw std::logic_error(std::string(command) + " has no exit codes");
  return *found;
}

}  // namespace

std::span<const ExitMeaning> exit_meanings() { return kMeanings; }

std::string exit_help(std::string_view command) {
  const ExitMeaning& meaning = meaning_of(command);
  std::string text = "EXIT    0    " + std::string(meaning.holds);
  const auto add = [&text](const char* code, std::string_view words) {
    text += "\n        " + std::string(code) + std::string(words);
  };
  if (!meaning.does_not_hold.empty()) add("1    ", meaning.does_not_hold);
  add("2    ", kUnusable);
  add("130  ", kInterrupted);
  return text;
}

}  // namespace kerf
