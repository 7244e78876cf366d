#include "core/recording/schema.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <stdexcept>
#include <system_error>

#include "core/base/damage.h"
#include "core/base/float_mode.h"
#include "core/base/number_text.h"
#include "core/recording/object_marks.h"
#include "core/recording/operator_rows.h"
#include "core/recording/shape_rows.h"
#include "core/recording/their_rows.h"
#include "core/recording/their_structure.h"
#include "core/recording/unfinished.h"

namespace kerf {
namespace {

constexpr const char* kTables = R"sql(
CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE config_changes(step INTEGER PRIMARY KEY, config TEXT NOT NULL);
CREATE TABLE decisions(event INTEGER PRIMARY KEY, op TEXT NOT NULL, direction INTEGER, offset REAL);
CREATE TABLE steps(
  step INTEGER PRIMARY KEY,
  objects INTEGER, changed INTEGER, pairs INTEGER,
  height INTEGER, leaves INTEGER, entries INTEGER, redundancy REAL,
  balances INTEGER, shift_splits INTEGER, splits INTEGER, swaps INTEGER, merges INTEGER,
  refused INTEGER, deferred INTEGER, placed INTEGER,
  first_event INTEGER, events INTEGER, operators_hash INTEGER,
  place_seconds REAL, sort_seconds REAL, schedule_seconds REAL, operate_seconds REAL, sweep_seconds REAL,
  state_hash INTEGER, pairs_hash INTEGER, link INTEGER);
CREATE TABLE events(
  id INTEGER PRIMARY KEY, step INTEGER, kind TEXT, op TEXT, node INTEGER, generation INTEGER,
  population INTEGER, left_before INTEGER, right_before INTEGER, left_after INTEGER, right_after INTEGER,
  direction INTEGER, old_offset REAL, new_offset REAL, reason TEXT);
CREATE TABLE blocks(first_step INTEGER PRIMARY KEY, steps INTEGER, changed INTEGER, seal INTEGER, data BLOB);
CREATE TABLE keyframes(step INTEGER PRIMARY KEY, seal INTEGER, data BLOB, looks BLOB);
CREATE TABLE their_seals(step INTEGER PRIMARY KEY, seal INTEGER);
)sql";

template <class Number>
Number number(const std::map<std::string, std::string>& meta, const char* key) {
  const auto found = meta.find(key);
  if (found == meta.end()) fail_damaged(std::string("it does not say its ") + key);
  const std::string& text = found->second;
  const auto value = read_number<Number>(text);
  if (!value) fail_damaged(std::string("its ") + key + " is '" + text + "'");
  return *value;
}

bool flag_of(const std::map<std::string, std::string>& meta, const char* key) {
  const auto value = number<unsigned>(meta, key);
  if (value > 1) fail_damaged(std::string("its ") + key + " is " + std::to_string(value));
  return value == 1;
}

VolumeKind volume_kind(int dimension, const std::string& name) {
  const auto kind = dimension == 2 ? parse_volume_kind<2>(name) : parse_volume_kind<3>(name);
  if (!kind) fail_damaged("there is no volume '" + name + "'");
  return *kind;
}

/// A recorded configuration, on top of the defaults.
Config parse_recorded(const std::string& text) {
  try {
    Config config;
    kerf::apply(config, text);
    return config;
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(std::string("the recording's configuration: ") + error.what());
  }
}

void write_changes(Database& database, const std::vector<ConfigChange>& changes) {
  Statement put = database.prepare("INSERT INTO config_changes VALUES(?, ?)");
  for (const ConfigChange& change : changes)
    put.bind(1, std::int64_t{change.step}).bind(2, to_string(change.config)).run();
}

void write_decisions(Database& database, const std::vector<Decision>& decisions) {
  Statement put = database.prepare("INSERT INTO decisions VALUES(?, ?, ?, ?)");
  for (const Decision& decision : decisions) {
    put.clear();
    put.bind(1, static_cast<std::int64_t>(decision.event)).bind(2, to_string(decision.op));
    if (decision.plane)
      put.bind(3, std::int64_t{decision.plane->direction})
          .bind(4, static_cast<double>(decision.plane->offset));
    put.run();
  }
}

std::vector<ConfigChange> read_changes(const Database& database) {
  std::vector<ConfigChange> changes;
  Statement rows = database.prepare("SELECT step, config FROM config_changes ORDER BY step");
  while (rows.step()) changes.push_back({rows.small(0), parse_recorded(rows.text(1))});
  return changes;
}

std::vector<Decision> read_decisions(const Database& database) {
  std::vector<Decision> decisions;
  Statement rows = database.prepare("SELECT event, op, direction, offset FROM decisions ORDER BY event");
  while (rows.step()) {
    Decision decision{rows.natural(0), operator_called(rows.text(1)), std::nullopt};
    if (!rows.is_null(2) || !rows.is_null(3)) decision.plane = ChosenPlane{rows.small(2), rows.single(3)};
    decisions.push_back(decision);
  }
  return decisions;
}

/// The statements of a text, as SQLite stores them: without the semicolons.
std::vector<std::string> statements(std::string_view sql) {
  std::vector<std::string> result;
  for (std::size_t end = sql.find(';'); end != std::string_view::npos; end = sql.find(';')) {
    const std::size_t begin = sql.find_first_not_of('\n');
    result.emplace_back(sql.substr(begin, end - begin));
    sql.remove_prefix(end + 1);
  }
  return result;
}

/// Only tables have the names of tables: no view without end, no trigger, no table of a module.
void check_tables(const Database& database, bool has_structure) {
  std::vector<std::string> expected = statements(std::string(kTables) + kShapeTable + kMarkTable +
                                                 kTheirTables + (has_structure ? kTheirStructureTable : ""));
  Statement rows = database.prepare("SELECT type, name, sql FROM sqlite_master WHERE sql IS NOT NULL");
  while (rows.step()) {
    const auto found = std::ranges::find(expected, rows.text(2));
    if (found == expected.end())
      fail_damaged("it has a " + rows.text(0) + " '" + rows.text(1) + "' that no Kerf has made");
    expected.erase(found);
  }
  if (!expected.empty()) fail_damaged("it lacks what was made by " + expected.front());
}

void set_meta(Database& database, std::string_view key, std::string_view value) {
  database.prepare("INSERT OR REPLACE INTO meta VALUES(?, ?)").bind(1, key).bind(2, value).run();
}

void write_digits(Database& database, const TheirDigits& digits) {
  set_meta(database, "their_box_digits", std::to_string(digits.boxes.significant));
  set_meta(database, "their_box_decimals", std::to_string(digits.boxes.decimals));
  set_meta(database, "their_node_digits", std::to_string(digits.nodes.significant));
  set_meta(database, "their_node_decimals", std::to_string(digits.nodes.decimals));
  if (digits.boxes.coarse) set_meta(database, "their_box_coarse", "1");
  if (digits.nodes.coarse) set_meta(database, "their_node_coarse", "1");
}

std::optional<TheirDigits> read_digits(const std::map<std::string, std::string>& meta) {
  if (!meta.contains("their_box_digits")) return std::nullopt;
  const auto count = [&](const char* key) { return number<std::uint32_t>(meta, key); };
  const auto is_coarse = [&](const char* key) { return meta.contains(key) && flag_of(meta, key); };
  return TheirDigits{
      {count("their_box_digits"), count("their_box_decimals"), is_coarse("their_box_coarse")},
      {count("their_node_digits"), count("their_node_decimals"), is_coarse("their_node_coarse")}};
}

bool has_recording_id(const Database& database) {
  try {
    return database.ask("PRAGMA application_id") == kRecordingId;
  } catch (const NotADatabase&) {
    return false;
  }
}

}  // namespace

void set_complete(Database& database, std::uint64_t end) {
  set_meta(database, "complete", "1");
  set_meta(database, "end", to_hex(end));
}

std::optional<std::uint64_t> read_end(const Database& database) {
  Statement row = database.prepare("SELECT value FROM meta WHERE key = 'end'");
  if (!row.step()) return std::nullopt;
  const std::string text = row.text(0);
  std::uint64_t end = 0;
  std::from_chars(text.data(), text.data() + text.size(), end, 16);
  if (to_hex(end) != text) fail_damaged("the end of its chain is '" + text + "'");
  return end;
}

void create_schema(Database& database, const RecordingInfo& info) {
  const std::uint32_t version = info.design.rounding == BoundRounding{} ? kRecordingVersion : kRoundedVersion;
  database.execute("BEGIN; PRAGMA application_id = " + std::to_string(kRecordingId) +
                   "; PRAGMA user_version = " + std::to_string(version) + ";" + kTables + kShapeTable +
                   kMarkTable + kTheirTables);
  set_meta(database, "dimension", std::to_string(info.dimension));
  set_meta(database, "volume", to_string(info.volume));
  set_meta(database, "config", to_string(info.config));
  set_meta(database, "scene", info.scene);
  set_meta(database, "imported", info.imported ? "1" : "0");
  set_meta(database, "seed", std::to_string(info.seed));
  set_meta(database, "objects", std::to_string(info.objects));
  set_meta(database, "grow", std::to_string(info.grow));
  set_meta(database, "recycle", std::to_string(info.recycle));
  set_meta(database, "complete", "0");
  write_changes(database, info.changes);
  write_decisions(database, info.decisions);
  write_names(database, info.names);
  write_marks(database, info.marks);
  write_design(database, info.design);
  if (info.digits) write_digits(database, *info.digits);
  database.execute("COMMIT");
}

void remove_recording(const std::filesystem::path& path) noexcept {
  std::error_code ignored;
  for (const char* const ending : {"", "-wal", "-shm"})
    std::filesystem::remove(path.string() + ending, ignored);
}

void fold_log(const std::filesystem::path& path) {
  const std::filesystem::path log = path.string() + "-wal";
  std::error_code none;  // a name may be too long for a log
  if (!std::filesystem::exists(log, none)) return;
  try {
    Database::open_to_end(path).close();
  } catch (const CannotWrite&) {
    throw;
  } catch (const std::runtime_error&) {
    std::filesystem::remove(log);
  }
}

bool is_recording(const std::filesystem::path& path) {
  return std::filesystem::is_regular_file(path) && has_recording_id(Database::open(path));
}

Database open_recording(const std::filesystem::path& path) {
  Database database = Database::open(recording_at(path));
  if (!has_recording_id(database))
    throw std::runtime_error(path.string() + " is no recording of Kerf; `kerf record` makes one");
  const std::int64_t version = database.ask("PRAGMA user_version");
  if (version != kRecordingVersion && version != kStructureVersion && version != kRoundedVersion)
    throw std::runtime_error(path.string() + " is a recording of version " + std::to_string(version) +
                             ", and this Kerf reads versions " + std::to_string(kRecordingVersion) + " to " +
                             std::to_string(kRoundedVersion) +
                             "; record it again, or use the Kerf that made it");
  const bool may_have_structure = version == kRoundedVersion && has_structures(database);
  check_tables(database, version == kStructureVersion || may_have_structure);
  return database;
}

RecordingInfo read_info(const Database& database) {
  const DefaultFloats floats;
  std::map<std::string, std::string> meta;
  Statement rows = database.prepare("SELECT key, value FROM meta");
  while (rows.step()) meta[rows.text(0)] = rows.text(1);
  RecordingInfo info;
  info.dimension = number<int>(meta, "dimension");
  if (info.dimension != 2 && info.dimension != 3) fail_damaged("its dimension is neither 2 nor 3");
  info.volume = volume_kind(info.dimension, meta["volume"]);
  info.config = parse_recorded(meta["config"]);
  info.changes = read_changes(database);
  info.decisions = read_decisions(database);
  info.names = read_names(database);
  info.marks = read_marks(database);
  info.design = read_design(database);
  info.digits = read_digits(meta);
  info.scene = meta["scene"];
  info.imported = flag_of(meta, "imported");
  info.complete = flag_of(meta, "complete");
  if (info.complete != meta.contains("end"))
    fail_damaged("its chain has an end without being complete, or none");
  info.seed = number<std::uint64_t>(meta, "seed");
  info.objects = number<std::uint32_t>(meta, "objects");
  info.grow = number<std::uint32_t>(meta, "grow");
  info.recycle = number<std::uint32_t>(meta, "recycle");
  return info;
}

}  // namespace kerf
