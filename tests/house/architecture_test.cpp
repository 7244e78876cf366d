#include "tests/house/architecture.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

namespace kerf::house {
namespace {

using testing::ElementsAre;
using testing::Pair;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Architecture, IsDrawnAsTheHouseIs) {
  const std::filesystem::path root = KERF_SOURCE_DIR;
  for (const auto& [file, text] : architecture_files(root))
    EXPECT_TRUE(text == text_of(root / file)) << file << " is out of date; run " KERF_BUILD_DIR
                                              << "/tests/kerf_architecture, look at it and commit it";
}

TEST(Architecture, EachPartOfTheFlowIsThere) {
  for (const std::string& file : data_flow_files())
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(KERF_SOURCE_DIR) / file)) << file;
}

TEST(Architecture, ArrowsThatAChainImpliesAreLeftOut) {
  const Edges chain = {{"c", {"b", "a"}}, {"b", {"a"}}, {"d", {"a", "c"}}};
  EXPECT_THAT(reduced(chain), ElementsAre(Pair("b", ElementsAre("a")), Pair("c", ElementsAre("b")),
                                          Pair("d", ElementsAre("c"))));
}

TEST(Architecture, AnIncludeChangesTheDrawing) {
  IncludeGraph graph;
  const std::string without = layers_svg(graph);
  graph.places["core/tree/"].insert("core/base/");
  const std::string with = layers_svg(graph);
  EXPECT_NE(with, without);
  graph.places["core/geometry/"].insert("core/base/");
  graph.places["core/tree/"].insert("core/geometry/");
  EXPECT_NE(layers_svg(graph), with);
}

TEST(Architecture, APartOfAPageIsReplacedAsAWhole) {
  const std::string page = "a\n<!-- made: it -->\nold\nold\n<!-- end -->\nb\n";
  EXPECT_EQ(with_part(page, "it", "new\n"), "a\n<!-- made: it -->\nnew\n<!-- end -->\nb\n");
  EXPECT_THROW(with_part(page, "other", "new\n"), std::runtime_error);
}

}  // namespace
}  // namespace kerf::house
