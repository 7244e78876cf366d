#include <gtest/gtest.h>

#include <string>

#include "core/c/kerf.h"

namespace kerf::test {
namespace {

TEST(CInterface, EachStatusHasAText) {
  for (kerf_status status = -3; status < 80; ++status) {
    const char* const sentence = kerf_status_text(status);
    ASSERT_NE(sentence, nullptr);
    const bool is_known = (status >= KERF_OK && status <= KERF_DAMAGED) ||
                          (status >= KERF_NULL_ARGUMENT && status <= KERF_BAD_QUERY);
    EXPECT_EQ(std::string(sentence) != "no status of Kerf's", is_known) << status;
  }
  EXPECT_EQ(std::string(kerf_version()).find("0."), 0U);
}

}  // namespace
}  // namespace kerf::test
