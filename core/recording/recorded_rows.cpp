#include "core/recording/recorded_rows.h"

#include "core/base/damage.h"
#include "core/recording/chain.h"
#include "core/recording/schema.h"
#include "core/recording/their_structure.h"

namespace kerf {
namespace {

std::uint64_t hash_at(const Statement& row, int column) {
  return static_cast<std::uint64_t>(row.integer(column));
}

StepRow read_step(const Statement& row) {
  int column = 0;
  StepRow result;
  Statistics& s = result.statistics;
  result.step = row.small(column++);
  s.objects = row.small(column++);
  result.changed = row.natural(column++);
  result.pairs = row.natural(column++);
  s.height = row.small(column++);
  s.leaves = row.small(column++);
  s.entries = row.natural(column++);
  s.redundancy = row.real(column++);
  for (std::uint64_t& acted : s.operators) acted = row.natural(column++);
  s.refused = row.natural(column++);
  s.deferred = row.small(column++);
  s.placed = row.natural(column++);
  result.first_event = row.natural(column++);
  result.events = row.natural(column++);
  result.operators_hash = hash_at(row, column++);
  for (double& seconds : s.phase_seconds) seconds = row.real(column++);
  result.state_hash = hash_at(row, column++);
  result.pairs_hash = hash_at(row, column++);
  result.link = hash_at(row, column++);
  return result;
}

std::vector<StepRow> read_steps(const Database& recording, const GivenNames& names) {
  std::vector<StepRow> steps;
  std::uint64_t next_event = 0;
  Statement rows = recording.prepare("SELECT * FROM steps ORDER BY step");
  while (rows.step()) {
    steps.push_back(read_step(rows));
    if (steps.back().step != steps.size())
      fail_damaged("step " + names.step(static_cast<std::uint32_t>(steps.size())) + " is missing");
    if (steps.back().first_event != next_event || steps.back().events > INT64_MAX - next_event)
      fail_damaged("the events of step " + names.step(steps.back().step) + " do not follow those before");
    next_event += steps.back().events;
  }
  return steps;
}

std::vector<BlockRow> read_blocks(const Database& recording, const std::vector<StepRow>& steps,
                                  const GivenNames& names) {
  std::vector<BlockRow> blocks;
  std::uint64_t next = 1;
  Statement rows =
      recording.prepare("SELECT first_step, steps, changed, seal FROM blocks ORDER BY first_step");
  while (rows.step()) {
    const BlockRow block{rows.small(0), rows.small(1), rows.natural(2), hash_at(rows, 3)};
    if (block.first_step > next) break;
    if (block.first_step < next || block.steps == 0 || block.steps > steps.size() + 1 - next)
      fail_damaged("the block of step " + names.step(block.first_step) + " has other steps than there are");
    std::uint64_t changed = 0;
    for (std::uint32_t k = 0; k < block.steps; ++k) changed += steps[next - 1 + k].changed;
    if (changed != block.changed)
      fail_damaged("the block of step " + names.step(block.first_step) + " has other changes than its steps");
    next += block.steps;
    blocks.push_back(block);
  }
  if (next <= steps.size())
    fail_damaged("the block of step " + names.step(static_cast<std::uint32_t>(next)) + " is missing");
  return blocks;
}

std::vector<KeyframeRow> read_keyframes(const Database& recording, const std::vector<BlockRow>& blocks,
                                        const GivenNames& names) {
  std::vector<KeyframeRow> keyframes;
  auto block = blocks.begin();
  Statement rows = recording.prepare("SELECT step, seal FROM keyframes ORDER BY step");
  while (rows.step()) {
    keyframes.push_back({rows.small(0), hash_at(rows, 1)});
    const std::uint32_t step = keyframes.back().step;
    while (block != blocks.end() && block->last_step() < step) ++block;
    if (block == blocks.end() || block->last_step() != step)
      fail_damaged("there is a keyframe of step " + names.step(step) + ", where no block ends");
    ++block;
  }
  return keyframes;
}

std::vector<TheirRow> read_theirs(const Database& recording, std::size_t steps, const GivenNames& names) {
  std::vector<TheirRow> theirs;
  std::uint32_t last = 0;
  Statement rows = recording.prepare("SELECT step, seal FROM their_seals ORDER BY step");
  while (rows.step()) {
    theirs.push_back({rows.small(0), hash_at(rows, 1)});
    const std::uint32_t step = theirs.back().step;
    if (step <= last || step > steps)
      fail_damaged("there is no step " + names.step(step) + " of another engine");
    last = step;
  }
  return theirs;
}

std::vector<ShapeRow> read_shape_rows(const Database& recording, std::size_t steps, const GivenNames& names) {
  std::vector<ShapeRow> shapes;
  std::uint32_t last = 1;
  Statement rows = recording.prepare("SELECT shape, step, seal FROM shapes ORDER BY shape");
  while (rows.step()) {
    if (rows.small(0) != shapes.size())
      fail_damaged("shape " + std::to_string(shapes.size()) + " is missing");
    shapes.push_back({rows.small(1), hash_at(rows, 2)});
    const std::uint32_t step = shapes.back().step;
    if (step < last || step > steps)
      fail_damaged("shape " + std::to_string(shapes.size() - 1) + " is of step " + names.step(step));
    last = step;
  }
  return shapes;
}

/// The seal of the shapes of a step, the first of which is `next`; none if it has none.
std::optional<std::uint64_t> seal_of_step(std::uint32_t step, std::vector<ShapeRow>::const_iterator& next,
                                          std::vector<ShapeRow>::const_iterator end) {
  std::vector<std::uint64_t> seals;
  for (; next != end && next->step == step; ++next) seals.push_back(next->seal);
  return seals.empty() ? std::nullopt : std::optional(seal_of_shapes(seals));
}

}  // namespace

RecordedRows read_rows(const Database& recording, const GivenNames& names) {
  RecordedRows rows;
  rows.steps = read_steps(recording, names);
  rows.blocks = read_blocks(recording, rows.steps, names);
  rows.keyframes = read_keyframes(recording, rows.blocks, names);
  rows.theirs = read_theirs(recording, rows.steps.size(), names);
  rows.shapes = read_shape_rows(recording, rows.steps.size(), names);
  return rows;
}

FollowedChain follow_chain(const Database& recording, const RecordedRows& rows, const GivenNames& names) {
  Chain chain(head_of(recording));
  auto block = rows.blocks.begin();
  auto keyframe = rows.keyframes.begin();
  auto theirs = rows.theirs.begin();
  auto shape = rows.shapes.begin();
  for (const StepRow& row : rows.steps) {
    if (chain.add(row) != row.link)
      return {ChangedPart{row.step,
                          row.step == 1
                              ? "the row of step " + names.step(1) + ", or what the recording says of itself"
                              : "the row of step " + names.step(row.step) +
                                    ", or what was written after step " + names.step(row.step - 1)},
              chain.end()};
    if (block != rows.blocks.end() && block->last_step() == row.step)
      chain.add(Chain::Part::block, block++->seal);
    if (keyframe != rows.keyframes.end() && keyframe->step == row.step)
      chain.add(Chain::Part::keyframe, keyframe++->seal);
    if (theirs != rows.theirs.end() && theirs->step == row.step)
      chain.add(Chain::Part::theirs, theirs++->seal);
    if (const auto seal = seal_of_step(row.step, shape, rows.shapes.end()))
      chain.add(Chain::Part::shapes, *seal);
  }
  const auto last = static_cast<std::uint32_t>(rows.steps.size());
  const auto end = read_end(recording);
  if (end && *end != chain.end())
    return {ChangedPart{last, "what was written after step " + names.step(last) + ", the last one"},
            chain.end()};
  return {std::nullopt, chain.end()};
}

std::optional<ChangedPart> find_added(const Database& recording, const RecordedRows& rows) {
  const auto last = static_cast<std::uint32_t>(rows.steps.size());
  std::vector<std::string> tables{"events",         "blocks",      "their_steps",  "their_pairs",
                                  "their_verdicts", "their_boxes", "their_filters"};
  if (has_structures(recording)) tables.emplace_back("their_structures");
  for (const std::string& table : tables) {
    const std::string step = table == "blocks" ? "first_step" : "step";
    Statement added = recording.prepare("SELECT EXISTS(SELECT 1 FROM " + table + " WHERE NOT coalesce(" +
                                        step + " BETWEEN 1 AND ?, 0))");
    if (added.bind(1, std::int64_t{last}).step() && added.integer(0) != 0)
      return ChangedPart{last, "the table " + table + " has a row of no step of the recording"};
  }
  return std::nullopt;
}

}  // namespace kerf
