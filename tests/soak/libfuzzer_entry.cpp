// What libFuzzer calls. KERF_FUZZ_CASE is the function of tests/fuzz/ that this program tries.

#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/fuzz/corpus.h"

namespace kerf::test {
std::string KERF_FUZZ_CASE(CaseBytes bytes);
}

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string finding = kerf::test::KERF_FUZZ_CASE({data, size});
  if (finding.empty()) return 0;
  std::fprintf(stderr, "finding: %s\n", finding.c_str());
  std::abort();
}
