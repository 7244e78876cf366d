#include "tests/house/include_rules.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/house/project_files.h"
#include "tests/support/temporary_folder.h"

namespace kerf::house {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A folder with planted files that goes when the test ends.
class PlantedTree : public testing::Test {
 protected:
  void plant(const std::string& file, const std::string& text) {
    std::filesystem::create_directories((root_.path() / file).parent_path());
    std::ofstream(root_.path() / file) << text;
    files_.emplace_back(file);
  }

  [[nodiscard]] std::vector<std::string> violations() const {
    std::vector<std::string> found;
    for (const Violation& violation : check_includes(root_.path(), files_))
      found.push_back(to_string(violation));
    return found;
  }

 private:
  test::TemporaryFolder root_;
  std::vector<std::filesystem::path> files_;
};

TEST(IncludeRules, HoldInThisTree) {
  std::vector<std::string> found;
  for (const Violation& violation : check_includes(KERF_SOURCE_DIR, source_files()))
    found.push_back(to_string(violation));
  EXPECT_THAT(found, IsEmpty());
}

TEST(IncludeRules, SeeThisTree) {
  EXPECT_THAT(source_files(), testing::Contains(std::filesystem::path("core/base/ids.h")));
  EXPECT_THAT(source_files(), testing::Contains(std::filesystem::path("tests/house/include_rules.cpp")));
}

TEST_F(PlantedTree, AllowsWhatTheTableAllows) {
  plant("core/tree/a.h", "#include <vector>\n#include \"core/base/ids.h\"\n");
  plant("viz/draw/a.cpp",
        "#include <GL/gl.h>\n#include <imgui.h>\n#include <stb/stb_image.h>\n#include \"core/tree/a.h\"\n");
  plant("sims2d/a.cpp", "#include <box2d/box2d.h>\n#include \"core/a.h\"\n#include \"sims2d/a.h\"\n");
  plant("sims3d/a.cpp", "#include <ode/ode.h>\n#include \"core/a.h\"\n");
  plant("frames/commands/a.cpp", "#include <CLI/CLI.hpp>\n#include \"viz/a.h\"\n#include \"sims2d/a.h\"\n");
  plant("tests/a.cpp", "#include <gtest/gtest.h>\n#include <ode/ode.h>\n#include \"frames/a.h\"\n");
  EXPECT_THAT(violations(), IsEmpty());
}

TEST_F(PlantedTree, CoreSeesNoOtherRoomAndNoEngine) {
  plant("core/tree/a.h", "#pragma once\n\n#include \"viz/a.h\"\n#  include <box2d/box2d.h>\n");
  plant("core/tree/b.cpp",
        "#include <GL/gl.h>\n#include <ode/ode.h>\n#include <unistd.h>\n#include <imgui.h>\n");
  EXPECT_THAT(violations(), ElementsAre("core/tree/a.h:3: core must not include viz (viz/a.h)",
                                        "core/tree/a.h:4: core must not include Box2D (box2d/box2d.h)",
                                        "core/tree/b.cpp:1: core must not include GL (GL/gl.h)",
                                        "core/tree/b.cpp:2: core must not include ODE (ode/ode.h)",
                                        "core/tree/b.cpp:3: core must not include POSIX (unistd.h)",
                                        "core/tree/b.cpp:4: core must not include Dear ImGui (imgui.h)"));
}

TEST_F(PlantedTree, CoreKeepsXxHashAndIntrinsicsInTheirFiles) {
  plant("core/tree/hash.cpp", "#include \"core/tree/hash.h\"\n#include <xxhash.h>\n");
  plant("core/kernels/sweep_avx2.cpp", "#include <immintrin.h>\n");
  plant("core/tree/hash.h", "#include <xxhash.h>\n");
  plant("core/tree/split.cpp", "#include <immintrin.h>\n");
  EXPECT_THAT(violations(),
              ElementsAre("core/tree/hash.h:1: core must not include xxHash (xxhash.h)",
                          "core/tree/split.cpp:1: core must not include x86 intrinsics (immintrin.h)"));
}

TEST_F(PlantedTree, VizSeesNoSimulation) {
  plant("viz/a.cpp", "#include \"sims2d/a.h\"\n#include \"sims3d/a.h\"\n#include <box2d/b2_math.h>\n");
  EXPECT_THAT(violations(), ElementsAre("viz/a.cpp:1: viz must not include sims2d (sims2d/a.h)",
                                        "viz/a.cpp:2: viz must not include sims3d (sims3d/a.h)",
                                        "viz/a.cpp:3: viz must not include Box2D (box2d/b2_math.h)"));
}

TEST_F(PlantedTree, SimulationsSeeNeitherVizNorEachOther) {
  plant("sims2d/a.h", "#include \"viz/a.h\"\n#include \"sims3d/a.h\"\n#include <ode/ode.h>\n");
  plant("sims3d/a.h", "#include <GL/gl.h>\n#include \"sims2d/a.h\"\n#include <box2d/box2d.h>\n");
  EXPECT_THAT(violations(), ElementsAre("sims2d/a.h:1: sims2d must not include viz (viz/a.h)",
                                        "sims2d/a.h:2: sims2d must not include sims3d (sims3d/a.h)",
                                        "sims2d/a.h:3: sims2d must not include ODE (ode/ode.h)",
                                        "sims3d/a.h:1: sims3d must not include GL (GL/gl.h)",
                                        "sims3d/a.h:2: sims3d must not include sims2d (sims2d/a.h)",
                                        "sims3d/a.h:3: sims3d must not include Box2D (box2d/box2d.h)"));
}

TEST_F(PlantedTree, LayersOfARoomIncludeDownwardsOnly) {
  plant("core/kernels/a.h", "#pragma once\n#include \"core/base/ids.h\"\n#include \"core/tree/node.h\"\n");
  plant("core/tree/a.h", "#pragma once\n#include \"core/tree/node.h\"\n#include \"core/bsp/bsp.h\"\n");
  plant("viz/gl/a.h", "#pragma once\n#include \"viz/image/png.h\"\n#include \"viz/draw/color.h\"\n");
  plant("viz/debugger/model/a.h", "#pragma once\n#include \"viz/debugger/panels/panel.h\"\n");
  plant("viz/debugger/a.h", "#pragma once\n#include \"viz/debugger/panels/panel.h\"\n");
  plant("frames/page/a.h", "#pragma once\n#include \"frames/support/errors.h\"\n");
  plant("frames/bench/a.h", "#pragma once\n#include \"frames/report/trade.h\"\n");
  EXPECT_THAT(violations(),
              ElementsAre("core/kernels/a.h:3: core/kernels/ must not include core/tree/ (core/tree/node.h)",
                          "core/tree/a.h:3: core/tree/ must not include core/bsp/ (core/bsp/bsp.h)",
                          "viz/gl/a.h:3: viz/gl/ must not include viz/draw/ (viz/draw/color.h)",
                          "viz/debugger/model/a.h:2: viz/debugger/model/ must not include "
                          "viz/debugger/panels/ (viz/debugger/panels/panel.h)",
                          "frames/page/a.h:2: frames/page/ must not include frames/support/ "
                          "(frames/support/errors.h)",
                          "frames/bench/a.h:2: frames/bench/ must not include frames/report/ "
                          "(frames/report/trade.h)"));
}

TEST_F(PlantedTree, EachFileOfALayeredRoomLiesInALayer) {
  plant("core/a.h", "#pragma once\n#include \"core/base/ids.h\"\n");
  EXPECT_THAT(violations(), ElementsAre("core/a.h:2: core/a.h lies in no layer of its room"));
}

TEST_F(PlantedTree, NothingIncludesTests) {
  plant("frames/commands/a.cpp", "#include \"tests/support/a.h\"\n#include <gtest/gtest.h>\n");
  plant("core/tree/a.cpp", "#include \"tests/support/a.h\"\n");
  EXPECT_THAT(violations(),
              ElementsAre("frames/commands/a.cpp:1: frames must not include tests (tests/support/a.h)",
                          "frames/commands/a.cpp:2: frames must not include GoogleTest (gtest/gtest.h)",
                          "core/tree/a.cpp:1: core must not include tests (tests/support/a.h)"));
}

TEST_F(PlantedTree, PathsBeginAtTheRoot) {
  plant("core/tree/a.h", "#include \"node.h\"\n#include \"../ids.h\"\n#include <core/base/ids.h>\n");
  EXPECT_THAT(violations(),
              ElementsAre("core/tree/a.h:1: \"node.h\" is no header of the project, written from its root",
                          "core/tree/a.h:2: \"../ids.h\" is no header of the project, written from its root",
                          "core/tree/a.h:3: <core/base/ids.h> is the project's own and takes quotes"));
}

TEST_F(PlantedTree, ASourceIncludesItsOwnHeaderFirst) {
  plant("core/tree/a.h", "#pragma once\n");
  plant("core/tree/a.cpp", "#include <vector>\n#include \"core/tree/a.h\"\n");
  plant("core/tree/b.cpp", "#include <vector>\n#include \"core/tree/a.h\"\n");
  plant("core/tree/c.h", "#include <vector>\n");
  plant("core/tree/c.cpp", "#include \"core/tree/c.h\"\n#include \"core/tree/a.h\"\n");
  EXPECT_THAT(violations(),
              ElementsAre("core/tree/a.cpp:1: the source of core/tree/a.h must include it first"));
}

TEST_F(PlantedTree, UnknownLibrariesAndHiddenNamesAreReported) {
  plant("frames/a.cpp", "#include <curl/curl.h>\n#include HEADER\n");
  EXPECT_THAT(violations(),
              ElementsAre("frames/a.cpp:1: <curl/curl.h> belongs to no library that the house knows",
                          "frames/a.cpp:2: an #include names its header"));
}

}  // namespace
}  // namespace kerf::house
