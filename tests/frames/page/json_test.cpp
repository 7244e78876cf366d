#include "frames/page/json.h"

#include <gtest/gtest.h>

namespace kerf::test {
namespace {

/// The name of a file may have any bytes; what was measured of it is not lost for that.
TEST(JsonText, ReplacesBytesThatAreNoUtf8) {
  const Json json{{"file", "bad\xff.kerf"}};
  EXPECT_EQ(json_text(json, -1), "{\"file\":\"bad\xef\xbf\xbd.kerf\"}");
}

}  // namespace
}  // namespace kerf::test
