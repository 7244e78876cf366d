#include <stdexcept>

#include "core/bsp/bsp.h"
#include "core/bsp/state_codec.h"
#include "core/recording/compression.h"
#include "core/recording/keyframe_codec.h"
#include "core/replay/oracle.h"
#include "core/tree/validate.h"
#include "tests/fuzz/recording/recording_cases.h"
#include "tests/support/config_of.h"

namespace kerf::test {
namespace {

const Config& configuration() {
  static const Config config =
      config_of("directions=16,min_threshold=3,max_threshold=4,schedule_interval=2,max_redundancy=0.3");
  return config;
}

/// A tree goes on from the state: two steps, in which every other object moves.
std::string go_on(const BspState<2>& state) {
  Bsp<2> tree(configuration());
  tree.restore(state);
  for (int step = 0; step < 2; ++step) {
    for (std::uint32_t id = 0; id < state.latest.bound(); id += 2)
      if (tree.objects().is_placed({id})) (void)tree.move(ObjectId{id}, Box<2>{{0, 0}, {1, 1}});
    tree.step();
    const std::vector<Violation> violations = validate(tree.tree());
    if (!violations.empty()) return "a tree that went on from it is broken: " + violations.front().what;
    if (!judge_pairs(tree.pairs(), oracle_pairs(tree.objects())).is_exact()) return "its pairs are wrong";
  }
  return "";
}

}  // namespace

std::string keyframe_case(CaseBytes bytes) {
  try {
    const BspState<2> state = decode_keyframe<2>(compress(bytes, bytes.size()),
                                                 make_projector<2>(configuration(), VolumeKind::box));
    if (state.config != configuration()) return "";  // which a reader refuses
    const Bytes again = encode_state(state);
    if (decode_keyframe<2>(compress(again), state.tree.projector()).hash() != state.hash())
      return "written again, it is another";
    return go_on(state);
  } catch (const std::runtime_error& error) {
    return error.what()[0] == '\0' ? "an error without a message" : "";
  }
}

}  // namespace kerf::test
