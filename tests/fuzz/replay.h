#pragma once

#include <gtest/gtest.h>

#include "tests/fuzz/corpus.h"

namespace kerf::test {

/// Of a target there are `least` kept cases or more, and none of them finds anything.
inline void replay(const char* target, std::string (*run)(CaseBytes), std::size_t least) {
  const std::vector<KeptCase> cases = corpus(KERF_SOURCE_DIR, target);
  EXPECT_GE(cases.size(), least);
  for (const KeptCase& kept : cases) EXPECT_EQ(run(kept.bytes), "") << target << "/" << kept.name;
}

}  // namespace kerf::test
