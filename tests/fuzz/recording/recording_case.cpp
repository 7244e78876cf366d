#include <sqlite3.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "core/recording/recording_reader.h"
#include "core/replay/replayer.h"
#include "core/replay/verify.h"
#include "tests/fuzz/recording/recording_cases.h"
#include "tests/fuzz/tree/byte_reader.h"
#include "tests/support/recorded_crowd.h"
#include "tests/support/tampering.h"

namespace kerf::test {
namespace {

/// The recording, and a file in which it is changed again and again. Its pages are small: most of its tables
/// hold a few rows, and each case writes the file anew.
class Workbench {
 public:
  Workbench() {
    record_small(file_.path());
    file_.change("PRAGMA page_size = 512; VACUUM");
    std::ifstream stream(file_.path(), std::ios::binary);
    whole_ = {std::istreambuf_iterator<char>(stream), {}};
    for (const std::string& table : tables_of(file_.path()))
      if (const std::uint32_t rows = rows_of(file_.path(), table); rows > 0)
        for (const std::string& column : columns_of(file_.path(), table))
          values_.push_back({table, column, rows});
  }
  void restore() const { std::ofstream(file_.path(), std::ios::binary) << whole_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// A value; `row` of it is how many there are.
  [[nodiscard]] const std::vector<StoredValue>& values() const { return values_; }

 private:
  TemporaryRecording file_;
  std::filesystem::path path_ = file_.path();
  std::string whole_;
  std::vector<StoredValue> values_;
};

struct Close {
  void operator()(sqlite3* database) const { sqlite3_close(database); }
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};

/// Binds what the bytes say: a number, a text, some bytes or nothing.
void bind(sqlite3_stmt* statement, ByteReader& in) {
  std::string content;
  switch (in.byte() % 5) {
    case 0:
      sqlite3_bind_int64(statement, 1, std::int64_t{in.byte()} << in.byte() % 56);
      return;
    case 1:
      sqlite3_bind_int64(statement, 1, -std::int64_t{in.byte()});
      return;
    case 2:
      sqlite3_bind_double(statement, 1, static_cast<double>(in.any_scalar()));
      return;
    case 3:
      return;  // NULL
    default:
      for (std::uint8_t left = in.byte(); left > 0 && !in.is_spent(); --left)
        content.push_back(static_cast<char>(in.byte()));
      sqlite3_bind_blob(statement, 1, content.data(), static_cast<int>(content.size()), SQLITE_TRANSIENT);
  }
}

/// All values of all tables.
std::string content_of(const std::filesystem::path& path) {
  sqlite3* opened = nullptr;
  sqlite3_open(path.c_str(), &opened);
  const std::unique_ptr<sqlite3, Close> database(opened);
  std::string content;
  const auto add = [](void* text, int count, char** values, char** /*names*/) {
    for (int k = 0; k < count; ++k) static_cast<std::string*>(text)->append(values[k]).push_back('\n');
    return 0;
  };
  for (const std::string& table : tables_of(path)) {
    std::string values;
    for (const std::string& column : columns_of(path, table))
      values += (values.empty() ? "quote(" : ", quote(") + column + ")";
    content += table + '\n';
    sqlite3_exec(opened, ("SELECT " + values + " FROM " + table + " ORDER BY 1").c_str(), add, &content,
                 nullptr);
  }
  return content;
}

/// Changes up to four values; one change may undo another. False if none took place.
bool change(const Workbench& bench, ByteReader& in) {
  sqlite3* opened = nullptr;
  sqlite3_open(bench.path().c_str(), &opened);
  const std::unique_ptr<sqlite3, Close> database(opened);
  sqlite3_exec(opened, "PRAGMA synchronous = OFF; PRAGMA journal_mode = MEMORY; BEGIN", nullptr, nullptr,
               nullptr);
  int changed = 0;
  for (std::uint32_t left = 1 + in.below(4); left > 0; --left) {
    const StoredValue& value = bench.values()[in.below(static_cast<std::uint32_t>(bench.values().size()))];
    const std::string key = value.table == "meta" ? "key" : "rowid";
    const std::string sql = "UPDATE OR IGNORE " + value.table + " SET " + value.column + " = ?1 WHERE " +
                            key + " = (SELECT " + key + " FROM " + value.table +
                            " ORDER BY 1 LIMIT 1 OFFSET " + std::to_string(in.below(value.row)) + ") AND " +
                            value.column + " IS NOT ?1";
    sqlite3_stmt* prepared = nullptr;
    sqlite3_prepare_v2(opened, sql.c_str(), -1, &prepared, nullptr);
    const std::unique_ptr<sqlite3_stmt, Close> statement(prepared);
    bind(prepared, in);
    if (sqlite3_step(prepared) == SQLITE_DONE) changed += sqlite3_changes(opened);
  }
  sqlite3_exec(opened, "COMMIT", nullptr, nullptr, nullptr);
  return changed > 0;
}

/// Everything that the commands read.
void read_all(const std::filesystem::path& path) {
  const auto recording = std::make_shared<RecordingReader<2>>(path);
  for (std::uint32_t step = 1; step <= recording->steps(); ++step) {
    (void)recording->step(step);
    if (recording->their_step(step)) (void)recording->their_pairs(step);
  }
  (void)recording->operators();
  Replayer<2> replayer(recording);
  for (std::uint32_t step = recording->steps(); step > 0; --step) replayer.seek(step);
}

/// Whether `work` threw an error with a message.
template <class Work>
bool is_refused(Work work) {
  try {
    work();
    return false;
  } catch (const std::exception& error) {
    if (error.what()[0] == '\0') throw std::logic_error("an error without a message");
    return true;
  }
}

}  // namespace

std::string recording_case(CaseBytes bytes) {
  static const Workbench bench;
  ByteReader in(bytes);
  const bool is_forged = in.byte() % 2 == 1;
  bench.restore();
  if (!change(bench, in)) return "";
  if (!is_forged) {
    bool holds = false;
    const bool verified = !is_refused([&] { holds = verify(bench.path(), 4).holds(); });
    if (!verified || !holds) return "";
    const std::string changed = content_of(bench.path());
    bench.restore();
    return changed != content_of(bench.path()) ? "verify does not see the change" : "";
  }
  if (is_refused([&] { reseal(bench.path()); })) return "";
  (void)is_refused([&] { read_all(bench.path()); });
  (void)is_refused([&] { (void)verify(bench.path(), 4); });
  return "";
}

}  // namespace kerf::test
