#include "tests/images/film_flicker.h"

#include <cstdio>
#include <exception>

// kerf_film_flicker FOLDER...: prints, as Markdown, what flickers in films that `kerf render --ids` has
// drawn: the table of docs/RENDERING.md.
namespace kerf {
namespace {

void print_row(const std::filesystem::path& folder) {
  const test::FilmFlicker found = test::measure_flicker(folder);
  const auto share = [](std::uint64_t part, std::uint64_t all) {
    return all == 0 ? 0.0 : 100 * static_cast<double>(part) / static_cast<double>(all);
  };
  const auto life = [&](double at) {
    if (found.lives.empty()) return 0U;
    return found.lives[static_cast<std::size_t>(at * static_cast<double>(found.lives.size() - 1))];
  };
  std::printf("| %s | %u | %.3f %% of %llu | %llu | %u | %u | %u / %u / %u of %zu | %u of %u | %.2f %% |\n",
              folder.filename().c_str(), found.frames, share(found.unexplained, found.changed),
              static_cast<unsigned long long>(found.changed),
              static_cast<unsigned long long>(found.most_unexplained), found.scale_changes,
              found.view_changes, life(0), life(0.1), life(0.5), found.lives.size(), found.label_jumps,
              found.labels, share(found.blinking_pairs, found.pairs));
}

}  // namespace
}  // namespace kerf

int main(int argc, char** argv) {
  std::printf(
      "| film | frames | changes without cause | most in a frame | scale changes | view changes | operators' "
      "frames: "
      "least / a tenth / half | labels that jump | pairs that blink "
      "|\n|---|---:|---:|---:|---:|---:|---|---:|---:|\n");
  try {
    for (int i = 1; i < argc; ++i) kerf::print_row(argv[i]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
