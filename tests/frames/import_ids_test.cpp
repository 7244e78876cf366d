#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/frames/import_program.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

/// Objects and steps of so many digits that neighbours are the same double.
class ImportIds : public ImportProgram {};

TEST_F(ImportIds, ConditionsFindTheObjectThatIsAskedFor) {
  (void)imported("a", write("boxes.csv",
                            "step,object,min_x,max_x,min_y,max_y\n"
                            "1,9007199254740992,0,1,0,1\n2,9007199254740993,0,1,0,1\n"
                            "3,9007199254740994,0,1,0,1\n4,18446744073709551615,0,1,0,1\n"));
  EXPECT_THAT(stepped("a", "object==9007199254740992"), HasSubstr("step 1 "));
  EXPECT_THAT(stepped("a", "object==9007199254740993"), HasSubstr("step 2 "));
  EXPECT_THAT(stepped("a", "object>9007199254740993"), HasSubstr("step 3 "));
  EXPECT_THAT(stepped("a", "object==18446744073709551615"), HasSubstr("step 4 "));
  EXPECT_EQ(run_kerf({"step", path("a.kerf"), "--to", "object==18446744073709551614"}).exit, 1);
}

TEST_F(ImportIds, ConditionsFindTheStepThatIsAskedFor) {
  (void)imported("a", write("boxes.csv",
                            "step,object,min_x,max_x,min_y,max_y\n"
                            "9007199254740992,1,0,1,0,1\n9007199254740993,2,0,1,0,1\n"
                            "9007199254740994.5,3,0,1,0,1\n9223372036854775807,4,0,1,0,1\n"));
  for (const char* const step :
       {"9007199254740992", "9007199254740993", "9007199254740994.5", "9223372036854775807"})
    EXPECT_THAT(stepped("a", std::string("step==") + step), HasSubstr(std::string("step ") + step));
  EXPECT_THAT(stepped("a", "step>9007199254740992"), HasSubstr("step 9007199254740993"));
  EXPECT_THAT(stepped("a", "step>median(step)"), HasSubstr("step 9007199254740994.5"));
  EXPECT_EQ(run_kerf({"step", path("a.kerf"), "--to", "step==9007199254740994"}).exit, 1);
}

}  // namespace
}  // namespace kerf::test
