// Queries on the boxes of every hard case, in each kind of volume, after each of its steps:
// HardQueries/2D.box and so on. A query is about the boxes of the objects, whatever the volumes in them.

#include "core/bsp/bsp.h"
#include "core/spatial/spatial_index.h"
#include "core/spatial/tree_walk.h"
#include "tests/hard/cases.h"
#include "tests/hard/feed.h"
#include "tests/support/dimensions.h"
#include "tests/support/query_judge.h"

namespace kerf::test {
namespace {

template <class Param>
class HardQueries : public testing::Test {};
TYPED_TEST_SUITE(HardQueries, Dimensions, DimensionNames);

/// So many queries of each kind are asked in a case.
constexpr std::uint32_t kRounds = 24;

template <int D>
void play(const HardCase& hard_case, VolumeKind kind) {
  const Script<D> script = make_script<D>(hard_case, Size::test);
  Bsp<D> bsp(Config{}, kind);
  SpatialIndex<D> index;
  const std::size_t every = script.size() / 6 + 1;
  std::size_t step = 0;
  for (const ScriptStep<D>& asked : script) {
    for (const Request<D>& request : asked.requests) (void)ask(bsp, request, Feed::posed);
    bsp.step();
    if (++step % every != 0 && step != script.size()) continue;
    index.update(bsp.objects());
    TreeWalk<D> walk(bsp.tree(), bsp.objects());
    ASSERT_EQ(judge_queries<D>(bsp.objects(), index, &walk, kRounds / 6, step), "")
        << hard_case.id << " " << hard_case.name << ", step " << step;
  }
}

TYPED_TEST(HardQueries, AreExactOnEveryCase) {
  constexpr int kD = TypeParam::value;
  for (const HardCase& hard_case : hard_cases()) {
    if (hard_case.flush_to_zero) continue;
    play<kD>(hard_case, VolumeKind::box);
  }
}

TYPED_TEST(HardQueries, AreExactForEveryVolume) {
  constexpr int kD = TypeParam::value;
  for (const HardCase& hard_case : hard_cases())
    if (hard_case.id.starts_with("V"))
      for (const VolumeKind kind : volume_kinds<kD>()) play<kD>(hard_case, kind);
}

}  // namespace
}  // namespace kerf::test
