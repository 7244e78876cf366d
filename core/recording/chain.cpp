#include "core/recording/chain.h"

#include <xxhash.h>

#include <bit>
#include <memory>
#include <new>
#include <vector>

#include "core/recording/their_structure.h"

namespace kerf {
namespace {

/// The head: everything written before the first step, without the mark of completeness, which comes last.
constexpr std::array kHead{"SELECT * FROM meta WHERE key NOT IN ('complete', 'end') ORDER BY key",
                           "SELECT * FROM config_changes ORDER BY step",
                           "SELECT * FROM decisions ORDER BY event",
                           "SELECT * FROM object_names ORDER BY object",
                           "SELECT * FROM object_marks ORDER BY object",
                           "SELECT * FROM step_names ORDER BY step",
                           "SELECT * FROM their_ignored ORDER BY a, b"};
/// What is written of another engine after a step.
constexpr std::array kTheirs{"SELECT * FROM their_steps WHERE step = ?",
                             "SELECT * FROM their_pairs WHERE step = ? ORDER BY rowid",
                             "SELECT * FROM their_verdicts WHERE step = ? ORDER BY rowid",
                             "SELECT * FROM their_boxes WHERE step = ? ORDER BY object",
                             "SELECT * FROM their_filters WHERE step = ? ORDER BY object"};

/// Of a step that has a structure: what came before the first one was written without this table.
constexpr const char* kTheirStructure = "SELECT * FROM their_structures WHERE step = ?";

/// SQLite keeps no sign of a zero.
std::uint64_t stored_bits(double x) { return std::bit_cast<std::uint64_t>(x + 0.0); }

/// The hash of rows as if they stood in memory one after the other, of which there can be many millions.
class RowHash {
 public:
  explicit RowHash(std::uint64_t seed) : state_(XXH3_createState()) {
    if (state_ == nullptr) throw std::bad_alloc();
    XXH3_64bits_reset_withSeed(state_.get(), seed);
  }

  void add(Statement& rows) {
    for (; rows.step(); ++rows_) {
      row_.clear();
      rows.put_row(row_);
      XXH3_64bits_update(state_.get(), row_.bytes().data(), row_.bytes().size());
    }
  }
  void end_table() { XXH3_64bits_update(state_.get(), "", 1); }
  [[nodiscard]] std::uint64_t rows() const { return rows_; }
  [[nodiscard]] std::uint64_t value() const { return XXH3_64bits_digest(state_.get()); }

 private:
  struct Free {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
  };
  std::unique_ptr<XXH3_state_t, Free> state_;
  ByteWriter row_;
  std::uint64_t rows_ = 0;
};

}  // namespace

std::uint64_t hash_words(std::span<const std::uint64_t> words, std::uint64_t seed) {
  return XXH3_64bits_withSeed(words.data(), words.size_bytes(), seed);
}

std::uint64_t hash_bytes(std::span<const std::uint8_t> bytes, std::uint64_t seed) {
  return XXH3_64bits_withSeed(bytes.data(), bytes.size(), seed);
}

std::uint64_t Chain::add(const StepRow& row) {
  const Statistics& s = row.statistics;
  std::vector<std::uint64_t> words{row.step,   s.objects,          row.changed,    row.pairs,
                                   s.height,   s.leaves,           s.entries,      stored_bits(s.redundancy),
                                   s.refused,  s.deferred,         s.placed,       row.first_event,
                                   row.events, row.operators_hash, row.state_hash, row.pairs_hash};
  words.insert(words.end(), s.operators.begin(), s.operators.end());
  for (const double seconds : s.phase_seconds) words.push_back(stored_bits(seconds));
  link_ = hash_words(words, end());
  seals_ = {};
  return link_;
}

std::uint64_t seal_of_block(std::uint64_t link, std::uint32_t first_step, std::uint32_t steps,
                            std::uint64_t changed, std::span<const std::uint8_t> data) {
  return hash_bytes(data, hash_words(std::array<std::uint64_t, 3>{first_step, steps, changed}, link));
}

std::uint64_t seal_of_keyframe(std::uint64_t link, std::uint32_t step, std::span<const std::uint8_t> data,
                               std::span<const std::uint8_t> looks) {
  return hash_bytes(looks, hash_bytes(data, hash_words(std::array<std::uint64_t, 1>{step}, link)));
}

std::uint64_t seal_of_shape(std::uint64_t link, std::uint32_t number, std::string_view kind,
                            std::span<const std::uint8_t> data) {
  ByteWriter content;
  content.varint(number);
  content.text(kind);
  content.blob(data);
  return hash_bytes(content.bytes(), link);
}

std::uint64_t seal_of_shapes(std::span<const std::uint64_t> seals) { return hash_words(seals, 0); }

std::optional<std::uint64_t> seal_of_theirs(std::uint64_t link, const Database& recording,
                                            std::uint32_t step) {
  RowHash hash(link);
  for (const char* const sql : kTheirs) {
    hash.add(recording.prepare(sql).bind(1, std::int64_t{step}));
    hash.end_table();
  }
  if (has_structures(recording)) hash.add(recording.prepare(kTheirStructure).bind(1, std::int64_t{step}));
  return hash.rows() == 0 ? std::nullopt : std::optional(hash.value());
}

std::uint64_t head_of(const Database& recording) {
  RowHash hash(0);
  for (const char* const sql : kHead) {
    Statement rows = recording.prepare(sql);
    hash.add(rows);
    hash.end_table();
  }
  return hash.value();
}

}  // namespace kerf
