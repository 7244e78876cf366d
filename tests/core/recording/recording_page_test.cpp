// docs/RECORDING.md says what is in a recording: its numbers and names are those of the program.
#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <regex>
#include <set>

#include "core/recording/schema.h"
#include "core/recording/their_structure.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

using Columns = std::map<std::string, std::set<std::string>>;

std::string page() {
  std::ifstream text(KERF_SOURCE_DIR "/docs/RECORDING.md");
  return {std::istreambuf_iterator<char>(text), {}};
}

std::set<std::string> code_in(const std::string& text) {
  static const std::regex kCode("`([^`]+)`");
  std::set<std::string> words;
  for (std::sregex_iterator match(text.begin(), text.end(), kCode), end; match != end; ++match)
    words.insert((*match)[1]);
  return words;
}

/// Rows of three cells, the first and the last of which name a table and its columns.
Columns tables_of_page() {
  static const std::regex kRow("\\n\\| `(\\w+)` \\| [^|\\n]+ \\| ([^|\\n]+) \\|");
  const std::string text = page();
  Columns tables;
  for (std::sregex_iterator row(text.begin(), text.end(), kRow), end; row != end; ++row)
    tables[(*row)[1]] = code_in((*row)[2]);
  return tables;
}

/// A recording without a step.
class EmptyRecording : public ::testing::Test {
 protected:
  EmptyRecording() {
    database_ = std::make_unique<Database>(Database::create(folder_.path() / "page.kerf"));
    RecordingInfo info;
    info.digits = TheirDigits{{2, 0, true}, {2, 0, true}};
    info.design.rounding.digits = 6;
    create_schema(*database_, info);
    write_structure<3>(*database_, 1, {});
  }
  [[nodiscard]] std::set<std::string> texts(const std::string& sql) const {
    std::set<std::string> found;
    Statement rows = database_->prepare(sql);
    while (rows.step()) found.insert(rows.text(0));
    return found;
  }

 private:
  test::TemporaryFolder folder_;
  std::unique_ptr<Database> database_;
};

TEST_F(EmptyRecording, HasTheTablesAndColumnsOfThePage) {
  Columns tables;
  for (const std::string& table : texts("SELECT name FROM sqlite_master WHERE type = 'table'"))
    tables[table] = texts("SELECT name FROM pragma_table_info('" + table + "')");
  EXPECT_EQ(tables_of_page(), tables);
}

TEST_F(EmptyRecording, HasTheKeysOfThePage) {
  const std::string text = page();
  std::smatch row;
  ASSERT_TRUE(std::regex_search(text, row, std::regex("\\n\\| `meta` \\| [^|\\n]*: ([^|\\n]+) \\|")));
  EXPECT_EQ(code_in(row[1]), texts("SELECT key FROM meta"));
}

TEST(RecordingPage, SaysTheVersionThatIsWritten) {
  EXPECT_THAT(page(), ::testing::HasSubstr("the schema's version, now " + std::to_string(kRecordingVersion) +
                                           ", as its user version, or " + std::to_string(kStructureVersion)));
  EXPECT_THAT(page(), ::testing::HasSubstr("or " + std::to_string(kRoundedVersion) +
                                           " if another engine's boxes were rounded"));
}

}  // namespace
}  // namespace kerf
