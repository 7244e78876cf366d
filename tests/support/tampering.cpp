#include "tests/support/tampering.h"

#include <sqlite3.h>

#include <memory>
#include <stdexcept>

#include "core/recording/chain.h"
#include "core/recording/compression.h"
#include "core/recording/database.h"
#include "core/recording/keyframe_codec.h"
#include "core/recording/recording_reader.h"
#include "core/recording/schema.h"

namespace kerf::test {
namespace {

struct Close {
  void operator()(sqlite3* database) const { sqlite3_close(database); }
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Statement = std::unique_ptr<sqlite3_stmt, Close>;

/// A file that may be changed in any way.
class Writable {
 public:
  explicit Writable(const std::filesystem::path& file) {
    sqlite3* database = nullptr;
    const int result = sqlite3_open_v2(file.c_str(), &database, SQLITE_OPEN_READWRITE, nullptr);
    database_.reset(database);
    check(result == SQLITE_OK);
  }

  [[nodiscard]] Statement prepare(const std::string& sql) const {
    sqlite3_stmt* statement = nullptr;
    check(sqlite3_prepare_v2(database_.get(), sql.c_str(), -1, &statement, nullptr) == SQLITE_OK);
    return Statement(statement);
  }
  bool step(const Statement& statement) const {
    const int result = sqlite3_step(statement.get());
    check(result == SQLITE_ROW || result == SQLITE_DONE);
    return result == SQLITE_ROW;
  }
  void run(const std::string& sql) const { step(prepare(sql)); }
  void put(const std::string& sql, std::uint64_t number) const {
    const Statement statement = prepare(sql);
    sqlite3_bind_int64(statement.get(), 1, static_cast<std::int64_t>(number));
    step(statement);
  }
  void put(const std::string& sql, const Bytes& bytes) const {
    const Statement statement = prepare(sql);
    sqlite3_bind_blob(statement.get(), 1, bytes.data(), static_cast<int>(bytes.size()), SQLITE_STATIC);
    step(statement);
  }

 private:
  void check(bool holds) const {
    if (!holds) throw std::runtime_error(sqlite3_errmsg(database_.get()));
  }
  std::unique_ptr<sqlite3, Close> database_;
};

std::vector<std::string> texts(const std::filesystem::path& file, const std::string& sql) {
  const Writable database(file);
  const Statement rows = database.prepare(sql);
  std::vector<std::string> result;
  while (database.step(rows))
    result.emplace_back(reinterpret_cast<const char*>(sqlite3_column_text(rows.get(), 0)));
  return result;
}

void flip(std::string& bytes, Random& random) {
  if (bytes.empty()) bytes = "x";
  char& byte = bytes[random.below(static_cast<std::uint32_t>(bytes.size()))];
  byte = static_cast<char>(byte ^ (1 << random.below(5)));  // a letter stays one, more or less
}

/// The value at column 0 of the row, changed, at place 1 of the other statement.
void bind_changed(sqlite3_stmt* row, sqlite3_stmt* update, Random& random) {
  const int size = sqlite3_column_bytes(row, 0);
  const auto bytes = [&](const void* data) {
    return std::string(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  std::string changed;
  switch (sqlite3_column_type(row, 0)) {
    case SQLITE_INTEGER:
      sqlite3_bind_int64(update, 1, sqlite3_column_int64(row, 0) ^ (std::int64_t{1} << random.below(63)));
      return;
    case SQLITE_FLOAT:
      sqlite3_bind_double(update, 1, sqlite3_column_double(row, 0) * 1.5 + 0.25);
      return;
    case SQLITE_TEXT:
      changed = bytes(sqlite3_column_text(row, 0));
      flip(changed, random);
      sqlite3_bind_text(update, 1, changed.data(), static_cast<int>(changed.size()), SQLITE_TRANSIENT);
      return;
    case SQLITE_BLOB:
      changed = bytes(sqlite3_column_blob(row, 0));
      flip(changed, random);
      sqlite3_bind_blob(update, 1, changed.data(), static_cast<int>(changed.size()), SQLITE_TRANSIENT);
      return;
    default:
      sqlite3_bind_int64(update, 1, 1);
  }
}

/// What distinguishes the rows of a table.
std::string key_of(const std::string& table) { return table == "meta" ? "key" : "rowid"; }

Bytes blob(const Writable& database, const std::string& sql) {
  const Statement row = database.prepare(sql);
  if (!database.step(row)) throw std::runtime_error("no row: " + sql);
  const auto* data = static_cast<const std::uint8_t*>(sqlite3_column_blob(row.get(), 0));
  return {data, data + sqlite3_column_bytes(row.get(), 0)};
}

/// Goes through a recording like its writer.
class Resealer {
 public:
  explicit Resealer(const std::filesystem::path& recording)
      : reading_(Database::open(recording)),
        rows_(read_rows(reading_, {})),
        chain_(head_of(reading_)),
        database_(recording) {}

  void run() {
    database_.run("BEGIN");
    for (const StepRow& row : rows_.steps) {
      const std::uint64_t link = chain_.add(row);
      database_.put("UPDATE steps SET link = ? WHERE step = " + std::to_string(row.step), link);
      for (const BlockRow& block : rows_.blocks)
        if (block.last_step() == row.step) seal(block);
      for (const KeyframeRow& keyframe : rows_.keyframes)
        if (keyframe.step == row.step) seal(keyframe);
      for (const TheirRow& theirs : rows_.theirs)
        if (theirs.step == row.step) seal(theirs);
      seal_shapes(row.step);
    }
    database_.run("UPDATE meta SET value = '" + to_hex(chain_.end()) + "' WHERE key = 'end'");
    database_.run("COMMIT");
  }

 private:
  void seal(const BlockRow& block) {
    const std::string where = " blocks WHERE first_step = " + std::to_string(block.first_step);
    note(Chain::Part::block, "blocks", "first_step", block.first_step,
         seal_of_block(chain_.link(), block.first_step, block.steps, block.changed,
                       blob(database_, "SELECT data FROM" + where)));
  }
  void seal(const KeyframeRow& keyframe) {
    const std::string where = " keyframes WHERE step = " + std::to_string(keyframe.step);
    note(Chain::Part::keyframe, "keyframes", "step", keyframe.step,
         seal_of_keyframe(chain_.link(), keyframe.step, blob(database_, "SELECT data FROM" + where),
                          blob(database_, "SELECT looks FROM" + where)));
  }
  /// Of the shapes that came with a step.
  void seal_shapes(std::uint32_t step) {
    std::vector<std::uint64_t> seals;
    for (std::uint32_t shape = 0; shape < rows_.shapes.size(); ++shape) {
      if (rows_.shapes[shape].step != step) continue;
      const std::string where = " FROM shapes WHERE shape = " + std::to_string(shape);
      const Bytes kind = blob(database_, "SELECT kind" + where);
      seals.push_back(seal_of_shape(chain_.link(), shape, std::string(kind.begin(), kind.end()),
                                    blob(database_, "SELECT data" + where)));
      database_.put("UPDATE shapes SET seal = ? WHERE shape = " + std::to_string(shape), seals.back());
    }
    if (!seals.empty()) chain_.add(Chain::Part::shapes, seal_of_shapes(seals));
  }
  void seal(const TheirRow& theirs) {
    const auto seal = seal_of_theirs(chain_.link(), reading_, theirs.step);
    if (seal) {
      note(Chain::Part::theirs, "their_seals", "step", theirs.step, *seal);
    } else {
      database_.run("DELETE FROM their_seals WHERE step = " + std::to_string(theirs.step));
    }
  }
  void note(Chain::Part part, const std::string& table, const std::string& key, std::uint32_t step,
            std::uint64_t seal) {
    database_.put("UPDATE " + table + " SET seal = ? WHERE " + key + " = " + std::to_string(step), seal);
    chain_.add(part, seal);
  }

  Database reading_;  ///< as it was before the seals are changed
  RecordedRows rows_;
  Chain chain_;
  Writable database_;
};

}  // namespace

std::string to_string(const StoredValue& value) {
  return value.table + "." + value.column + ", row " + std::to_string(value.row);
}

std::vector<std::string> tables_of(const std::filesystem::path& file) {
  return texts(file, "SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name");
}

std::vector<std::string> columns_of(const std::filesystem::path& file, const std::string& table) {
  return texts(file, "SELECT name FROM pragma_table_info('" + table + "')");
}

std::uint32_t rows_of(const std::filesystem::path& file, const std::string& table) {
  return static_cast<std::uint32_t>(std::stoul(texts(file, "SELECT count(*) FROM " + table).front()));
}

void change_value(const std::filesystem::path& file, const StoredValue& value, Random& random) {
  const Writable database(file);
  const std::string row = " FROM " + value.table + " ORDER BY 1 LIMIT 1 OFFSET " + std::to_string(value.row);
  const std::string key = key_of(value.table);
  const std::string which = " WHERE " + key + " = (SELECT " + key + row + ")";
  const Statement old = database.prepare("SELECT " + value.column + " FROM " + value.table + which);
  if (!database.step(old)) throw std::runtime_error("no row: " + to_string(value));
  const Statement update =
      database.prepare("UPDATE " + value.table + " SET " + value.column + " = ?" + which);
  bind_changed(old.get(), update.get(), random);
  sqlite3_reset(old.get());
  database.step(update);
}

void reseal(const std::filesystem::path& recording) { Resealer(recording).run(); }

void forge_block(const std::filesystem::path& recording, std::uint32_t first_step, const Bytes& data) {
  Writable(recording).put("UPDATE blocks SET data = ? WHERE first_step = " + std::to_string(first_step),
                          data);
  reseal(recording);
}

void forge_keyframe(const std::filesystem::path& recording, std::uint32_t step, const Bytes& data) {
  Writable(recording).put("UPDATE keyframes SET data = ? WHERE step = " + std::to_string(step), data);
  reseal(recording);
}

void forge_keyframe_looks(const std::filesystem::path& recording, std::uint32_t step, const Bytes& looks) {
  Writable(recording).put("UPDATE keyframes SET looks = ? WHERE step = " + std::to_string(step), looks);
  reseal(recording);
}

template <int D>
void forge_keyframe(const std::filesystem::path& recording, std::uint32_t step,
                    const std::function<void(BspState<D>&)>& change) {
  BspState<D> state = [&] {
    const RecordingReader<D> reader(recording);
    return reader.keyframe(step, make_projector<D>(config_of(reader.info(), step), reader.info().volume));
  }();
  change(state);
  forge_keyframe(recording, step, encode_keyframe(state));
}

template <int D>
Bytes first_block_with_object(const std::filesystem::path& recording, std::uint32_t number) {
  const std::int64_t steps = Database::open(recording).ask("SELECT steps FROM blocks WHERE first_step = 1");
  ByteWriter calls;
  calls.varint(1);
  calls.u8(static_cast<std::uint8_t>(RequestKind::insert_box));
  calls.u8(0);
  calls.varint(1);
  ByteWriter objects;
  objects.varint(zigzag(static_cast<std::int32_t>(number)));
  ByteWriter block;
  block.varint(static_cast<std::uint64_t>(steps));
  block.blob(calls.bytes());
  block.blob(objects.bytes());
  block.blob(Bytes(2 * static_cast<std::size_t>(steps)));  // no events
  for (int channel = 0; channel < 2 * D; ++channel) block.blob(Bytes{0});
  block.blob({});
  LookEncoder<D>().take(block);
  return compress(block.bytes());
}

template void forge_keyframe<2>(const std::filesystem::path&, std::uint32_t,
                                const std::function<void(BspState<2>&)>&);
template void forge_keyframe<3>(const std::filesystem::path&, std::uint32_t,
                                const std::function<void(BspState<3>&)>&);
template Bytes first_block_with_object<2>(const std::filesystem::path&, std::uint32_t);
template Bytes first_block_with_object<3>(const std::filesystem::path&, std::uint32_t);

}  // namespace kerf::test
