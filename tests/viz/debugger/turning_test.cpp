#include <gtest/gtest.h>

#include "core/bsp/bsp.h"
#include "core/recording/recorder.h"
#include "core/trace/trace.h"
#include "tests/support/recorded_crowd.h"
#include "viz/debugger/script.h"

namespace kerf {
namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;

/// Boxes that touch their neighbours, in a cube of so many in a row.
void record_cube(const std::filesystem::path& path, int row) {
  const Config config = test::busy_config();
  Bsp<3, EventLog> tree(config);
  Recorder<3> recorder(tree, path, test::info_of<3>(config, VolumeKind::box));
  std::uint32_t id = 0;
  for (int x = 0; x < row; ++x)
    for (int y = 0; y < row; ++y)
      for (int z = 0; z < row; ++z) {
        const Vector<3> least{{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)}};
        (void)recorder.insert(ObjectId{id++}, {least, least + Vector<3>{{1, 1, 1}}}, Mobility::moving);
      }
  recorder.step();
  recorder.finish();
}

/// A debugger whose scene the mouse drags to and fro, so that the camera stands where it stood.
class Turning {
 public:
  explicit Turning(int row) {
    record_cube(file_.path(), row);
    debugger_.emplace(*context_, open_run(file_.path()));
    debugger_->model().go(Position::end_of(1));
    input_.mouse_x = 500;
    input_.mouse_y = 300;
    frames(3);
  }

  void press() {
    input_.buttons[0] = true;
    frames(1);
    move(30);
    move(-30);
    frames(2);
  }
  void release() {
    input_.buttons[0] = false;
    frames(3);
  }
  Image picture() { return debugger_->picture(); }
  [[nodiscard]] std::size_t pairs() const { return debugger_->view().counts().pairs; }

 private:
  void frames(int count) {
    for (int k = 0; k < count; ++k) debugger_->frame(input_, kWidth, kHeight);
  }
  void move(float pixels) {
    input_.mouse_x += pixels;
    frames(1);
  }

  test::TemporaryRecording file_;
  std::unique_ptr<GlContext> context_ = make_offscreen_context();
  std::optional<Debugger> debugger_;
  DebuggerInput input_;
};

TEST(TurningTheCamera, DrawsManyObjectsWithLessDetailUntilItEnds) {
  Turning many(14);
  const Image before = many.picture();
  const std::size_t pairs = many.pairs();
  many.press();
  EXPECT_NE(many.picture().rgba, before.rgba);
  EXPECT_LT(many.pairs(), pairs);
  many.release();
  EXPECT_EQ(many.picture().rgba, before.rgba);
  EXPECT_EQ(many.pairs(), pairs);
}

TEST(TurningTheCamera, DrawsFewObjectsAsEver) {
  Turning few(5);
  const std::size_t pairs = few.pairs();
  few.press();
  EXPECT_EQ(few.pairs(), pairs);
}

/// The debugger in both dimensions, its camera moved by keys and the mouse.
class KeptCamera : public testing::TestWithParam<int> {
 protected:
  KeptCamera() {
    if (GetParam() == 2) test::record_crowd<2>(file_.path(), 12, test::busy_config());
    if (GetParam() == 3) test::record_crowd<3>(file_.path(), 12, test::busy_config());
    debugger_.emplace(*context_, open_run(file_.path()));
    play("key End\nkey v\ndrag view@0.3,0.3 view@0.5,0.5\nwheel 3\nhover 5,5\nwait 40");
  }
  void play(const std::string& script) {
    EXPECT_NO_THROW(ScriptPlayer(*debugger_, kWidth, kHeight, {}).play(parse_script(script)));
  }

  std::unique_ptr<GlContext> context_ = make_offscreen_context();
  test::TemporaryRecording file_;
  std::optional<Debugger> debugger_;
};

/// A direction that was wished for before the mouse turned the camera is not faced anew.
TEST_P(KeptCamera, GoesBackToWhereTheMouseTurnedIt) {
  const AnyCamera turned = debugger_->view().camera();
  play("key v\ndrag view@0.3,0.3 view@0.4,0.3\nwait 40");
  EXPECT_NE(debugger_->view().camera(), turned);
  play("key ctrl+z\nkey ctrl+z\nwait 2");
  EXPECT_EQ(debugger_->view().camera(), turned);
}

TEST_P(KeptCamera, StaysWhenTheRunIsChangedOver) {
  const AnyCamera camera = debugger_->view().camera();
  debugger_->model().compare_with(open_run(file_.path()));
  play("wait 1");
  debugger_->model().change_over();
  play("wait 1");
  EXPECT_EQ(debugger_->view().camera(), camera);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, KeptCamera, testing::Values(2, 3),
                         [](const auto& made) { return std::to_string(made.param) + "D"; });

}  // namespace
}  // namespace kerf
