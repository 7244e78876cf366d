#include "core/base/config.h"

#include <gmock/gmock.h>

#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include "tests/support/config_of.h"

namespace kerf::test {
namespace {

using testing::HasSubstr;

/// The message with which `work` throws std::invalid_argument; empty if it does not.
template <class Work>
std::string complaint(Work work) {
  try {
    work();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// A value other than the default, for each parameter.
std::string other_value(const ConfigField& field) {
  const std::string now = get(Config{}, field.name);
  if (field.maximum == 1 && field.minimum == 0) return now == "1" ? "0" : "1";
  if (field.name == "max_threshold") return "250";
  if (field.name == "min_threshold") return "5";
  return now == "7" ? "8" : "7";
}

TEST(ConfigFields, NameEveryParameterOnceWithARangeAndAMeaning) {
  std::set<std::string_view> names;
  for (const ConfigField& field : config_fields()) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    EXPECT_LT(field.minimum, field.maximum) << field.name;
    EXPECT_FALSE(field.meaning.empty()) << field.name;
  }
  EXPECT_EQ(names.size(), 33U);
}

TEST(ConfigFields, EachIsSetReadAndWrittenByName) {
  for (const ConfigField& field : config_fields()) {
    Config config;
    const std::string value = other_value(field);
    set(config, field.name, value);
    EXPECT_EQ(get(config, field.name), value) << field.name;
    EXPECT_NE(get(Config{}, field.name), value) << field.name;
    for (const ConfigField& another : config_fields()) {
      if (another.name == field.name) continue;
      EXPECT_EQ(get(config, another.name), get(Config{}, another.name)) << field.name << " " << another.name;
    }
    Config copy;
    kerf::apply(copy, to_string(config));
    EXPECT_EQ(to_string(copy), to_string(config)) << field.name;
    EXPECT_EQ(get(copy, field.name), value) << field.name;
  }
}

TEST(ConfigFields, TakeBothEndsOfTheirRangeAndNothingBeyond) {
  for (const ConfigField& field : config_fields()) {
    const std::string name(field.name);
    const bool is_integer = name != "seed" && get(Config{}, name).find('.') == std::string::npos &&
                            name != "candidate_factor" && name != "max_entries" && name != "free_directions";
    const auto text = [&](double x) {
      return is_integer ? std::to_string(static_cast<long long>(x)) : std::to_string(x);
    };
    if (name == "free_directions" || name == "seed") continue;  // no numbers beyond can be written
    Config config;
    set(config, name, text(field.minimum));
    set(config, name, text(field.maximum));
    for (const double beyond : {field.minimum - 1, field.maximum + 1}) {
      const std::string before = to_string(config);
      EXPECT_THAT(complaint([&] { set(config, name, text(beyond)); }), HasSubstr(name)) << beyond;
      EXPECT_EQ(to_string(config), before);
    }
  }
}

TEST(ConfigFields, RefuseWhatIsNotANumber) {
  for (const ConfigField& field : config_fields()) {
    for (const char* bad : {"", "x", "1x", " 1", "nan", "0x10", "--1", "1e999"}) {
      Config config;
      const std::string message = complaint([&] { set(config, field.name, bad); });
      EXPECT_THAT(message, HasSubstr(std::string(field.name))) << "'" << bad << "'";
      EXPECT_THAT(message, HasSubstr("'" + std::string(bad) + "'"));
      EXPECT_EQ(to_string(config), to_string(Config{}));
    }
  }
}

TEST(ConfigFields, SayWhatTheyExpect) {
  Config config;
  const auto why = [&](const char* name, const char* value) {
    return complaint([&] { set(config, name, value); });
  };
  EXPECT_THAT(why("sample", "1"), HasSubstr("'1' is not a whole number from 2 to 1000000000"));
  EXPECT_THAT(why("sample", "2.5"), HasSubstr("'2.5' is not a whole number from 2 to 1000000000"));
  EXPECT_THAT(why("seed", "-1"), HasSubstr("is not a whole number from 0 to 18446744073709551615"));
  EXPECT_THAT(why("skin", "1001"), HasSubstr("'1001' is not a number from 0 to 1000"));
  EXPECT_THAT(why("split", "2"), HasSubstr("'2' is neither 0 nor 1"));
  EXPECT_THAT(why("skin", "1e-50"), HasSubstr("'1e-50' is too small for a float; 0 is the nearest"));
}

TEST(ConfigDefaults, AreThePapers) {
  const Config config;
  EXPECT_EQ(config.candidate_factor, 2.0F);
  EXPECT_EQ(config.min_balance, 0.5F);
  EXPECT_EQ(config.max_redundancy, 0.025F);
  EXPECT_EQ(config.min_threshold, 16U);
  EXPECT_EQ(config.max_threshold, 128U);
  EXPECT_EQ(config.event_capacity, 64U);
  EXPECT_EQ(config.budget_divisor, 16U);
  EXPECT_EQ(config.schedule_interval, 10U);
  EXPECT_TRUE(config.free_directions);
  EXPECT_NO_THROW(check(config));
}

TEST(ConfigNames, UnknownOnesAreRefusedWithThoseThatAreKnown) {
  Config config;
  for (const std::string& message : {complaint([&] { set(config, "min_ballance", "1"); }),
                                     complaint([&] { (void)get(config, "min_ballance"); }),
                                     complaint([&] { kerf::apply(config, "min_ballance=1"); })}) {
    EXPECT_THAT(message, HasSubstr("'min_ballance'"));
    EXPECT_THAT(message, HasSubstr(" min_balance "));
  }
}

TEST(ConfigValues, BoolsAreWordsOrDigits) {
  EXPECT_FALSE(config_of("free_directions=0").free_directions);
  EXPECT_FALSE(config_of("free_directions=false").free_directions);
  EXPECT_TRUE(config_of("free_directions=1").free_directions);
  EXPECT_TRUE(config_of("free_directions=true").free_directions);
  EXPECT_THROW(config_of("free_directions=2"), std::invalid_argument);
}

TEST(ConfigValues, EverySeedAndFloatSurvivesARoundTrip) {
  EXPECT_EQ(config_of("seed=18446744073709551615").seed, std::numeric_limits<std::uint64_t>::max());
  Config config;
  config.max_redundancy = 0.1F + 0.2F;
  EXPECT_EQ(config_of(to_string(config)).max_redundancy, config.max_redundancy);
}

TEST(ConfigAssignments, AreAllAppliedOrNone) {
  Config config;
  for (const char* bad : {"min_balance=0.9,nonsense=1", "min_balance=0.9,sample=1", "min_balance=0.9,sample",
                          "min_balance=0.9,,sample=9", ",min_balance=0.9", "min_balance=0.9,=3", "=",
                          "min_balance==1", "min_balance=0.9,", "min_balance=0.9,,", ","}) {
    EXPECT_THROW(kerf::apply(config, bad), std::invalid_argument) << bad;
    EXPECT_EQ(to_string(config), to_string(Config{})) << bad;
  }
  kerf::apply(config, "");
  EXPECT_EQ(to_string(config), to_string(Config{}));
  kerf::apply(config, "min_balance=0.9,sample=9");
  EXPECT_EQ(config.min_balance, 0.9F);
  EXPECT_EQ(config.sample, 9U);
}

TEST(ConfigAssignments, AnEmptyOneIsNamed) {
  Config config;
  for (const char* bad : {"sample=9,", ",sample=9", "sample=9,,seed=1", ","})
    EXPECT_THAT(complaint([&] { kerf::apply(config, bad); }),
                testing::AllOf(HasSubstr("'" + std::string(bad) + "'"), HasSubstr("empty item")));
}

TEST(ConfigAssignments, LaterOnesWin) { EXPECT_EQ(config_of("sample=9,sample=10").sample, 10U); }

TEST(ConfigAssignments, ThresholdsMustBeInOrderAtTheEndOnly) {
  EXPECT_THROW(config_of("min_threshold=200"), std::invalid_argument);
  EXPECT_EQ(config_of("min_threshold=200,max_threshold=300").min_threshold, 200U);
}

TEST(ConfigCheck, FindsValuesThatWereSetByHand) {
  Config config;
  config.max_height = 64;
  EXPECT_THAT(complaint([&] { check(config); }), HasSubstr("max_height"));
  config = {};
  config.min_balance = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(complaint([&] { check(config); }), HasSubstr("min_balance"));
  config = {};
  config.min_threshold = 129;
  EXPECT_THAT(complaint([&] { check(config); }), HasSubstr("min_threshold"));
}

}  // namespace
}  // namespace kerf::test
