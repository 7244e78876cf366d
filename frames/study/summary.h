#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "frames/study/estimate.h"
#include "frames/study/join.h"

namespace kerf {

/// The cells of a broad phase that differ in seed and repeat alone, measured by machines of one kind.
class Group {
 public:
  std::string broad_phase;
  std::string machine;
  std::uint64_t objects = 0;

  void add(const CellFile& file);
  [[nodiscard]] std::size_t cells() const { return cells_; }
  /// Of a figure by its name in the cell's counts or times; none if a cell does not have it. What is counted
  /// in all measured steps is divided by them.
  [[nodiscard]] std::optional<Estimate> estimate(const std::string& figure) const;

 private:
  std::map<std::string, std::map<std::uint64_t, std::vector<double>>> values_;  ///< by figure and seed
  std::size_t cells_ = 0;
};

/// What can be compared: a motion or scene in a dimension, with the same steps and
/// measures.
struct StudyComparison {
  std::string title;
  std::string measures;
  std::vector<Group> groups;  ///< in the order of the study
};

/// The comparisons of all cells that are no frames, in the order of the study.
std::vector<StudyComparison> comparisons(const JoinedStudy& joined);

}  // namespace kerf
