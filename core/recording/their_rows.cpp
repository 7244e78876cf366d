#include "core/recording/their_rows.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "core/base/damage.h"
#include "core/base/shortest_text.h"

namespace kerf {
namespace {

std::int64_t as_integer(std::uint64_t x) { return static_cast<std::int64_t>(x); }

std::uint64_t read_count(const Statement& row, int column) {
  const std::int64_t value = row.integer(column);
  if (value < 0) fail_damaged("a count of their pairs is " + std::to_string(value));
  return static_cast<std::uint64_t>(value);
}

/// Six columns from `column` on.
TheirStep read_sum(const Statement& row, int column) {
  return {read_count(row, column),     read_count(row, column + 1), read_count(row, column + 2),
          read_count(row, column + 3), read_count(row, column + 4), read_count(row, column + 5)};
}

/// Undecided pairs are counted where they are: the table of sums is that of recordings without any.
constexpr const char* kSumColumns =
    "pairs, missed, extra, twice, ignored, (SELECT COUNT(*) FROM their_verdicts WHERE their_verdicts.step = "
    "their_steps.step AND verdict = 'undecided')";

ObjectId read_object(const Statement& row, int column) {
  const std::int64_t value = row.integer(column);
  if (value < 0 || value >= std::int64_t{UINT32_MAX})
    fail_damaged("there is no object " + std::to_string(value));
  return {static_cast<std::uint32_t>(value)};
}

Pair read_pair(const Statement& row, int column) {
  const Pair pair{read_object(row, column), read_object(row, column + 1)};
  if (pair.a >= pair.b) fail_damaged("the objects of one of their pairs do not rise");
  return pair;
}

PairVerdict read_verdict(const std::string& name) {
  const auto found = std::ranges::find(kVerdictNames, name);
  if (found == kVerdictNames.end()) fail_damaged("there is no verdict '" + name + "'");
  return static_cast<PairVerdict>(found - kVerdictNames.begin());
}

/// Six columns from `column` on.
template <int D>
GivenBox<D> read_box(const Statement& row, int column) {
  GivenBox<D> box;
  for (std::size_t axis = 0; axis < D; ++axis) {
    box.min[axis] = row.real_or_infinite(column++);
    box.max[axis] = row.real_or_infinite(column++);
  }
  return box;
}

constexpr const char* kBoundColumns = "min_x IS NOT NULL, min_x, max_x, min_y, max_y, min_z, max_z";

}  // namespace

const char* const kTheirTables = R"sql(
CREATE TABLE object_names(object INTEGER PRIMARY KEY, name TEXT NOT NULL);
CREATE TABLE step_names(step INTEGER PRIMARY KEY, name TEXT NOT NULL);
CREATE TABLE their_steps(
  step INTEGER PRIMARY KEY, pairs INTEGER, missed INTEGER, extra INTEGER, twice INTEGER, ignored INTEGER);
CREATE TABLE their_pairs(step INTEGER, a INTEGER, b INTEGER);
CREATE INDEX their_pairs_of_step ON their_pairs(step);
CREATE TABLE their_verdicts(step INTEGER, a INTEGER, b INTEGER, verdict TEXT NOT NULL);
CREATE INDEX their_verdicts_of_step ON their_verdicts(step);
CREATE TABLE their_ignored(a INTEGER, b INTEGER, PRIMARY KEY(a, b));
CREATE TABLE their_boxes(
  step INTEGER, object INTEGER, min_x REAL, max_x REAL, min_y REAL, max_y REAL, min_z REAL, max_z REAL,
  PRIMARY KEY(step, object));
CREATE TABLE their_filters(
  step INTEGER, object INTEGER, category INTEGER, mask INTEGER, PRIMARY KEY(step, object));
)sql";

void write_names(Database& database, const GivenNames& names) {
  Statement put_object = database.prepare("INSERT INTO object_names VALUES(?, ?)");
  std::int64_t object = 0;
  for (const GivenId& name : names.objects()) put_object.bind(1, object++).bind(2, to_string(name)).run();
  Statement put_step = database.prepare("INSERT INTO step_names VALUES(?, ?)");
  std::int64_t step = 1;
  for (const std::string& name : names.steps()) put_step.bind(1, step++).bind(2, name).run();
}

GivenNames read_names(const Database& database) {
  std::vector<GivenId> objects;
  Statement object = database.prepare("SELECT object, name FROM object_names ORDER BY object");
  while (object.step()) {
    const auto name = parse_given_id(object.text(1));
    if (!name || object.integer(0) != as_integer(objects.size()))
      fail_damaged("object " + std::to_string(objects.size()) + " has no name");
    objects.push_back(*name);
  }
  std::vector<std::string> steps;
  Statement step = database.prepare("SELECT step, name FROM step_names ORDER BY step");
  while (step.step()) {
    steps.push_back(step.text(1));
    if (step.integer(0) != as_integer(steps.size())) fail_damaged("one of its steps has no name");
  }
  try {
    return {std::move(objects), std::move(steps)};
  } catch (const std::invalid_argument& error) {
    fail_damaged(std::string("its names: ") + error.what());
  }
}

void write_design(Database& database, const PairDesign& design) {
  Statement put = database.prepare("INSERT INTO their_ignored VALUES(?, ?)");
  for (const Pair& pair : design.ignored)
    put.bind(1, std::int64_t{pair.a.value}).bind(2, std::int64_t{pair.b.value}).run();
  Statement margin = database.prepare("INSERT INTO meta VALUES(?, ?)");
  margin.bind(1, "margin").bind(2, shortest_text(design.margin.absolute)).run();
  margin.bind(1, "margin_share").bind(2, shortest_text(design.margin.share)).run();
  if (design.rounding == BoundRounding{}) return;
  const auto [digits, decimals, floats, planes] = design.rounding;
  margin.bind(1, "bound_digits").bind(2, std::to_string(digits)).run();
  margin.bind(1, "bound_decimals").bind(2, std::to_string(decimals)).run();
  margin.bind(1, "bound_floats").bind(2, floats ? "1" : "0").run();
  margin.bind(1, "bound_planes").bind(2, std::to_string(planes)).run();
}

namespace {

/// None, as in all recordings of earlier versions: the text of a bound was taken for the number. The first
/// recordings with any have no planes: flat boxes at one text were never undecided.
BoundRounding read_rounding(const Database& database) {
  constexpr std::int64_t kMost = 30;
  constexpr std::int64_t kAllPlanes = 7;
  const auto number = [&](const char* key, std::int64_t without = 0) {
    Statement row = database.prepare("SELECT CAST(value AS INTEGER) FROM meta WHERE key = ?");
    const std::int64_t value = row.bind(1, key).step() ? row.integer(0) : without;
    if (value < 0 || value > kMost) fail_damaged(std::string("its ") + key + " are " + std::to_string(value));
    return static_cast<std::uint32_t>(value);
  };
  BoundRounding rounding{number("bound_digits"), number("bound_decimals"), number("bound_floats") != 0};
  if (rounding != BoundRounding{}) rounding.planes = number("bound_planes", kAllPlanes);
  return rounding;
}

}  // namespace

PairDesign read_design(const Database& database) {
  PairDesign design;
  Statement pairs = database.prepare("SELECT a, b FROM their_ignored ORDER BY a, b");
  while (pairs.step()) design.ignored.push_back(read_pair(pairs, 0));
  const auto number = [&](const char* key) {
    Statement row = database.prepare("SELECT CAST(value AS REAL) FROM meta WHERE key = ?");
    const double value = row.bind(1, key).step() ? row.real(0) : 0;
    if (!(value >= 0) || std::isinf(value)) fail_damaged(std::string("its ") + key + " is no length");
    return value;
  };
  design.margin = {number("margin"), number("margin_share")};
  design.rounding = read_rounding(database);
  return design;
}

void write_theirs(Database& database, std::uint32_t step, std::span<const Pair> reported,
                  std::span<const JudgedPair> judged) {
  const TheirStep sum = sum_of(reported.size(), judged);
  Statement put_sum = database.prepare("INSERT INTO their_steps VALUES(?,?,?,?,?,?)");
  put_sum.bind(1, std::int64_t{step}).bind(2, as_integer(sum.pairs)).bind(3, as_integer(sum.missed));
  put_sum.bind(4, as_integer(sum.extra))
      .bind(5, as_integer(sum.twice))
      .bind(6, as_integer(sum.ignored))
      .run();
  Statement put_pair = database.prepare("INSERT INTO their_pairs VALUES(?,?,?)");
  for (const Pair& pair : reported)
    put_pair.bind(1, std::int64_t{step})
        .bind(2, std::int64_t{pair.a.value})
        .bind(3, std::int64_t{pair.b.value})
        .run();
  Statement put_verdict = database.prepare("INSERT INTO their_verdicts VALUES(?,?,?,?)");
  for (const auto& [pair, verdict] : judged)
    put_verdict.bind(1, std::int64_t{step})
        .bind(2, std::int64_t{pair.a.value})
        .bind(3, std::int64_t{pair.b.value})
        .bind(4, to_string(verdict))
        .run();
}

std::vector<Pair> read_their_pairs(const Database& database, std::uint32_t step) {
  std::vector<Pair> pairs;
  Statement rows = database.prepare("SELECT a, b FROM their_pairs WHERE step = ? ORDER BY rowid");
  rows.bind(1, std::int64_t{step});
  while (rows.step()) pairs.push_back(read_pair(rows, 0));
  return pairs;
}

std::vector<JudgedPair> read_judged_pairs(const Database& database, std::uint32_t step) {
  std::vector<JudgedPair> judged;
  Statement rows = database.prepare("SELECT a, b, verdict FROM their_verdicts WHERE step = ? ORDER BY rowid");
  rows.bind(1, std::int64_t{step});
  while (rows.step()) judged.push_back({read_pair(rows, 0), read_verdict(rows.text(2))});
  return judged;
}

std::optional<TheirStep> read_their_step(const Database& database, std::uint32_t step) {
  Statement row = database.prepare(std::string("SELECT ") + kSumColumns + " FROM their_steps WHERE step = ?");
  if (!row.bind(1, std::int64_t{step}).step()) return std::nullopt;
  return read_sum(row, 0);
}

std::vector<std::pair<std::uint32_t, TheirStep>> read_their_steps(const Database& database) {
  std::vector<std::pair<std::uint32_t, TheirStep>> sums;
  Statement rows =
      database.prepare(std::string("SELECT step, ") + kSumColumns + " FROM their_steps ORDER BY step");
  while (rows.step()) {
    const std::int64_t step = rows.integer(0);
    if (step < 1 || step > std::int64_t{UINT32_MAX}) fail_damaged("it judges a step that cannot be");
    sums.emplace_back(static_cast<std::uint32_t>(step), read_sum(rows, 1));
  }
  return sums;
}

template <int D>
void write_changes(Database& database, std::uint32_t step, const TheirChanges<D>& changes) {
  Statement put_box = database.prepare("INSERT INTO their_boxes VALUES(?,?,?,?,?,?,?,?)");
  for (const auto& [object, box] : changes.boxes) {
    put_box.clear();
    put_box.bind(1, std::int64_t{step}).bind(2, std::int64_t{object.value});
    for (std::size_t axis = 0; box && axis < D; ++axis) {
      const int place = 3 + 2 * static_cast<int>(axis);
      put_box.bind(place, box->min[axis]).bind(place + 1, box->max[axis]);
    }
    put_box.run();
  }
  Statement put_filter = database.prepare("INSERT INTO their_filters VALUES(?,?,?,?)");
  for (const auto& [object, filter] : changes.filters)
    put_filter.bind(1, std::int64_t{step})
        .bind(2, std::int64_t{object.value})
        .bind(3, as_integer(filter.category))
        .bind(4, as_integer(filter.mask))
        .run();
}

template <int D>
TheirChanges<D> read_their_changes(const Database& database, std::uint32_t step) {
  TheirChanges<D> changes;
  Statement boxes = database.prepare(std::string("SELECT object, ") + kBoundColumns +
                                     " FROM their_boxes WHERE step = ? ORDER BY object");
  boxes.bind(1, std::int64_t{step});
  while (boxes.step()) {
    changes.boxes.push_back({read_object(boxes, 0), std::nullopt});
    if (boxes.integer(1) != 0) changes.boxes.back().box = read_box<D>(boxes, 2);
  }
  Statement filters =
      database.prepare("SELECT object, category, mask FROM their_filters WHERE step = ? ORDER BY object");
  filters.bind(1, std::int64_t{step});
  while (filters.step())
    changes.filters.push_back(
        {read_object(filters, 0),
         {static_cast<std::uint64_t>(filters.integer(1)), static_cast<std::uint64_t>(filters.integer(2))}});
  return changes;
}

template <int D>
std::optional<GivenBox<D>> read_given_box(const Database& database, ObjectId object, std::uint32_t step) {
  Statement row =
      database.prepare(std::string("SELECT ") + kBoundColumns +
                       " FROM their_boxes WHERE object = ? AND step <= ? ORDER BY step DESC LIMIT 1");
  if (!row.bind(1, std::int64_t{object.value}).bind(2, std::int64_t{step}).step() || row.integer(0) == 0)
    return std::nullopt;
  return read_box<D>(row, 1);
}

std::optional<GivenFilter> read_filter(const Database& database, ObjectId object, std::uint32_t step) {
  Statement row = database.prepare(
      "SELECT category, mask FROM their_filters WHERE object = ? AND step <= ? ORDER BY step DESC LIMIT 1");
  if (!row.bind(1, std::int64_t{object.value}).bind(2, std::int64_t{step}).step()) return std::nullopt;
  return GivenFilter{static_cast<std::uint64_t>(row.integer(0)), static_cast<std::uint64_t>(row.integer(1))};
}

#define KERF_INSTANTIATE(D)                                                         \
  template void write_changes<D>(Database&, std::uint32_t, const TheirChanges<D>&); \
  template TheirChanges<D> read_their_changes<D>(const Database&, std::uint32_t);   \
  template std::optional<GivenBox<D>> read_given_box<D>(const Database&, ObjectId, std::uint32_t);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
