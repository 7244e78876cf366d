#include <gmock/gmock.h>

#include "tests/viz/debugger/timeline_driver.h"

namespace kerf::test {
namespace {

TEST(TimelineTools, KeysAndButtonsGoToEachKindOfMoment) {
  TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
key 3
expect deed ~ split
remember first event
key 3
expect event != $first
key shift+3
expect event == $first
key shift+3
expect event == $first
expect message == "nothing of the kind 'split' further back"
key 1
expect kind == balance
expect deed ~ balance
key n
expect deed ~ balance
remember balance event
click "next of kind"
expect event != $balance
click "previous of kind"
expect event == $balance
click kind
click "kind placed"
expect kind == placed
key n
expect event != $balance
key shift+n
expect event != $balance
key K
expect kind == phase
key n
expect deed ~ phase
key Home
key B
key End
key B
key shift+0
expect step == 0
key 0
expect step == 60
key 9
expect message == "nothing of the kind 'alarm' further on"
)"),
            "");
}

TEST(TimelineTools, ARangeIsSelectedByMouseAndKeysAndHasFigures) {
  TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
expect range == none
drag scrubber@0.2,0.5 scrubber@0.5,0.5 shift
expect step == 0
expect range ~ "18 steps: "
expect range ~ "steps 13 to 30"
drag scrubber@0.5,0.5 scrubber@0.2,0.5 shift
expect range ~ "18 steps: "
expect range ~ "steps 13 to 30"
key Escape
expect range == none
click "go to"
type 10
key Enter
key S
expect range ~ "1 step: "
expect range ~ "steps 10 to 10"
key shift+.
key shift+.
key E
expect range ~ "3 steps: "
expect range ~ "steps 10 to 12"
key shift+.
key S
expect range ~ "1 step: "
expect range ~ "steps 13 to 13"
key shift+,
key shift+,
key E
expect range ~ "1 step: "
expect range ~ "steps 11 to 11"
key S
key End
key E
key R
expect lanes_from == 10
expect lanes_to == 60
key R
expect lanes_from == 0
click "show range"
expect lanes_from == 10
click "drop range"
expect range == none
key R
expect lanes_from == 0
)"),
            "");
}

TEST(TimelineTools, PlayingLoopsInTheRange) {
  TimelineDriver driver;
  EXPECT_EQ(driver.play(R"(
key L
expect loops == no
expect message ~ "select a range first"
drag scrubber@0.2,0.5 scrubber@0.25,0.5 shift
expect range ~ "steps 13 to 15"
key L
expect loops == yes
key Space
wait 2      # 25 steps and 60 frames a second: it comes from before the range
expect step == 13
wait 12
expect step == 15
wait 2
expect step == 13
click loop
wait 30
expect step > 15
)"),
            "");
}

}  // namespace
}  // namespace kerf::test
