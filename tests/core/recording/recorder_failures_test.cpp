// What a recorder does that is misused, or that fails: what was committed before is read, and no more is
// written.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <memory>
#include <stdexcept>

#include "core/recording/recorder.h"
#include "core/recording/recording_reader.h"
#include "core/replay/verify.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/recorded_crowd.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// While it lives, no file can become longer than this.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : before_(signal(SIGXFSZ, SIG_IGN)) { set(bytes); }
  ~FullDisk() {
    set(RLIM_INFINITY);
    signal(SIGXFSZ, before_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  static void set(rlim_t bytes) {
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = std::min(bytes, limit.rlim_max);
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  void (*before_)(int);
};

template <int D>
Box<D> unit_box(float x) {
  Box<D> box;
  box.min = {};
  box.min[0] = x;
  for (int axis = 0; axis < D; ++axis) box.max[axis] = box.min[axis] + 1;
  return box;
}

template <class T>
class RecorderFailures : public testing::Test {
 protected:
  RecorderFailures() : tree_(test::busy_config()), info_(test::info_of<T::value>(tree_.config())) {}

  void expect_refused(const char* why) {
    const auto make = [&] { Recorder<T::value> recorder(tree_, file_.path(), info_); };
    EXPECT_THAT(make, ThrowsMessage<std::invalid_argument>(HasSubstr(why)));
    EXPECT_FALSE(std::filesystem::exists(file_.path())) << why;
  }
  /// Nothing can be asked of it, and what was committed is a recording. Returns how many steps it has.
  std::uint32_t expect_ended(std::unique_ptr<Recorder<T::value>> recorder) {
    const std::vector<std::function<void()>> calls = {
        [&] { (void)recorder->insert({500}, unit_box<T::value>(0), Mobility::moving); },
        [&] { (void)recorder->move({0}, unit_box<T::value>(1)); },
        [&] { (void)recorder->move_many({}, {}); },
        [&] { (void)recorder->remove({0}); },
        [&] { recorder->step(); },
        [&] { recorder->add_theirs(TheirChanges<T::value>{}); },
        [&] { recorder->finish(); }};
    const std::uint32_t steps = RecordingReader<T::value>(file_.path()).steps();
    const std::string why = "the recording ended with step " + std::to_string(steps) + ":";
    for (const auto& call : calls) EXPECT_THAT(call, ThrowsMessage<std::runtime_error>(HasSubstr(why)));
    recorder.reset();
    const Verdict verdict = verify(file_.path());
    EXPECT_TRUE(verdict.holds());
    EXPECT_EQ(verdict.steps, steps);
    return steps;
  }

  TemporaryRecording file_;
  Bsp<T::value, EventLog> tree_;
  RecordingInfo info_;
};
TYPED_TEST_SUITE(RecorderFailures, test::Dimensions, test::DimensionNames);

TYPED_TEST(RecorderFailures, WhatIsNotTheTreesIsRefusedBeforeThereIsAFile) {
  constexpr int kD = TypeParam::value;
  const RecordingInfo right = this->info_;
  this->info_.dimension = 5 - kD;
  this->expect_refused("another dimension");
  this->info_ = right;
  this->info_.volume = VolumeKind::sphere;
  this->expect_refused("other volumes");
  this->info_ = right;
  this->info_.config = tuned_config();
  this->expect_refused("another configuration");
  this->info_ = right;
  this->info_.decisions.push_back({5, Operator::split, ChosenPlane{100'000, 0}});
  this->expect_refused("there is no direction 100000");
  this->info_ = right;
  const Recorder<kD> recorder(this->tree_, this->file_.path(), this->info_);  // all that is right now
}

TYPED_TEST(RecorderFailures, OnlyANewTreeIsRecorded) {
  (void)this->tree_.insert({0}, unit_box<TypeParam::value>(0), Mobility::moving);
  this->expect_refused("a step or an object");
  (void)this->tree_.remove({0});
  this->expect_refused("a step or an object");
  this->tree_.step();
  this->expect_refused("a step or an object");
}

TYPED_TEST(RecorderFailures, TheTreeTakesNoStepWithoutIt) {
  constexpr int kD = TypeParam::value;
  Recorder<kD> recorder(this->tree_, this->file_.path(), this->info_);
  const auto step = [&] { recorder.step(); };
  test::play_crowd<kD>(recorder, 30, 1, [](std::uint32_t /*step*/) {});
  Config other = this->tree_.config();
  other.merge = false;
  this->tree_.set_config(other);
  EXPECT_THAT(step, ThrowsMessage<std::invalid_argument>(HasSubstr("another configuration")));
  this->tree_.set_config(this->info_.config);
  this->tree_.step();
  EXPECT_THAT(step, ThrowsMessage<std::invalid_argument>(HasSubstr("a step without its recorder")));
  recorder.finish();  // what it has is right
  const Verdict verdict = verify(this->file_.path());
  EXPECT_TRUE(verdict.holds());
  EXPECT_EQ(verdict.steps, 30U);
}

TYPED_TEST(RecorderFailures, AfterAnExceptionOfACallbackItEnds) {
  constexpr int kD = TypeParam::value;
  auto recorder = std::make_unique<Recorder<kD>>(this->tree_, this->file_.path(), this->info_);
  bool throws = false;
  recorder->show([&](ObjectId /*object*/) -> Appearance<kD> {
    if (throws) throw std::runtime_error("no shape yet");
    return {};
  });
  test::play_crowd<kD>(*recorder, 60, 1, [](std::uint32_t /*step*/) {});
  throws = true;
  (void)recorder->insert({900}, unit_box<kD>(0), Mobility::moving);
  const auto step = [&] { recorder->step(); };
  EXPECT_THAT(step, ThrowsMessage<std::runtime_error>(HasSubstr("no shape yet")));
  throws = false;
  EXPECT_GE(this->expect_ended(std::move(recorder)), 50U);
}

TYPED_TEST(RecorderFailures, AfterAFullDiskItEndsThoughThereIsRoomAgain) {
  constexpr int kD = TypeParam::value;
  auto recorder = std::make_unique<Recorder<kD>>(this->tree_, this->file_.path(), this->info_);
  const auto play = [&] { test::play_crowd<kD>(*recorder, 2'000, 1, [](std::uint32_t /*step*/) {}); };
  {
    const FullDisk disk(std::filesystem::file_size(this->file_.path().string() + "-wal") + 800'000);
    EXPECT_THROW(play(), std::runtime_error);
  }
  EXPECT_GE(this->expect_ended(std::move(recorder)), 25U);
}

TYPED_TEST(RecorderFailures, AFinishedRecordingTakesNothingMore) {
  constexpr int kD = TypeParam::value;
  auto recorder = std::make_unique<Recorder<kD>>(this->tree_, this->file_.path(), this->info_);
  test::play_crowd<kD>(*recorder, 30, 1, [](std::uint32_t /*step*/) {});
  recorder->finish();
  EXPECT_EQ(this->expect_ended(std::move(recorder)), 30U);
}

/// Whether the file was there before, and empty, or not.
TYPED_TEST(RecorderFailures, AFileThatCannotBeMadeLeavesNothing) {
  constexpr int kD = TypeParam::value;
  const std::filesystem::path path = this->file_.path();
  const auto make = [&] { Recorder<kD> recorder(this->tree_, path, this->info_); };
  for (const rlim_t room : {0, 1'000, 20'000, 60'000, 100'000}) {
    for (const bool is_there : {false, true}) {
      if (is_there) std::ofstream(path).close();
      {
        const FullDisk disk(room);
        EXPECT_THROW(make(), std::runtime_error) << room;
      }
      EXPECT_EQ(std::filesystem::exists(path), is_there) << room;
      for (const char* const ending : {"-wal", "-shm", "-lock"})
        EXPECT_FALSE(std::filesystem::exists(path.string() + ending)) << ending;
      EXPECT_NO_THROW(make()) << room;
      std::filesystem::remove(path);
    }
  }
}

}  // namespace
}  // namespace kerf::test
