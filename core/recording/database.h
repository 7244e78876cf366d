#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/recording/fresh_files.h"
#include "core/recording/writer_lock.h"

struct sqlite3;
struct sqlite3_stmt;

namespace kerf {

/// One SQL statement with places for values, numbered from 1. Throws std::runtime_error as Database does.
class Statement {
 public:
  Statement(sqlite3* database, std::string_view sql);

  Statement& bind(int place, std::int64_t value);
  Statement& bind(int place, double value);
  Statement& bind(int place, std::string_view text);
  /// The bytes must live until the statement is run.
  Statement& bind(int place, std::span<const std::uint8_t> bytes);

  /// True if there is a row to read; after the last row the statement can be bound and run again.
  bool step();
  /// Runs a statement that gives no rows.
  void run();
  /// Ends reading before the last row.
  void reset();
  /// All places are NULL again.
  void clear();
  /// The statement cannot be used afterwards; call it before the database is closed.
  void end() { statement_.reset(); }

  // Columns are numbered from 0. A value of another type or range than requested throws: SQLite stores values
  // of any type in any column.
  [[nodiscard]] bool is_null(int column) const;
  [[nodiscard]] std::int64_t integer(int column) const;
  /// A whole number from 0 to `most`.
  [[nodiscard]] std::uint64_t natural(int column, std::uint64_t most = INT64_MAX) const;
  [[nodiscard]] std::uint32_t small(int column) const;
  /// A finite number.
  [[nodiscard]] double real(int column) const;
  /// The same, or an infinity.
  [[nodiscard]] double real_or_infinite(int column) const;
  /// One that was a float.
  [[nodiscard]] float single(int column) const;
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] Bytes bytes(int column) const;
  /// Appends all values of the row, each with its type.
  void put_row(ByteWriter& out) const;

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  void check(int result) const;
  void expect(int column, int type, const char* what) const;
  [[noreturn]] void refuse(int column, const char* what) const;

  sqlite3* database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

/// A file is no SQLite database, or nothing is left of it that could be read.
class NotADatabase : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The disk is full, or takes nothing more for another reason. What was committed before is whole.
class CannotWrite : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An SQLite file. Everything throws std::runtime_error with the file and SQLite's reason. A path is a path:
/// "file:x?mode=memory" is a name like any other. Long statements, and many short ones, `poll()`; what that
/// throws comes out of them.
class Database {
 public:
  /// A new file, written ahead: others may read it meanwhile, and if the program is killed, everything
  /// committed remains. Throws if the file exists and is not empty, or if another process is writing one of
  /// that name (WriterLock). Unless `keep` is called, its files go away with it.
  static Database create(const std::filesystem::path& path);
  /// An existing file, read only. While it is being written, SQLite's locks let reader and writer work, and
  /// need a writable folder. A file without a writer is read with its log, if it has one, without a lock and
  /// without a trace: also from a read-only folder.
  ///
  /// Nothing in it is executed, and a statement throws when it has done more work than a file of that size
  /// can need.
  static Database open(const std::filesystem::path& path);
  /// An existing file whose writer was killed, to be ended in order by `close`.
  static Database open_to_end(const std::filesystem::path& path);

  /// A new file stays when this object goes.
  void keep() { files_->keep(); }
  /// Throws std::runtime_error if a file without a log is shorter or longer than its pages. `path`: its own.
  void check_size(const std::filesystem::path& path) const;

  void execute(const std::string& sql);
  [[nodiscard]] Statement prepare(std::string_view sql) const;
  /// The first column of the first row.
  [[nodiscard]] std::int64_t ask(std::string_view sql) const;
  /// Ends the work on a new file: then everything is in the file itself, even while it is being read.
  void close();

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  /// `vfs`: SQLite's name for how it reaches and locks files; null: as usual.
  Database(const std::filesystem::path& path, const std::string& name, int flags, const char* vfs = nullptr);
  static Database open_beside_writer(const std::filesystem::path& path);
  static Database open_at_rest(const std::filesystem::path& path);
  void look_for_journal(const std::filesystem::path& path);
  void trust_nothing(std::uint64_t size);

  /// The work left to the statement that was prepared last.
  struct Patience {
    std::uint64_t whole = UINT64_MAX;
    std::uint64_t left = UINT64_MAX;
  };
  static int go_on(void* patience);
  std::unique_ptr<Patience> patience_ = std::make_unique<Patience>();
  std::unique_ptr<const WriterLock> lock_;  ///< of a new file
  std::unique_ptr<FreshFiles> files_;       ///< the same; they outlive the connection
  std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace kerf
