#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/given_id.h"
#include "core/base/ids.h"
#include "core/geometry/box.h"
#include "core/recording/database.h"
#include "core/recording/their_digits.h"

namespace kerf {

/// Raised to this, if it is less, by a recording that holds another engine's structure; others stay as they
/// are.
inline constexpr std::uint32_t kStructureVersion = 8;

/// A node of another engine's tree of boxes, as it was given.
template <int D>
struct TheirNode {
  GivenId name;
  std::optional<GivenId> parent;  ///< none: it is a root
  Box<D> box;                     ///< rounded outward
  std::vector<ObjectId> objects;
  std::optional<bool> leaf;  ///< whether the engine calls it a leaf; none: it does not say
  Scalar margin = 0;         ///< that the engine claims to leave around its objects
  friend bool operator==(const TheirNode&, const TheirNode&) = default;
};

/// Its nodes after a step, in the order in which they were given. Nothing of them need be right.
template <int D>
struct TheirStructure {
  std::vector<TheirNode<D>> nodes;
  std::optional<TheirDigits> digits{};  ///< of the recording: how numbers were written; none: not known
  friend bool operator==(const TheirStructure&, const TheirStructure&) = default;
};

/// The nodes alone.
template <int D>
Bytes encode_structure(const TheirStructure<D>& structure);
/// The reverse. Throws std::runtime_error for damaged bytes, and for bounds that are no numbers.
template <int D>
TheirStructure<D> decode_structure(std::span<const std::uint8_t> bytes);

/// The table with a row for each step of which a structure is known.
extern const char* const kTheirStructureTable;
/// Whether a recording has that table.
bool has_structures(const Database& database);
/// Makes the table, too, for the first one.
template <int D>
void write_structure(Database& database, std::uint32_t step, const TheirStructure<D>& structure);
template <int D>
std::optional<TheirStructure<D>> read_structure(const Database& database, std::uint32_t step);
/// The steps that have one, rising.
std::vector<std::uint32_t> read_structure_steps(const Database& database);

}  // namespace kerf
