#include <chrono>

#include "core/recording/chain.h"
#include "core/recording/recording_info.h"
#include "frames/sequence/sequence.h"
#include "frames/study/measure.h"

namespace kerf {

Figures measure(const FramesCell& cell, const std::filesystem::path& folder, Replace replace) {
  RenderTexts texts = cell.texts;
  texts.out = folder;
  texts.resume = replace == Replace::nothing;
  texts.overwrite = !texts.resume;
  const auto start = std::chrono::steady_clock::now();
  render_sequence(parse_recording_request(texts));
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  return {counts_of(read_manifest(folder)), {{"total_ms", taken.count()}}};
}

Json counts_of(const Manifest& manifest) {
  std::uint64_t hash = 0;
  for (const FrameRecord& frame : manifest.frames) hash = hash_words({&frame.pixel_hash, 1}, hash);
  return {{"frames", manifest.frames.size()}, {"pixels_hash", to_hex(hash)}};
}

}  // namespace kerf
