#include "tests/house/architecture.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <regex>

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
  const std::filesystem::path root = KERF_SOURCE_DIR;
  const std::string drawing = text_of(root / "docs/images/data-flow.svg");
  const std::regex file(">([^<]*\\.h)<");
  const std::sregex_iterator first(drawing.begin(), drawing.end(), file);
  EXPECT_EQ(std::distance(first, {}), 10);
  for (auto part = first; part != std::sregex_iterator(); ++part)
    EXPECT_TRUE(std::filesystem::exists(root / (*part)[1].str())) << (*part)[1];
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
