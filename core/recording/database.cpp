#include "core/recording/database.h"

#include <sqlite3.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <new>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "core/base/damage.h"
#include "core/base/float_mode.h"
#include "core/base/poll.h"

namespace kerf {
namespace {

constexpr int kPatience = 30'000;  // ms, while others are in the midst of a query
constexpr int kEvery = 1000;       // steps of SQLite's machine from one `go_on` to the next

[[noreturn]] void fail(sqlite3* database) {
  const char* file = sqlite3_db_filename(database, "main");
  const std::string message =
      std::string(file == nullptr ? "the recording" : file) + ": " + sqlite3_errmsg(database);
  const int error = sqlite3_errcode(database);
  if (error == SQLITE_INTERRUPT) poll();  // which had SQLite stop
  if (error == SQLITE_NOMEM) throw std::bad_alloc();
  if (error == SQLITE_NOTADB) throw NotADatabase(message);
  if (error == SQLITE_FULL) throw CannotWrite(message + " (" + std::generic_category().message(ENOSPC) + ")");
  if (error == SQLITE_IOERR || error == SQLITE_READONLY) throw CannotWrite(message);
  throw std::runtime_error(message);
}

/// As SQLite takes a name: one that begins with a slash is neither a URI nor a database in memory.
std::string plain_name(const std::filesystem::path& path) { return std::filesystem::absolute(path).string(); }

/// A URI that says that nothing will change: SQLite then neither locks nor looks for a log.
std::string immutable_name(const std::filesystem::path& path) {
  std::string uri = "file:";
  for (const char c : plain_name(path)) {
    char escaped[4];
    std::snprintf(escaped, sizeof escaped, "%%%02x", static_cast<unsigned>(static_cast<unsigned char>(c)));
    uri += c == '/' ? "/" : escaped;
  }
  return uri + "?immutable=1";
}

bool has_content(const std::filesystem::path& path, const char* ending) {
  std::error_code none;
  const auto size = std::filesystem::file_size(path.string() + ending, none);
  return !none && size > 0;
}

/// SQLite's message, and the system's if there is one.
std::string reason(sqlite3* database) {
  const int error = sqlite3_system_errno(database);
  const std::string words = sqlite3_errmsg(database);
  return error == 0 ? words : words + " (" + std::generic_category().message(error) + ")";
}

}  // namespace

void Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Statement::Statement(sqlite3* database, std::string_view sql) : database_(database) {
  sqlite3_stmt* statement = nullptr;
  check(sqlite3_prepare_v2(database, sql.data(), static_cast<int>(sql.size()), &statement, nullptr));
  statement_.reset(statement);
}

void Statement::check(int result) const {
  if (result != SQLITE_OK) fail(database_);
}

Statement& Statement::bind(int place, std::int64_t value) {
  check(sqlite3_bind_int64(statement_.get(), place, value));
  return *this;
}

Statement& Statement::bind(int place, double value) {
  check(sqlite3_bind_double(statement_.get(), place, value));
  return *this;
}

Statement& Statement::bind(int place, std::string_view text) {
  check(sqlite3_bind_text(statement_.get(), place, text.data(), static_cast<int>(text.size()),
                          SQLITE_TRANSIENT));
  return *this;
}

Statement& Statement::bind(int place, std::span<const std::uint8_t> bytes) {
  static constexpr std::uint8_t kNoByte = 0;  // a null pointer would be NULL, which is no bytes at all
  check(sqlite3_bind_blob64(statement_.get(), place, bytes.empty() ? &kNoByte : bytes.data(), bytes.size(),
                            SQLITE_STATIC));
  return *this;
}

bool Statement::step() {
  const int result = sqlite3_step(statement_.get());
  if (result == SQLITE_ROW) return true;
  reset();
  if (result != SQLITE_DONE) fail(database_);
  return false;
}

void Statement::run() {
  while (step()) continue;
}

void Statement::reset() { sqlite3_reset(statement_.get()); }

void Statement::clear() { sqlite3_clear_bindings(statement_.get()); }

void Statement::refuse(int column, const char* what) const {
  fail_damaged(std::string("its column '") + sqlite3_column_name(statement_.get(), column) +
               "' has a value that is " + what);
}

void Statement::expect(int column, int type, const char* what) const {
  if (sqlite3_column_type(statement_.get(), column) != type) refuse(column, what);
}

bool Statement::is_null(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

std::int64_t Statement::integer(int column) const {
  expect(column, SQLITE_INTEGER, "no whole number");
  return sqlite3_column_int64(statement_.get(), column);
}

std::uint64_t Statement::natural(int column, std::uint64_t most) const {
  const std::int64_t value = integer(column);
  if (value < 0 || static_cast<std::uint64_t>(value) > most) refuse(column, "out of its range");
  return static_cast<std::uint64_t>(value);
}

std::uint32_t Statement::small(int column) const {
  return static_cast<std::uint32_t>(natural(column, UINT32_MAX));
}

double Statement::real_or_infinite(int column) const {
  expect(column, SQLITE_FLOAT, "no number with a point");
  return sqlite3_column_double(statement_.get(), column);
}

double Statement::real(int column) const {
  const double value = real_or_infinite(column);
  if (!std::isfinite(value)) refuse(column, "not finite");
  return value;
}

float Statement::single(int column) const {
  const DefaultFloats floats;
  const double value = real(column);
  if (std::abs(value) > static_cast<double>(std::numeric_limits<float>::max()))
    refuse(column, "out of its range");
  const auto rounded = static_cast<float>(value);
  if (static_cast<double>(rounded) != value) refuse(column, "more exact than any that was written");
  return rounded;
}

std::string Statement::text(int column) const {
  expect(column, SQLITE_TEXT, "no text");
  const unsigned char* text = sqlite3_column_text(statement_.get(), column);
  if (text == nullptr) throw std::bad_alloc();
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  return {text, text + size};
}

Bytes Statement::bytes(int column) const {
  expect(column, SQLITE_BLOB, "no bytes");
  const auto* data = static_cast<const std::uint8_t*>(sqlite3_column_blob(statement_.get(), column));
  if (data == nullptr && sqlite3_errcode(database_) == SQLITE_NOMEM) throw std::bad_alloc();
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  return data == nullptr ? Bytes() : Bytes(data, data + size);
}

void Statement::put_row(ByteWriter& out) const {
  for (int column = 0; column < sqlite3_column_count(statement_.get()); ++column) {
    const int type = sqlite3_column_type(statement_.get(), column);
    out.u8(static_cast<std::uint8_t>(type));
    if (type == SQLITE_INTEGER) out.u64(static_cast<std::uint64_t>(integer(column)));
    if (type == SQLITE_FLOAT) out.u64(std::bit_cast<std::uint64_t>(real_or_infinite(column)));
    if (type == SQLITE_TEXT) out.text(text(column));
    if (type == SQLITE_BLOB) out.blob(bytes(column));
  }
}

void Database::Close::operator()(sqlite3* database) const { sqlite3_close_v2(database); }

Database::Database(const std::filesystem::path& path, const std::string& name, int flags, const char* vfs) {
  sqlite3* database = nullptr;
  const int result = sqlite3_open_v2(name.c_str(), &database, flags, vfs);
  database_.reset(database);
  if (result == SQLITE_NOMEM) throw std::bad_alloc();
  if (result != SQLITE_OK) throw std::runtime_error("cannot open " + path.string() + ": " + reason(database));
  sqlite3_busy_timeout(database, kPatience);
  sqlite3_progress_handler(database, kEvery, go_on, patience_.get());
}

/// Nothing may be thrown through SQLite.
int Database::go_on(void* patience) {
  try {
    poll();
    return static_cast<Patience*>(patience)->left-- == 0 ? 1 : 0;
  } catch (...) {
    return 1;
  }
}

Database Database::create(const std::filesystem::path& path) {
  auto lock = std::make_unique<const WriterLock>(path);
  if (has_content(path, "")) throw std::runtime_error(path.string() + " exists already");
  auto files = std::make_unique<FreshFiles>(path);
  Database database(path, plain_name(path), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  database.lock_ = std::move(lock);
  database.files_ = std::move(files);
  // Each page is written twice, by a call of its own: blocks and keyframes fill large ones. The log is folded
  // into the file every 1,000 pages: each time the writer waits for the disk.
  database.execute(
      "PRAGMA page_size = 16384; PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL; PRAGMA "
      "wal_autocheckpoint = 1000;");
  return database;
}

Database Database::open(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path))
    throw std::runtime_error("there is no recording " + path.string());
  Database database = is_being_written(path) ? open_beside_writer(path) : open_at_rest(path);
  std::error_code none;
  const auto log = std::filesystem::file_size(path.string() + "-wal", none);
  database.trust_nothing(std::filesystem::file_size(path) + (none ? 0 : log));
  return database;
}

Database Database::open_to_end(const std::filesystem::path& path) {
  return {path, plain_name(path), SQLITE_OPEN_READWRITE};
}

Database Database::open_beside_writer(const std::filesystem::path& path) {
  Database database(path, plain_name(path), SQLITE_OPEN_READONLY);
  try {
    database.execute("PRAGMA schema_version");
  } catch (const NotADatabase&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(
        std::string(error.what()) +
        "; it is being written, and until it is done its readers need to write into its folder");
  }
  return database;
}

Database Database::open_at_rest(const std::filesystem::path& path) {
  if (!has_content(path, "-wal") && !has_content(path, "-journal"))
    return {path, immutable_name(path), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI};
  Database database(path, plain_name(path), SQLITE_OPEN_READONLY, "unix-none");
  // So SQLite keeps the index of the log in memory. It must not clean up: others may read the same file.
  sqlite3_db_config(database.database_.get(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
  database.execute("PRAGMA locking_mode = EXCLUSIVE");
  if (has_content(path, "-journal")) database.look_for_journal(path);
  return database;
}

/// What another program has begun to change SQLite takes back before it reads, which takes a right to write.
void Database::look_for_journal(const std::filesystem::path& path) {
  try {
    execute("PRAGMA schema_version");
  } catch (const NotADatabase&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string(error.what()) + "; beside it lies " + path.filename().string() +
                             "-journal: another program was changing the recording. `sqlite3 FILE` takes "
                             "that back; if the journal is not of this file, remove it");
  }
}

/// A row takes some bytes of the file and some steps of SQLite's machine. Pages that point to one another in
/// a circle would give rows without end.
void Database::trust_nothing(std::uint64_t size) {
  constexpr std::uint64_t kLeast = 10'000'000;
  constexpr std::uint64_t kStepsForAByte = 16;
  patience_->whole = (kLeast + kStepsForAByte * size) / kEvery;
  sqlite3_db_config(database_.get(), SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(database_.get(), SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  patience_->left = patience_->whole;
  execute("PRAGMA cell_size_check = ON");
}

void Database::execute(const std::string& sql) {
  if (sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
    fail(database_.get());
}

void Database::check_size(const std::filesystem::path& path) const {
  if (has_content(path, "-wal")) return;
  const std::uintmax_t size = std::filesystem::file_size(path);
  const auto whole = static_cast<std::uintmax_t>(ask("PRAGMA page_count") * ask("PRAGMA page_size"));
  if (size != whole)
    fail_damaged("its pages take " + std::to_string(whole) + " bytes, and the file has " +
                 std::to_string(size));
}

Statement Database::prepare(std::string_view sql) const {
  patience_->left = patience_->whole;
  return {database_.get(), sql};
}

std::int64_t Database::ask(std::string_view sql) const {
  Statement statement = prepare(sql);
  return statement.step() ? statement.integer(0) : 0;
}

/// Without a log beside it the file can be copied as it is. SQLite keeps the log for readers, and lets them
/// go on when it is emptied.
void Database::close() {
  const int result = sqlite3_exec(database_.get(), "PRAGMA journal_mode = DELETE", nullptr, nullptr, nullptr);
  if (result != SQLITE_OK && result != SQLITE_BUSY) fail(database_.get());
  if (result == SQLITE_BUSY && ask("PRAGMA wal_checkpoint(TRUNCATE)") != 0)
    throw std::runtime_error(std::string(sqlite3_db_filename(database_.get(), "main")) +
                             ": another process keeps reading it; it needs its log, which ends with -wal");
  database_.reset();
  lock_.reset();
}

}  // namespace kerf
