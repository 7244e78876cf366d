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

}  // namespace
}  // namespace kerf::test
