#include <gtest/gtest.h>

#include "tests/fuzz/parsers/parser_cases.h"

namespace kerf::test {
namespace {

void replay(const char* target, std::string (*run)(CaseBytes)) {
  const std::vector<KeptCase> cases = corpus(KERF_SOURCE_DIR, target);
  EXPECT_GE(cases.size(), 5U);
  for (const KeptCase& kept : cases) EXPECT_EQ(run(kept.bytes), "") << target << "/" << kept.name;
}

TEST(ParserCorpus, ConfigurationsFindNothing) { replay("config", config_case); }
TEST(ParserCorpus, RequestsFindNothing) { replay("request", request_case); }
TEST(ParserCorpus, PicturesFindNothing) { replay("png", png_case); }
TEST(ParserCorpus, TablesFindNothing) { replay("csv", csv_case); }
TEST(ParserCorpus, ManifestsFindNothing) { replay("manifest", manifest_case); }
TEST(ParserCorpus, DrawListsFindNothing) { replay("draw_list", draw_list_case); }
TEST(ParserCorpus, ScriptsFindNothing) { replay("script", script_case); }
TEST(ParserCorpus, CameraPathsFindNothing) { replay("camera_path", camera_path_case); }

}  // namespace
}  // namespace kerf::test
