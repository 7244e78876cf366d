// Every case of the list that is a matter of boxes and requests, in both dimensions and for each kind of
// volume: HardCases/2D_box.V4_PointsAndFlatPlates and so on. Each step's pairs are compared with those of an
// oracle, each answer with the one expected, and the tree is validated.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/hard/settings.h"

namespace kerf::test {
namespace {

template <int D>
class HardCaseTest : public testing::Test {
 public:
  HardCaseTest(const HardCase& hard_case, VolumeKind kind) : case_(hard_case), kind_(kind) {}

  void TestBody() override {  // NOLINT(readability-identifier-naming): GoogleTest's name
    const Script<D> script = make_script<D>(case_, Size::test);
    Truth truth;
    for (const Setting& setting : settings_for(case_, kind_)) {
      SCOPED_TRACE("config \"" + std::string(setting.config) + "\", " +
                   (setting.feed == Feed::posed ? "turned volumes" : "boxes"));
      if (truth.empty() || setting.feed != fed_) truth = find_truth(script, kind_, setting.feed);
      fed_ = setting.feed;
      Trial trial;
      play_kerf(script, truth, setting, trial);
      judge(trial, setting);
    }
  }

 private:
  void judge(const Trial& trial, const Setting& setting) const {
    EXPECT_EQ(trial.missed, 0U) << trial.note.data();
    EXPECT_EQ(trial.twice, 0U) << trial.note.data();
    EXPECT_EQ(trial.statuses, 0U) << trial.note.data();
    EXPECT_EQ(trial.violations, 0U) << trial.note.data();
    const bool turns_flushed = setting.flush_to_zero && setting.feed == Feed::posed;  // by the test itself
    EXPECT_TRUE(trial.extra == 0 || turns_flushed) << trial.note.data();
    EXPECT_LE(trial.height, kMaxHeight);
    const bool shows_it = case_.operates && setting.config == case_.config && setting.feed == Feed::boxes;
    EXPECT_TRUE(!shows_it || trial.operators[static_cast<std::size_t>(*case_.operates)] > 0)
        << to_string(*case_.operates) << " never acted";
  }

  const HardCase& case_;
  VolumeKind kind_;
  Feed fed_ = Feed::boxes;
};

/// "Denormals" of V6 becomes "V6_Denormals".
std::string test_name(const HardCase& hard_case) {
  return std::string(hard_case.id) + "_" + std::string(hard_case.name);
}

template <int D>
void register_cases() {
  for (const VolumeKind kind : volume_kinds<D>()) {
    std::string suite = "HardCases/" + std::to_string(D) + "D_" + std::string(to_string(kind));
    std::replace(suite.begin(), suite.end(), '-', '_');
    for (const HardCase& hard_case : hard_cases())
      testing::RegisterTest(
          suite.c_str(), test_name(hard_case).c_str(), nullptr, nullptr, __FILE__, __LINE__,
          [&hard_case, kind]() -> testing::Test* { return new HardCaseTest<D>(hard_case, kind); });
  }
}

const bool kRegistered = [] {
  register_cases<2>();
  register_cases<3>();
  return true;
}();

}  // namespace
}  // namespace kerf::test
