#include "tests/soak/options.h"

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace kerf::test {
namespace {

[[noreturn]] void end_with_usage(const char* program) {
  std::fprintf(stderr, "usage: %s [--minutes M] [--seed S] [--json FILE] [--keep FOLDER]\n", program);
  std::exit(2);
}

template <class Number>
bool parse(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace

SoakOptions soak_options(int argc, char** argv) {
  SoakOptions options;
  for (int i = 1; i < argc; i += 2) {
    const std::string_view name = argv[i];
    if (i + 1 == argc) end_with_usage(argv[0]);
    const std::string_view value = argv[i + 1];
    bool good = true;
    if (name == "--minutes")
      good = parse(value, options.minutes) && options.minutes > 0;
    else if (name == "--seed")
      good = parse(value, options.seed);
    else if (name == "--json")
      options.json = value;
    else if (name == "--keep")
      options.keep = value;
    else
      good = false;
    if (!good) end_with_usage(argv[0]);
  }
  return options;
}

}  // namespace kerf::test
