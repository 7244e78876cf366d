// Labels and colours of objects come back as they were written, and what is none is refused.

#include "core/recording/object_marks.h"

#include <gmock/gmock.h>

#include "core/recording/recording_reader.h"
#include "tests/support/recorded_crowd.h"
#include "tests/support/tampering.h"

namespace kerf {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Rgb, IsReadAsPeopleWriteIt) {
  EXPECT_EQ(parse_rgb("#1f77B4"), (Rgb{31, 119, 180}));
  EXPECT_EQ(parse_rgb("1f77b4"), (Rgb{31, 119, 180}));
  EXPECT_EQ(parse_rgb("#17b"), (Rgb{17, 119, 187}));
  for (const char* const text : {"", "#", "#12", "#1234", "#12345g", "#-12345", "red", "#1234567", "# 12345"})
    EXPECT_EQ(parse_rgb(text), std::nullopt) << text;
  EXPECT_EQ(to_string(Rgb{31, 9, 180}), "#1f09b4");
}

class ObjectMarksOfARun : public testing::Test {
 protected:
  ObjectMarksOfARun() {
    Bsp<2, EventLog> tree(test::busy_config());
    RecordingInfo info = test::info_of<2>(test::busy_config());
    marks_.set({0}, {"left wheel", Rgb{200, 10, 0}});
    marks_.set({2}, {"Right WHEEL", std::nullopt});
    marks_.set({7}, {"", Rgb{1, 2, 3}});
    info.marks = marks_;
    Recorder<2> recorder(tree, file_.path(), info);
    test::play_crowd<2>(recorder, 3, 3, [](std::uint32_t) {});
    recorder.finish();
  }
  [[nodiscard]] std::string refusal(const std::string& sql) const {
    file_.change(sql);
    try {
      test::reseal(file_.path());
      const RecordingReader<2> reader(file_.path());
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  test::TemporaryRecording file_;
  ObjectMarks marks_;
};

TEST_F(ObjectMarksOfARun, ComeBack) {
  const RecordingReader<2> reader(file_.path());
  EXPECT_EQ(reader.info().marks, marks_);
}

TEST_F(ObjectMarksOfARun, TitleObjectsAndFindThem) {
  EXPECT_EQ(marks_.title({0}, "object 0"), "object 0 left wheel");
  EXPECT_EQ(marks_.title({7}, "object 7"), "object 7");
  EXPECT_EQ(marks_.title({1}, "object 1"), "object 1");
  EXPECT_THAT(marks_.called("wheel"), ElementsAre(ObjectId{0}, ObjectId{2}));
  EXPECT_THAT(marks_.called("LEFT"), ElementsAre(ObjectId{0}));
  EXPECT_THAT(marks_.called("axle"), IsEmpty());
}

TEST_F(ObjectMarksOfARun, AChangeIsSeen) {
  file_.change("UPDATE object_marks SET label = 'front wheel' WHERE object = 0");
  EXPECT_THAT([&] { const RecordingReader<2> reader(file_.path()); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("not what was written")));
}

TEST_F(ObjectMarksOfARun, WhatIsNoneIsRefused) {
  EXPECT_THAT(refusal("UPDATE object_marks SET color = 'red' WHERE object = 0"), HasSubstr("colour 'red'"));
  EXPECT_THAT(refusal("UPDATE object_marks SET color = NULL, label = 'a' || char(10) WHERE object = 0"),
              HasSubstr("object 0 has a label that cannot be shown"));
  EXPECT_THAT(refusal("UPDATE object_marks SET label = 'a', object = -1 WHERE object = 0"),
              HasSubstr("object"));
}

}  // namespace
}  // namespace kerf
