#include "frames/import/given_nodes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>

#include "core/base/ids.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

constexpr std::size_t kStepOfNode = 0;
constexpr std::size_t kNodeName = 1;
constexpr std::size_t kParentNode = 2;
constexpr std::size_t kBoundsOfNode = 3;
constexpr std::size_t kObjectsOfNode = kBoundsOfNode + 6;
constexpr std::size_t kLeafFlag = kObjectsOfNode + 1;
constexpr std::size_t kMarginOfNode = kLeafFlag + 1;

std::vector<CsvColumn> node_columns() {
  std::vector<CsvColumn> columns{
      step_column(),
      {"node", {"nodeid", "nodeindex", "cell", "cellid"}},
      {"parent", {"parentid", "parentnode", "parentindex", "up"}},
  };
  for (CsvColumn& bound : bound_columns()) columns.push_back(std::move(bound));
  columns.push_back({"object",
                     {"objects", "objectid", "member", "members", "body", "bodies", "bodyid", "proxy",
                      "proxyid", "entity", "entityid"}});
  columns.push_back({"leaf", {"isleaf"}});
  columns.push_back({"margin", {"fatmargin", "skin"}});
  return columns;
}

const char* form_of(int dimension) {
  return dimension == 2 ? "step,node,parent,min_x,max_x,min_y,max_y,object"
                        : "step,node,parent,min_x,max_x,min_y,max_y,min_z,max_z,object";
}

void check_columns(const CsvTable& table, int dimension) {
  const std::string form = form_of(dimension);
  if (!table.has_heading())
    throw UsageError(table.name() + " needs a heading: " + form +
                     ", and perhaps leaf and margin, in any order");
  std::vector<std::size_t> wanted{kStepOfNode, kNodeName, kParentNode, kObjectsOfNode};
  for (std::size_t k = 0; k < 2 * static_cast<std::size_t>(dimension); ++k)
    wanted.push_back(kBoundsOfNode + k);
  for (const std::size_t column : wanted)
    if (!table.has(column))
      throw UsageError(table.name() + ": the heading must be " + form +
                       ", and perhaps leaf and margin, in any order; it has " + table.names());
  for (std::size_t column = kBoundsOfNode + 2 * static_cast<std::size_t>(dimension); column < kObjectsOfNode;
       ++column)
    if (table.has(column))
      throw UsageError(table.name() +
                       ": its boxes have a z, and those of the objects have none; give both a z, or neither");
}

/// Nothing, or -1, is no parent.
std::optional<GivenId> read_parent(const CsvTable& table) {
  if (table.is_blank(kParentNode)) return std::nullopt;
  const GivenId parent = table.id(kParentNode);
  return parent == kNoIndex ? std::nullopt : std::optional(parent);
}

/// Null pointers and null indices are no parents where no root is blank or has -1.
void drop_null_parents(std::vector<GivenNode>& nodes) {
  if (std::ranges::any_of(nodes, [](const GivenNode& node) { return !node.parent; })) return;
  for (const std::uint64_t null : {std::uint64_t{0}, std::uint64_t{UINT32_MAX}, UINT64_MAX}) {
    const GivenId id{false, null};
    if (std::ranges::find(nodes, id, &GivenNode::node) != nodes.end()) continue;
    for (GivenNode& node : nodes)
      if (node.parent == id) node.parent.reset();
  }
}

/// "3", or several: "3 7 12" or "3;7;12".
std::vector<GivenId> read_objects(const CsvTable& table) {
  constexpr std::string_view kBetween = " ;\t";
  std::vector<GivenId> objects;
  std::string_view rest = table.text(kObjectsOfNode);
  for (;;) {
    rest.remove_prefix(std::min(rest.find_first_not_of(kBetween), rest.size()));
    if (rest.empty()) return objects;
    const std::size_t end = std::min(rest.find_first_of(kBetween), rest.size());
    const auto id = parse_given_id(rest.substr(0, end));
    if (!id) table.reject(kObjectsOfNode, "is neither an object nor several, such as 3 or 3 7 12");
    objects.push_back(*id);
    rest.remove_prefix(end);
  }
}

double read_bound(const CsvTable& table, std::size_t column, TableWriting& digits) {
  if (table.is_blank(column))
    table.reject("node " + std::string(table.text(kNodeName)) + " lacks a bound of its box");
  const double bound = table.real(column);
  if (std::isnan(bound)) table.reject(column, "is no number");
  digits.note(table.text(column));
  return bound;
}

GivenNode read_node(const CsvTable& table, int dimension, TableWriting& digits) {
  GivenNode node;
  node.line = table.line();
  if (table.is_blank(kNodeName)) table.reject("the node is blank");
  node.node = table.id(kNodeName);
  if (node.node == kNoIndex) table.reject(kNodeName, "is no name: a parent of -1 says that there is none");
  node.parent = read_parent(table);
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    node.min[axis] = read_bound(table, kBoundsOfNode + 2 * axis, digits);
    node.max[axis] = read_bound(table, kBoundsOfNode + 2 * axis + 1, digits);
  }
  node.objects = read_objects(table);
  if (!table.is_blank(kLeafFlag)) node.leaf = table.boolean(kLeafFlag);
  if (table.is_blank(kMarginOfNode)) return node;
  node.margin = table.real(kMarginOfNode);
  constexpr double kMost = std::numeric_limits<Scalar>::max();
  if (!(node.margin >= 0 && node.margin <= kMost)) table.reject(kMarginOfNode, "is no length");
  return node;
}

bool has_only_step(const CsvTable& table) {
  for (std::size_t column = kNodeName; column <= kMarginOfNode; ++column)
    if (!table.is_blank(column)) return false;
  return true;
}

}  // namespace

GivenTrees read_given_nodes(const std::filesystem::path& path, int dimension, Oddities& oddities) {
  CsvTable table(path, node_columns());
  check_columns(table, dimension);
  GivenTrees trees;
  std::map<long double, GivenNodes> by_time;
  while (table.next()) {
    GivenStep step = read_step(table, kStepOfNode);
    const auto [found, is_new] = by_time.try_emplace(step.time);
    if (is_new) {
      found->second.step = std::move(step);
      found->second.line = table.line();
    } else if (const std::string conflict = conflict_of(step, found->second.step); !conflict.empty()) {
      table.reject(conflict);
    }
    if (!has_only_step(table)) found->second.nodes.push_back(read_node(table, dimension, trees.digits));
  }
  note_cut(table, oddities);
  for (auto& [time, of_step] : by_time) {
    drop_null_parents(of_step.nodes);
    trees.steps.push_back(std::move(of_step));
  }
  return trees;
}

}  // namespace kerf
