#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "frames/diff/frame_diff.h"
#include "frames/sequence/draw_list_file.h"
#include "tests/images/plants.h"
#include "tests/images/scene_still.h"
#include "tests/support/temporary_folder.h"
#include "viz/image/png.h"

// Prints, as Markdown, what several rules say of planted bugs and of harmless noise: the table of
// docs/IMAGE_DIFF.md. A rule is right if it objects to a bug and does not object to noise.
namespace kerf {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 960;
constexpr int kHeight = 540;

/// Share of pixels that pixelmatch with its threshold 0.1 calls different: a distance in YIQ (Kotsarenko and
/// Ramos 2010), without its exception for smooth edges.
double pixelmatch_share(const Image& a, const Image& b) {
  constexpr double kThreshold = 0.1;
  constexpr double kLargest = 35215;
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    const double r = static_cast<double>(a.rgba[i]) - b.rgba[i];
    const double g = static_cast<double>(a.rgba[i + 1]) - b.rgba[i + 1];
    const double bl = static_cast<double>(a.rgba[i + 2]) - b.rgba[i + 2];
    const double y = 0.29889531 * r + 0.58662247 * g + 0.11448223 * bl;
    const double in = 0.59597799 * r - 0.27417610 * g - 0.32180189 * bl;
    const double q = 0.21147017 * r - 0.52261711 * g + 0.31114694 * bl;
    different +=
        0.5053 * y * y + 0.299 * in * in + 0.1957 * q * q > kLargest * kThreshold * kThreshold ? 1 : 0;
  }
  return static_cast<double>(different) / (static_cast<double>(a.rgba.size()) / 4);
}

/// A verdict, marked where it is wrong.
std::string verdict(bool objects, bool is_bug) {
  const std::string word = objects ? "fails" : "passes";
  return objects == is_bug ? word : "**" + word + "**";
}

/// One row: what each rule says of a pair of pictures. `by_pixels`: exact pixels are asked for, too.
void print_row(const std::string& what, const FramePair& frame, bool is_bug, bool by_pixels) {
  const Image reference = read_png(frame.reference);
  const Image test = read_png(frame.test);
  const FrameDiff exact = diff_frame(frame, {DiffGate::exact});
  const FrameDiff ids = diff_frame(frame, {DiffGate::ids});
  const FlipSummary flip = exact.flip.value_or(FlipSummary{});
  const double share = static_cast<double>(exact.pixels.different) / (kWidth * kHeight);
  const double matched = pixelmatch_share(reference, test);
  std::printf("| %s | %.3f %% | %s | %.3f %% | %s | %.5f | %s | %s | %s | %.3f | %s |\n", what.c_str(),
              100 * share, verdict(share > 0.01, is_bug).c_str(), 100 * matched,
              verdict(matched > 0.001, is_bug).c_str(), flip.mean, verdict(flip.mean > 0.001, is_bug).c_str(),
              by_pixels ? verdict(!exact.same, is_bug).c_str() : "not asked",
              verdict(!ids.same, is_bug).c_str(), flip.max, verdict(flip.max > kFlipLimit, is_bug).c_str());
}

template <int D>
StoredIds draw(const test::SceneStill<D>& still, const fs::path& path, int samples,
               const Tamper& tamper = {}) {
  FrameOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.samples = samples;
  options.ids = true;
  FrameRenderer<D> renderer(options);
  renderer.set_tamper(tamper);
  write_png(path, renderer.render(still.input()));
  const StoredIds stored{renderer.ids(), renderer.rasterizer()};
  write_ids(path, stored);
  return stored;
}

/// Everything a tenth of a pixel aside, as a rasteriser might round it.
void nudge(std::span<Batch> batches) {
  for (Batch& batch : batches)
    for (Vertex& vertex : batch.vertices) vertex.x += 0.2F / kWidth * vertex.w;
}

std::string name(int dimension) { return dimension == 2 ? "buckets-2d" : "buckets"; }

template <int D>
void print_rows(const fs::path& folder, const fs::path& foreign) {
  const std::string suffix = D == 2 ? ", 2D" : ", 3D";
  const test::SceneStill<D> still(name(D));
  const FramePair frame{"", folder / "right.png", folder / "other.png"};
  const StoredIds right = draw(still, frame.reference, 4);
  for (const test::Plant plant : test::kPlants) {
    const Drawn victim = test::victim(plant, right.ids);
    draw(still, frame.test, 4, test::tamper(plant, victim, kWidth, kHeight));
    print_row(std::string(describe(plant)) + suffix, frame, true, true);
  }
  draw(still, frame.test, 4);
  print_row("drawn again" + suffix, frame, false, true);
  draw(still, frame.test, 4, [](std::span<Batch> batches, const DrawList&) { nudge(batches); });
  write_ids(frame.test, right);
  print_row("edges rounded 0.1 pixels aside" + suffix, frame, false, false);
  draw(still, folder / "jagged.png", 1);
  print_row("softpipe instead of llvmpipe" + suffix,
            {"", folder / "jagged.png", foreign / (name(D) + ".png")}, false, false);
}

int run(const std::vector<std::string>& arguments) {
  if (arguments.size() == 3 && arguments[1] == "--draw") {
    draw(test::SceneStill<2>(name(2)), fs::path(arguments[2]) / (name(2) + ".png"), 1);
    draw(test::SceneStill<3>(name(3)), fs::path(arguments[2]) / (name(3) + ".png"), 1);
    return 0;
  }
  const test::TemporaryFolder folder;
  const test::TemporaryFolder foreign;
  const std::string self = fs::read_symlink("/proc/self/exe");
  const std::string command =
      "GALLIUM_DRIVER=softpipe '" + self + "' --draw '" + foreign.path().string() + "'";
  if (std::system(command.c_str()) != 0) return 1;
  std::printf(
      "| picture | pixels that differ | at most 1 %% of them | pixelmatch 0.1 | at most 0.1 %% | FLIP mean | "
      "at "
      "most 0.001 | exact | ids | FLIP max | at most %.2f "
      "|\n|---|---:|---|---:|---|---:|---|---|---|---:|---|\n",
      kFlipLimit);
  print_rows<2>(folder.path(), foreign.path());
  print_rows<3>(folder.path(), foreign.path());
  return 0;
}

}  // namespace
}  // namespace kerf

int main(int argc, char** argv) { return kerf::run({argv, argv + argc}); }
