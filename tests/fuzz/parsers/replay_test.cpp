#include "tests/fuzz/replay.h"

#include "tests/fuzz/parsers/parser_cases.h"

namespace kerf::test {
namespace {

TEST(ParserCorpus, ConfigurationsFindNothing) { replay("config", config_case, 5); }
TEST(ParserCorpus, RequestsFindNothing) { replay("request", request_case, 5); }
TEST(ParserCorpus, PicturesFindNothing) { replay("png", png_case, 5); }
TEST(ParserCorpus, TablesFindNothing) { replay("csv", csv_case, 5); }
TEST(ParserCorpus, ManifestsFindNothing) { replay("manifest", manifest_case, 5); }
TEST(ParserCorpus, DrawListsFindNothing) { replay("draw_list", draw_list_case, 5); }
TEST(ParserCorpus, ScriptsFindNothing) { replay("script", script_case, 5); }
TEST(ParserCorpus, CameraPathsFindNothing) { replay("camera_path", camera_path_case, 5); }

}  // namespace
}  // namespace kerf::test
