#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "frames/catalog/scene_catalog.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(ScenesProgram, NamesAreUniqueAndEachFindsItsScene) {
  std::set<std::string> names;
  for (const CatalogScene& scene : scene_catalog()) {
    EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
    EXPECT_EQ(find_scene(scene.name).entry, scene.entry) << scene.name;
  }
  EXPECT_THAT(names, ::testing::IsSupersetOf({"buckets", "buckets-2d", "terrain", "pile"}));
}

TEST(ScenesProgram, PrintsALineForEachScene) {
  const RunOutcome outcome = run_kerf({"scenes"});
  EXPECT_EQ(outcome.exit, 0);
  EXPECT_EQ(outcome.err, "");
  for (const CatalogScene& scene : scene_catalog())
    EXPECT_THAT(outcome.out, HasSubstr("\n" + scene.name + " "));
  EXPECT_THAT(outcome.out, Not(HasSubstr("NEEDS")));
  EXPECT_THAT(run_kerf({"scenes", "--verbose"}).out, HasSubstr("NEEDS"));
}

TEST(ScenesProgram, PrintsJson) {
  const RunOutcome outcome = run_kerf({"scenes", "--json"});
  EXPECT_EQ(outcome.exit, 0);
  const auto list = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(list.size(), scene_catalog().size());
  for (const auto& scene : list) {
    EXPECT_EQ(find_scene(scene["name"].get<std::string>()).dimension(), scene["dimension"]);
    EXPECT_GT(scene["default_objects"], 0);
  }
}

}  // namespace
}  // namespace kerf::test
