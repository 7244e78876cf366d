#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/frames/import_program.h"

namespace kerf::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kHeading = "step,object,min_x,max_x,min_y,max_y\n";

/// Two engines' tables, of which objects and steps are those that are called the same.
class CompareImports : public ImportProgram {
 protected:
  [[nodiscard]] RunOutcome compared(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"compare", path("a.kerf"), path("b.kerf")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_kerf(arguments);
  }
};

/// Some boxes that move, of objects with these ids.
std::string moving(const std::vector<std::string>& ids) {
  std::string text = kHeading;
  for (int step = 1; step <= 12; ++step)
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const std::string from =
          std::to_string(static_cast<double>(k) + 0.1 * step * static_cast<double>(k % 3));
      const std::string to = std::to_string(static_cast<double>(k) + 2 + 0.1 * step);
      text += std::to_string(step) + "," + ids[k] + "," + from + "," + to + ",0,1\n";
    }
  return text;
}

/// Its number moved the numbers of all later objects: requests, events, trees and pairs differed.
TEST_F(CompareImports, AnObjectThatOnlyOneNamesIsNamed) {
  const std::string boxes = write("boxes.csv", moving({"-7", "9", "11", "12"}));
  const std::string pairs = "step,a,b\n1,-7,9\n1,9,11\n3,11,12\n";
  (void)imported("a", boxes, {"--pairs", write("a_pairs.csv", pairs)});
  (void)imported("b", boxes, {"--pairs", write("b_pairs.csv", pairs + "5,8,9\n")});
  const RunOutcome outcome = compared();
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("objects    only B names 8\n"), HasSubstr("requests   are the same\n"),
                    HasSubstr("events     are the same\n"), HasSubstr("trees      are the same\n"),
                    HasSubstr("pairs      are the same\n"),
                    HasSubstr("theirs     differ first in step 5\n  only B reported (8,9)\n"),
                    HasSubstr("verdicts   differ first in step 5\n"), Not(HasSubstr("only A"))));
  const auto json = nlohmann::json::parse(compared({"--json"}).out);
  EXPECT_EQ(json["b_only_objects"], nlohmann::json::array({"8"}));
  EXPECT_TRUE(json["first_different"]["requests"].is_null());
}

/// What differs is found where objects have other numbers, too.
TEST_F(CompareImports, WhatDiffersBesideAnObjectThatOnlyOneNamesIsFound) {
  const std::string text = moving({"-7", "9", "11", "12"});
  (void)imported("a", write("a.csv", text),
                 {"--pairs", write("a_pairs.csv", "step,a,b\n1,-7,9\n2,9,11\n9,-8,9\n")});
  std::string other = text;
  other.replace(other.find("\n4,9,") + 5, 1, "0");
  (void)imported("b", write("b.csv", other),
                 {"--pairs", write("b_pairs.csv", "step,a,b\n1,-7,9\n2,-7,11\n")});
  EXPECT_THAT(compared().out, AllOf(HasSubstr("objects    only A names -8\n"),
                                    HasSubstr("requests   differ first in step 4\n"),
                                    HasSubstr("trees      differ first in step 4\n"),
                                    HasSubstr("theirs     differ first in step 2\n  only A reported (9,11)\n"
                                              "  only B reported (-7,11)\n"),
                                    HasSubstr("verdicts   differ first in step 2\n")));
}

/// An object that is there in one of them only is a request of that one.
TEST_F(CompareImports, AnObjectThatIsThereInOneOnlyIsARequest) {
  (void)imported("a", write("a.csv", moving({"0", "1", "2"})));
  (void)imported("b", write("b.csv", moving({"0", "1", "2"}) + "12,5000000000,80,81,0,1\n"));
  EXPECT_THAT(compared().out, AllOf(HasSubstr("objects    only B names 5000000000\n"),
                                    HasSubstr("requests   differ first in step 12\n"),
                                    HasSubstr("trees      differ first in step 12\n"),
                                    HasSubstr("pairs      are the same\n")));
}

/// The second step of one was compared with the third of the other.
TEST_F(CompareImports, StepsAreThoseThatAreCalledTheSame) {
  const std::string boxes =
      write("boxes.csv", std::string(kHeading) + "1,0,0,2,0,1\n1,1,1,3,0,1\n1,2,2.5,4,0,1\n3,0,5,6,0,1\n");
  (void)imported("a", boxes,
                 {"--pairs", write("a.csv_pairs", "step,a,b\n1,0,1\n1,1,2\n2,0,1\n2,1,2\n3,1,2\n")});
  (void)imported("b", boxes, {"--pairs", write("b.csv_pairs", "step,a,b\n1,0,1\n1,1,2\n3,1,2\n")});
  const RunOutcome outcome = compared();
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("steps      only A has 2\n"),
                                 HasSubstr("theirs     are the same in the steps that both have\n"),
                                 HasSubstr("verdicts   are the same in the steps that both have\n"),
                                 HasSubstr("requests   are the same in the steps that both have\n"),
                                 Not(HasSubstr("reported"))));
}

}  // namespace
}  // namespace kerf::test
