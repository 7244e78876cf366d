#include "core/bsp/state_codec.h"

#include <gtest/gtest.h>

#include "core/bsp/bsp.h"
#include "tests/support/boxes.h"

namespace kerf::test {
namespace {

/// Of a tree whose only object has an id that a new tree refuses: another one was there when it came.
Bytes state_of_a_far_object(ObjectId far) {
  Bsp<2> tree;
  EXPECT_EQ(tree.insert({0}, slab<2>(0, 1), Mobility::moving), Status::ok);
  EXPECT_EQ(tree.insert(far, slab<2>(0, 1), Mobility::moving), Status::ok);
  EXPECT_EQ(tree.remove({0}), Status::ok);
  tree.step();
  return encode_state(tree.state());
}

TEST(StateCodec, IdsFarBeyondTheNumberOfObjectsStayTaken) {
  const ObjectId far{kFreeIds + 3};
  const Bytes bytes = state_of_a_far_object(far);
  const BspState<2> state =
      decode_state<2>(bytes, bytes.size(), make_projector<2>(Config{}, VolumeKind::box));
  EXPECT_TRUE(state.latest.is_placed(far));
  Bsp<2> again;
  again.restore(state);
  EXPECT_EQ(again.remove(far), Status::ok);
  again.step();
  EXPECT_EQ(again.insert(far, slab<2>(0, 1), Mobility::moving), Status::ok) << "there is room for it";
}

}  // namespace
}  // namespace kerf::test
