#include "core/recording/database.h"

#include <sqlite3.h>

#include <cstdio>
#include <system_error>
#include <utility>

namespace kerf {
namespace {

constexpr int kPatience = 30'000;  // ms, while others are in the midst of a query

[[noreturn]] void fail(sqlite3* database) {
  const char* file = sqlite3_db_filename(database, "main");
  const std::string message =
      std::string(file == nullptr ? "the recording" : file) + ": " + sqlite3_errmsg(database);
  if (sqlite3_errcode(database) == SQLITE_NOTADB) throw NotADatabase(message);
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

/// SQLite's words, and the system's where it has some.
std::string reason(sqlite3* database) {
  if (database == nullptr) return "not enough memory";
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
  check(sqlite3_bind_blob64(statement_.get(), place, bytes.data(), bytes.size(), SQLITE_STATIC));
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

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }

double Statement::real(int column) const { return sqlite3_column_double(statement_.get(), column); }

std::string Statement::text(int column) const {
  const unsigned char* text = sqlite3_column_text(statement_.get(), column);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  return text == nullptr ? std::string() : std::string(text, text + size);
}

Bytes Statement::bytes(int column) const {
  const auto* data = static_cast<const std::uint8_t*>(sqlite3_column_blob(statement_.get(), column));
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  return data == nullptr ? Bytes() : Bytes(data, data + size);
}

void Database::Close::operator()(sqlite3* database) const { sqlite3_close_v2(database); }

Database::Database(const std::filesystem::path& path, const std::string& name, int flags, const char* vfs) {
  sqlite3* database = nullptr;
  const int result = sqlite3_open_v2(name.c_str(), &database, flags, vfs);
  database_.reset(database);
  if (result != SQLITE_OK) throw std::runtime_error("cannot open " + path.string() + ": " + reason(database));
  sqlite3_busy_timeout(database, kPatience);
}

Database Database::create(const std::filesystem::path& path) {
  auto lock = std::make_unique<const WriterLock>(path);
  if (std::filesystem::exists(path)) throw std::runtime_error(path.string() + " exists already");
  Database database(path, plain_name(path), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  database.lock_ = std::move(lock);
  // Each page is written twice, by a call of its own: blocks and keyframes fill large ones. The log is folded
  // into the file every 1,000 pages: each time the writer waits for the disk.
  database.execute(
      "PRAGMA page_size = 16384; PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL; "
      "PRAGMA wal_autocheckpoint = 1000;");
  return database;
}

Database Database::open(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path))
    throw std::runtime_error("there is no recording " + path.string());
  if (!is_being_written(path)) return open_at_rest(path);
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
  // So SQLite keeps the index of the log in memory. It must not clean up: somebody else may read the same.
  sqlite3_db_config(database.database_.get(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
  database.execute("PRAGMA locking_mode = EXCLUSIVE");
  return database;
}

void Database::execute(const std::string& sql) {
  if (sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
    fail(database_.get());
}

Statement Database::prepare(std::string_view sql) const { return {database_.get(), sql}; }

std::int64_t Database::ask(std::string_view sql) const {
  Statement statement = prepare(sql);
  return statement.step() ? statement.integer(0) : 0;
}

/// Without a log beside it the file can be copied as it is. SQLite keeps the log for those who read, and lets
/// them go on when it is emptied.
void Database::close() {
  const int result = sqlite3_exec(database_.get(), "PRAGMA journal_mode = DELETE", nullptr, nullptr, nullptr);
  if (result != SQLITE_OK && result != SQLITE_BUSY) fail(database_.get());
  if (result == SQLITE_BUSY && ask("PRAGMA wal_checkpoint(TRUNCATE)") != 0)
    throw std::runtime_error(
        std::string(sqlite3_db_filename(database_.get(), "main")) +
        ": somebody reads it and does not come to an end; it needs its log, which ends with -wal");
  database_.reset();
  lock_.reset();
}

}  // namespace kerf
