#include "core/recording/their_structure.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/damage.h"
#include "core/recording/compression.h"

namespace kerf {
namespace {

constexpr std::uint8_t kUnsaid = 2;  // of a leaf

void put(const GivenId& id, ByteWriter& out) {
  out.u8(id.negative ? 1 : 0);
  out.varint(id.magnitude);
}

GivenId read_id(ByteReader& in) {
  const bool negative = in.choice(2) == 1;
  return {negative, in.varint()};
}

Scalar read_bound(ByteReader& in) {
  const Scalar bound = in.f32();
  if (std::isnan(bound)) fail_damaged("a node of the other engine has a bound that is no number");
  return bound;
}

template <int D>
TheirNode<D> read_node(ByteReader& in) {
  TheirNode<D> node;
  node.name = read_id(in);
  if (in.choice(2) == 1) node.parent = read_id(in);
  for (int axis = 0; axis < D; ++axis) {
    node.box.min[axis] = read_bound(in);
    node.box.max[axis] = read_bound(in);
  }
  for (std::size_t left = in.count(); left > 0; --left) node.objects.push_back({in.number()});
  const std::uint8_t leaf = in.choice(kUnsaid + 1);
  if (leaf != kUnsaid) node.leaf = leaf == 1;
  node.margin = in.f32();
  if (!(node.margin >= 0) || std::isinf(node.margin))
    fail_damaged("a margin of the other engine is no length");
  return node;
}

}  // namespace

const char* const kTheirStructureTable = R"sql(
CREATE TABLE their_structures(step INTEGER PRIMARY KEY, data BLOB);
)sql";

template <int D>
Bytes encode_structure(const TheirStructure<D>& structure) {
  ByteWriter out;
  out.varint(structure.nodes.size());
  for (const TheirNode<D>& node : structure.nodes) {
    put(node.name, out);
    out.u8(node.parent ? 1 : 0);
    if (node.parent) put(*node.parent, out);
    for (int axis = 0; axis < D; ++axis) {
      out.f32(node.box.min[axis]);
      out.f32(node.box.max[axis]);
    }
    out.varint(node.objects.size());
    for (const ObjectId object : node.objects) out.varint(object.value);
    out.u8(node.leaf ? (*node.leaf ? 1 : 0) : kUnsaid);
    out.f32(node.margin);
  }
  return compress(out.bytes());
}

template <int D>
TheirStructure<D> decode_structure(std::span<const std::uint8_t> bytes) {
  const Bytes content = decompress(bytes);
  ByteReader in(content);
  TheirStructure<D> structure;
  for (std::size_t left = in.count(); left > 0; --left) structure.nodes.push_back(read_node<D>(in));
  if (!in.empty()) fail_damaged("the other engine's structure is longer than its nodes");
  return structure;
}

bool has_structures(const Database& database) {
  return database.ask("SELECT EXISTS(SELECT 1 FROM sqlite_master WHERE name = 'their_structures')") != 0;
}

template <int D>
void write_structure(Database& database, std::uint32_t step, const TheirStructure<D>& structure) {
  const std::int64_t version = std::max(database.ask("PRAGMA user_version"), std::int64_t{kStructureVersion});
  if (!has_structures(database))
    database.execute(kTheirStructureTable + ("PRAGMA user_version = " + std::to_string(version)));
  const Bytes bytes = encode_structure(structure);
  Statement put_row = database.prepare("INSERT INTO their_structures VALUES(?, ?)");
  put_row.bind(1, std::int64_t{step}).bind(2, std::span(bytes)).run();
}

template <int D>
std::optional<TheirStructure<D>> read_structure(const Database& database, std::uint32_t step) {
  if (!has_structures(database)) return std::nullopt;
  Statement row = database.prepare("SELECT data FROM their_structures WHERE step = ?");
  if (!row.bind(1, std::int64_t{step}).step()) return std::nullopt;
  return decode_structure<D>(row.bytes(0));
}

std::vector<std::uint32_t> read_structure_steps(const Database& database) {
  std::vector<std::uint32_t> steps;
  if (!has_structures(database)) return steps;
  Statement rows = database.prepare("SELECT step FROM their_structures ORDER BY step");
  while (rows.step()) steps.push_back(rows.small(0));
  return steps;
}

#define KERF_INSTANTIATE(D)                                                          \
  template Bytes encode_structure(const TheirStructure<D>&);                         \
  template TheirStructure<D> decode_structure<D>(std::span<const std::uint8_t>);     \
  template void write_structure(Database&, std::uint32_t, const TheirStructure<D>&); \
  template std::optional<TheirStructure<D>> read_structure<D>(const Database&, std::uint32_t);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
