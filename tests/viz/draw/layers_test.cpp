#include "viz/draw/layers.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "tests/viz/message_of.h"

namespace kerf {
namespace {

TEST(LayerSet, ReadsListsAndChanges) {
  EXPECT_EQ(to_string(LayerSet::parse("pairs,objects")), "objects,pairs");
  EXPECT_EQ(LayerSet::parse("all"), LayerSet::all());
  EXPECT_EQ(LayerSet::parse("none"), LayerSet::none());
  EXPECT_EQ(LayerSet::parse("-legend"), LayerSet::all().with(Layer::legend, false));
  EXPECT_EQ(LayerSet::parse("+pairs", LayerSet::none()), LayerSet::none().with(Layer::pairs, true));
  EXPECT_EQ(to_string(LayerSet::parse("none,+leaves, caption")), "leaves,caption");
  EXPECT_EQ(to_string(LayerSet::parse("objects,-objects")), "none");
}

TEST(LayerSet, EverySetIsReadBackFromItsText) {
  for (unsigned bits = 0; bits < 1U << kLayerCount; ++bits) {
    LayerSet layers = LayerSet::none();
    for (int i = 0; i < kLayerCount; ++i) layers.set(static_cast<Layer>(i), (bits >> i & 1U) != 0);
    EXPECT_EQ(LayerSet::parse(to_string(layers)), layers) << to_string(layers);
  }
}

TEST(LayerSet, ErrorsListTheNames) {
  for (const char* text : {"", "shadows", "objects,", "objects,,pairs", "objects,all", "+", "Objects"}) {
    const std::string error = test::message_of<std::invalid_argument>([&] { (void)LayerSet::parse(text); });
    for (int i = 0; i < kLayerCount; ++i)
      EXPECT_THAT(error, testing::HasSubstr(std::string(to_string(static_cast<Layer>(i))))) << text;
  }
}

}  // namespace
}  // namespace kerf
