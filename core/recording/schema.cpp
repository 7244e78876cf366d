#include "core/recording/schema.h"

#include <charconv>
#include <map>
#include <stdexcept>
#include <system_error>

#include "core/recording/their_rows.h"

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
  first_event INTEGER, events INTEGER,
  place_seconds REAL, sort_seconds REAL, schedule_seconds REAL, operate_seconds REAL, sweep_seconds REAL,
  state_hash INTEGER, pairs_hash INTEGER);
CREATE TABLE events(
  id INTEGER PRIMARY KEY, step INTEGER, kind TEXT, op TEXT, node INTEGER, generation INTEGER,
  population INTEGER, left_before INTEGER, right_before INTEGER, left_after INTEGER, right_after INTEGER,
  direction INTEGER, old_offset REAL, new_offset REAL, reason TEXT);
CREATE TABLE blocks(first_step INTEGER PRIMARY KEY, steps INTEGER, changed INTEGER, data BLOB);
CREATE TABLE keyframes(step INTEGER PRIMARY KEY, data BLOB);
)sql";

template <class Number>
Number number(const std::map<std::string, std::string>& meta, const char* key) {
  Number value{};
  const auto found = meta.find(key);
  if (found == meta.end()) throw std::runtime_error(std::string("the recording does not say its ") + key);
  const std::string& text = found->second;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    throw std::runtime_error(std::string("the recording is damaged: its ") + key + " is '" + text + "'");
  return value;
}

VolumeKind volume_kind(int dimension, const std::string& name) {
  const auto kind = dimension == 2 ? parse_volume_kind<2>(name) : parse_volume_kind<3>(name);
  if (!kind) throw std::runtime_error("the recording is damaged: there is no volume '" + name + "'");
  return *kind;
}

/// A configuration as it was written down, on top of the defaults.
Config parse_recorded(const std::string& text) {
  try {
    Config config;
    kerf::apply(config, text);
    return config;
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(std::string("the recording's configuration: ") + error.what());
  }
}

Operator operator_of(const std::string& name) {
  for (int k = 0; k < kOperatorCount; ++k)
    if (const auto op = static_cast<Operator>(k); to_string(op) == name) return op;
  throw std::runtime_error("the recording is damaged: there is no operator '" + name + "'");
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
  while (rows.step())
    changes.push_back({static_cast<std::uint32_t>(rows.integer(0)), parse_recorded(rows.text(1))});
  return changes;
}

std::vector<Decision> read_decisions(const Database& database) {
  std::vector<Decision> decisions;
  Statement rows = database.prepare(
      "SELECT event, op, direction IS NOT NULL, direction, offset FROM decisions ORDER BY event");
  while (rows.step()) {
    Decision decision{static_cast<std::uint64_t>(rows.integer(0)), operator_of(rows.text(1)), std::nullopt};
    if (rows.integer(2) != 0)
      decision.plane =
          ChosenPlane{static_cast<std::uint32_t>(rows.integer(3)), static_cast<float>(rows.real(4))};
    decisions.push_back(decision);
  }
  return decisions;
}

bool has_recording_id(const Database& database) {
  try {
    return database.ask("PRAGMA application_id") == kRecordingId;
  } catch (const std::runtime_error&) {
    return false;  // no SQLite file at all
  }
}

}  // namespace

void set_meta(Database& database, std::string_view key, std::string_view value) {
  database.prepare("INSERT OR REPLACE INTO meta VALUES(?, ?)").bind(1, key).bind(2, value).run();
}

void create_schema(Database& database, const RecordingInfo& info) {
  database.execute("BEGIN; PRAGMA application_id = " + std::to_string(kRecordingId) +
                   "; PRAGMA user_version = " + std::to_string(kRecordingVersion) + ";" + kTables +
                   kTheirTables);
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
  write_design(database, info.design);
  database.execute("COMMIT");
}

void remove_recording(const std::filesystem::path& path) noexcept {
  std::error_code ignored;
  for (const char* const ending : {"", "-wal", "-shm"})
    std::filesystem::remove(path.string() + ending, ignored);
}

bool is_recording(const std::filesystem::path& path) {
  return std::filesystem::is_regular_file(path) && has_recording_id(Database::open(path));
}

Database open_recording(const std::filesystem::path& path) {
  Database database = Database::open(path);
  if (!has_recording_id(database))
    throw std::runtime_error(path.string() + " is no recording of Kerf; `kerf record` makes one");
  const std::int64_t version = database.ask("PRAGMA user_version");
  if (version != kRecordingVersion)
    throw std::runtime_error(path.string() + " is a recording of version " + std::to_string(version) +
                             ", and this Kerf reads version " + std::to_string(kRecordingVersion) +
                             "; record it again, or use the Kerf that made it");
  return database;
}

RecordingInfo read_info(const Database& database) {
  std::map<std::string, std::string> meta;
  Statement rows = database.prepare("SELECT key, value FROM meta");
  while (rows.step()) meta[rows.text(0)] = rows.text(1);
  RecordingInfo info;
  info.dimension = number<int>(meta, "dimension");
  if (info.dimension != 2 && info.dimension != 3)
    throw std::runtime_error("the recording is damaged: its dimension is neither 2 nor 3");
  info.volume = volume_kind(info.dimension, meta["volume"]);
  info.config = parse_recorded(meta["config"]);
  info.changes = read_changes(database);
  info.decisions = read_decisions(database);
  info.names = read_names(database);
  info.design = read_design(database);
  info.scene = meta["scene"];
  info.imported = meta["imported"] == "1";
  info.complete = meta["complete"] == "1";
  info.seed = number<std::uint64_t>(meta, "seed");
  info.objects = number<std::uint32_t>(meta, "objects");
  info.grow = number<std::uint32_t>(meta, "grow");
  info.recycle = number<std::uint32_t>(meta, "recycle");
  return info;
}

}  // namespace kerf
