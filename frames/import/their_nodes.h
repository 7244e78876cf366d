#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/objects/object_table.h"
#include "core/query/structure_check.h"
#include "core/recording/their_structure.h"
#include "frames/import/given_nodes.h"
#include "frames/import/survey.h"

namespace kerf {

/// Hands out another engine's structure step by step, and counts what is wrong with it.
template <int D>
class TheirNodes {
 public:
  TheirNodes(std::vector<GivenNodes> steps, const Survey& survey)
      : steps_(std::move(steps)), survey_(survey) {}

  /// That of a step, checked against the objects as they are then; none if no line is of that step. Steps
  /// rise from call to call.
  [[nodiscard]] std::optional<TheirStructure<D>> take(const GivenStep& step, const ObjectTable<D>& objects);
  /// What was found, a line or two.
  [[nodiscard]] std::string text() const;

 private:
  [[nodiscard]] TheirNode<D> node_of(const GivenNode& given) const;

  std::vector<GivenNodes> steps_;
  const Survey& survey_;
  std::size_t next_ = 0;
  std::uint64_t nodes_ = 0;
  std::uint64_t faults_ = 0;
  std::uint64_t wrong_steps_ = 0;
  std::string first_;
  std::optional<TheirStructure<D>> before_;  ///< the last one known
  bool is_known_ = false;                    ///< that of the step before is
  bool held_fixed_ = false;                  ///< one of them held a fixed object
};

}  // namespace kerf
