#include "core/world/slots.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace kerf::test {
namespace {

Handle take(Slots& slots) {
  const Handle handle = slots.peek();
  slots.take();
  return handle;
}

TEST(Slots, IndicesAreDenseWhateverComesAndGoes) {
  Slots slots;
  std::vector<Handle> alive;
  for (int k = 0; k < 10; ++k) alive.push_back(take(slots));
  for (int round = 0; round < 1000; ++round) {
    slots.release(alive[static_cast<std::size_t>(round % 10)]);
    slots.finish_step();
    alive[static_cast<std::size_t>(round % 10)] = take(slots);
  }
  EXPECT_EQ(slots.size(), 10U);
  EXPECT_EQ(slots.alive(), 10U);
}

TEST(Slots, AnIndexThatAStepSawIsGivenAfterTheNextStep) {
  Slots slots;
  const Handle first = take(slots);
  slots.finish_step();
  slots.release(first);
  const Handle second = take(slots);
  EXPECT_NE(second.index(), first.index());
  EXPECT_EQ(slots.handle(first.index()), first) << "its pairs are reported by it";
  slots.finish_step();
  const Handle third = take(slots);
  EXPECT_EQ(third.index(), first.index());
  EXPECT_NE(third, first);
}

TEST(Slots, ObjectsThatNoStepSawCostNoMemory) {
  Slots slots;
  std::set<Handle> given;
  for (int k = 0; k < 1000; ++k) {
    const Handle handle = take(slots);
    EXPECT_TRUE(given.insert(handle).second) << "a handle names two objects";
    slots.release(handle);
    EXPECT_FALSE(slots.contains(handle));
  }
  EXPECT_EQ(slots.size(), 1U);
}

TEST(Slots, NoOtherValueIsAHandle) {
  Slots slots(3);
  const Handle handle = take(slots);
  EXPECT_TRUE(slots.contains(handle));
  EXPECT_FALSE(slots.contains({}));
  EXPECT_FALSE(slots.contains({~handle.value}));
  EXPECT_FALSE(slots.contains(make_handle(handle.index(), handle.generation() + 1, 3)));
  EXPECT_FALSE(slots.contains(make_handle(handle.index(), handle.generation(), 4)));
  EXPECT_FALSE(slots.contains(make_handle(handle.index() + 1, handle.generation(), 3)));
  slots.release(handle);
  for (const std::uint64_t value : {handle.value, ~handle.value, std::uint64_t{0}, ~std::uint64_t{0}})
    EXPECT_FALSE(slots.contains({value}));
}

TEST(Slots, AnIndexIsGivenUpAfterItsLastGeneration) {
  const Handle last = make_handle(0, Handle::kMaxGeneration, 0);
  Slots slots;
  ASSERT_TRUE(slots.restore({last.value}, {}));
  slots.release(last);
  slots.finish_step();
  EXPECT_EQ(take(slots).index(), 1U);
}

TEST(Slots, ContradictingNumbersAreRefused) {
  const std::uint64_t alive = make_handle(0, 1, 0).value;
  const std::uint64_t dead = ~make_handle(1, 1, 0).value;
  Slots slots;
  EXPECT_TRUE(slots.restore({alive, dead}, {1}));
  EXPECT_FALSE(slots.restore({alive, dead}, {})) << "a dead index that is not free";
  EXPECT_FALSE(slots.restore({alive, dead}, {0})) << "an index that is free and alive";
  EXPECT_FALSE(slots.restore({alive, dead}, {1, 1}));
  EXPECT_FALSE(slots.restore({alive, dead}, {2}));
  EXPECT_FALSE(slots.restore({make_handle(1, 1, 0).value}, {})) << "of another index";
  EXPECT_FALSE(slots.restore({make_handle(0, 0, 0).value}, {})) << "of no generation";
  EXPECT_FALSE(slots.restore({make_handle(0, 1, 9).value}, {})) << "of another world";
  EXPECT_EQ(slots.size(), 2U) << "a refusal changes nothing";
}

}  // namespace
}  // namespace kerf::test
