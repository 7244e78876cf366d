#include "sims3d/ode_library.h"

#include <gmock/gmock.h>

#include <optional>
#include <stdexcept>

namespace kerf {
namespace {

TEST(OdeLibrary, ErrorsOfOdeBecomeExceptions) {
  const OdeLibrary library;
  try {
    dError(7, "no more %s", "springs");
    FAIL() << "dError returned";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "ODE reports error 7: no more springs");
  }
  EXPECT_THROW(dDebug(1, "assertion"), std::runtime_error);
}

TEST(OdeLibrary, StaysOpenUntilTheLastUserIsGone) {
  std::optional<OdeLibrary> first(std::in_place);
  std::optional<OdeLibrary> second(std::in_place);
  first.reset();
  EXPECT_NE(dGetErrorHandler(), nullptr);
  second.reset();
  EXPECT_EQ(dGetErrorHandler(), nullptr);
  first.emplace();
  EXPECT_NE(dGetErrorHandler(), nullptr);
}

}  // namespace
}  // namespace kerf
