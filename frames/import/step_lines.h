#pragma once

#include <vector>

#include "frames/import/survey.h"

namespace kerf {

/// Hands out the lines of a table of boxes step by step. Throws UsageError if they are not those that the
/// survey has seen.
class StepLines {
 public:
  StepLines(BoxLines& boxes, const Survey& survey, bool unite, Oddities& oddities);

  /// The lines of a step, in their order; a step of which only pairs are known has none. Several boxes of an
  /// object, unless it is removed between them, are united or refused. Valid until the next call.
  const std::vector<BoxLine>& next(const GivenStep& step);
  /// After the last step: throws UsageError if there are lines that the survey did not see.
  void end() const;

 private:
  void add(const BoxLine& line, const GivenStep& step);
  void unite(BoxLine& first, const BoxLine& second, const GivenStep& step);
  void note_oddity(const BoxLine& line, const GivenStep& step);
  [[nodiscard]] std::string place(const BoxLine& line, const GivenStep& step) const;

  BoxLines& boxes_;
  const Survey& survey_;
  bool unites_;
  Oddities& oddities_;
  bool has_line_;
  std::vector<BoxLine> lines_;
  std::vector<std::size_t> last_box_;  ///< by object: one more than the index in lines_ of its box; else 0
};

}  // namespace kerf
