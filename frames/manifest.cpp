#include "frames/manifest.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "frames/atomic_file.h"

namespace kerf {
namespace {

using Json = nlohmann::ordered_json;

std::string hex(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

/// Numbers and truth values as such, so that a reader need not parse text inside the JSON.
Json config_json(const Config& config) {
  Json json = Json::object();
  for (const ConfigField& field : config_fields()) {
    const std::string value = get(config, field.name);
    Json parsed = Json::parse(value, nullptr, false);
    json[std::string(field.name)] = parsed.is_discarded() ? Json(value) : parsed;
  }
  return json;
}

Json frame_json(const FrameRecord& frame) {
  Json operators = Json::object();
  for (int i = 0; i < kOperatorCount; ++i) {
    operators[std::string(to_string(static_cast<Operator>(i)))] =
        frame.operators[static_cast<std::size_t>(i)];
  }
  return {{"file", frame.file},
          {"step", frame.step},
          {"objects", frame.objects},
          {"pairs", frame.pairs},
          {"contacts", frame.contacts},
          {"height", frame.height},
          {"leaves", frame.leaves},
          {"entries", frame.entries},
          {"operators", operators},
          {"events", frame.events},
          {"state_hash", hex(frame.state_hash)},
          {"pixel_hash", hex(frame.pixel_hash)}};
}

}  // namespace

std::string to_json(const Manifest& manifest) {
  const StepRange& steps = manifest.steps;
  Json json = {{"format", "kerf-frames-1"},
               {"complete", manifest.complete},
               {"scene", manifest.scene},
               {"dimension", manifest.dimension},
               {"needs", manifest.needs},
               {"seed", manifest.seed},
               {"requested_objects", manifest.requested_objects},
               {"grow", manifest.grow},
               {"steps", {{"first", steps.first}, {"last", steps.last}, {"stride", steps.stride}}},
               {"size", {{"width", manifest.size.width}, {"height", manifest.size.height}}},
               {"layers", manifest.layers},
               {"camera", manifest.camera},
               {"volume", manifest.volume},
               {"recycle", manifest.recycle},
               {"broad_phase", manifest.broad_phase},
               {"config", manifest.config ? config_json(*manifest.config) : Json()},
               {"frames", Json::array()}};
  for (const FrameRecord& frame : manifest.frames) json["frames"].push_back(frame_json(frame));
  // Paths need not be UTF-8; what cannot be said in JSON is replaced, never a reason to lose the manifest.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void save(const Manifest& manifest, const std::filesystem::path& folder) {
  write_file_atomically(folder / kManifestName, to_json(manifest));
}

std::string frame_file_name(const std::string& scene, std::uint32_t frame) {
  char number[16];
  std::snprintf(number, sizeof number, "_%06u.png", frame);
  return scene + number;
}

}  // namespace kerf
