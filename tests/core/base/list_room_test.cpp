#include "core/base/list_room.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace kerf {
namespace {

std::vector<int> list_of(std::size_t count) {
  std::vector<int> list(count);
  std::iota(list.begin(), list.end(), 0);
  return list;
}

TEST(ListRoom, MakesASixteenthMoreThanAskedFor) {
  std::vector<int> list;
  make_list_room(list, 800);
  EXPECT_GE(list.capacity(), 850U);
  EXPECT_LE(list.capacity(), 870U);
  EXPECT_TRUE(list.empty());
}

TEST(ListRoom, KeepsItsMemoryWhereFewComeOrGo) {
  std::vector<int> list;
  make_list_room(list, 800);
  list.resize(800);
  const int* const memory = list.data();
  for (const std::size_t count : {850U, 800U, 700U, 600U}) {
    make_list_room(list, count);
    EXPECT_EQ(list.data(), memory) << count;
  }
}

TEST(ListRoom, GivesBackWhatManyLeft) {
  std::vector<int> list = list_of(1000);
  make_list_room(list, 100);
  EXPECT_LE(list.capacity(), 130U);
  EXPECT_EQ(list, list_of(100));
}

TEST(ListRoom, KeepsWhatIsThereWhenItGrows) {
  std::vector<int> list = list_of(100);
  make_list_room(list, 1000);
  EXPECT_GE(list.capacity(), 1000U);
  EXPECT_EQ(list, list_of(100));
}

TEST(ListRoom, GrowsByAnEighth) {
  std::vector<int> list = list_of(1000);
  list.shrink_to_fit();
  grow_list(list, 1000);
  EXPECT_EQ(list.capacity(), 1000U);
  grow_list(list, 1001);
  EXPECT_GE(list.capacity(), 1125U);
  EXPECT_LE(list.capacity(), 1150U);
  EXPECT_EQ(list, list_of(1000));
}

TEST(ListRoom, IsMadeForAListThatGetsItsElementsAtOnce) {
  std::vector<int> list = list_of(1000);
  list.shrink_to_fit();
  resize_list(list, 1001);
  EXPECT_EQ(list.size(), 1001U);
  EXPECT_LE(list.capacity(), 1150U) << "std::vector would get as much again";
  resize_list(list, 10);
  EXPECT_EQ(list, list_of(10));
}

}  // namespace
}  // namespace kerf
