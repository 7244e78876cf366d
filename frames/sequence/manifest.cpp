#include "frames/sequence/manifest.h"

#include <charconv>
#include <cstdio>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "core/files/whole_file.h"
#include "core/recording/recording_info.h"
#include "frames/page/json.h"
#include "frames/support/atomic_file.h"
#include "frames/support/json_number.h"
#include "frames/support/printed.h"

namespace kerf {
namespace {

constexpr const char* kManifestFormat = "kerf-frames-2";

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

/// Hexadecimal, as `hex` writes it.
std::uint64_t from_hex(const Json& json) {
  const std::string text = json.get<std::string>();
  std::uint64_t hash = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, hash, 16);
  if (error != std::errc{} || stop != end) throw std::out_of_range("'" + text + "' is no hash");
  return hash;
}

template <class Whole>
void take(const Json& json, const char* key, Whole& number) {
  number = whole_number<Whole>(json.at(key), key);
}

/// The file must lie in the folder itself.
void check_plain(const std::string& file) {
  if (file.empty() || file == "." || file == ".." || file.find('/') != std::string::npos)
    throw std::out_of_range("'" + file + "' is no name of a file in its folder");
}

/// `knows_contacts`: false for recordings, which hold none.
Json frame_json(const FrameRecord& frame, bool knows_contacts) {
  Json operators = Json::object();
  for (int i = 0; i < kOperatorCount; ++i) {
    operators[std::string(to_string(static_cast<Operator>(i)))] =
        frame.operators[static_cast<std::size_t>(i)];
  }
  Json json = {{"index", frame.index},
               {"file", frame.file},
               {"step", frame.step},
               {"objects", frame.objects},
               {"pairs", frame.pairs}};
  if (!frame.given_step.empty()) json["given_step"] = frame.given_step;
  if (knows_contacts) json["contacts"] = frame.contacts;
  json.update(Json{{"height", frame.height},
                   {"leaves", frame.leaves},
                   {"entries", frame.entries},
                   {"operators", operators},
                   {"events", frame.events},
                   {"state_hash", to_hex(frame.state_hash)},
                   {"pixel_hash", to_hex(frame.pixel_hash)}});
  return json;
}

FrameRecord frame_of(const Json& json) {
  FrameRecord frame;
  take(json, "index", frame.index);
  json.at("file").get_to(frame.file);
  take(json, "step", frame.step);
  if (json.contains("given_step")) json.at("given_step").get_to(frame.given_step);
  take(json, "objects", frame.objects);
  take(json, "pairs", frame.pairs);
  if (json.contains("contacts")) take(json, "contacts", frame.contacts);
  take(json, "height", frame.height);
  take(json, "leaves", frame.leaves);
  take(json, "entries", frame.entries);
  for (int i = 0; i < kOperatorCount; ++i)
    take(json.at("operators"), to_string(static_cast<Operator>(i)).data(),
         frame.operators[static_cast<std::size_t>(i)]);
  take(json, "events", frame.events);
  frame.state_hash = from_hex(json.at("state_hash"));
  frame.pixel_hash = from_hex(json.at("pixel_hash"));
  return frame;
}

/// The source of the frames: a scene that runs or a recording.
Json origin_json(const RenderRequest& request) {
  const SceneOptions& options = request.options;
  Json json = {{"scene", request.recording ? request.recording->info.scene : request.scene.name},
               {"dimension", request.dimension()},
               {"seed", options.seed},
               {"requested_objects", options.objects},
               {"grow", options.steps},
               {"recycle", options.recycle},
               {"broad_phase", request.broad_phase.name},
               {"volume", to_string(request.broad_phase.volume)},
               {"config", request.broad_phase.is_tree() ? config_json(request.broad_phase.config) : Json()}};
  if (request.recording) {
    json["recording"] = {{"steps", request.recording->steps},
                         {"last_state_hash", to_hex(request.recording->last_state_hash)},
                         {"identity", to_hex(request.recording->identity)}};
  } else {
    json["needs"] = std::visit([](const auto* entry) { return describe(entry->needs); }, request.scene.entry);
  }
  return json;
}

Json to_object(const Manifest& manifest) {
  Json json = Json::parse(manifest.header);
  json["shard"] = {{"index", manifest.shard.index}, {"count", manifest.shard.count}};
  json["complete"] = manifest.complete;
  json["frames"] = Json::array();
  const bool knows_contacts = !json.contains("recording");
  for (const FrameRecord& frame : manifest.frames)
    json["frames"].push_back(frame_json(frame, knows_contacts));
  return json;
}

/// Checks the numbers and names that readers divide by, count to or open. Throws UsageError or
/// std::out_of_range.
void check(const Manifest& manifest) {
  check(manifest.steps, "steps");
  check(manifest.size, "size");
  if (manifest.shard.index >= manifest.shard.count)
    throw std::out_of_range("the shard's index is not below their count");
  check_plain(frame_file_name(manifest.name, 0));
  for (const FrameRecord& frame : manifest.frames) {
    check_plain(frame.file);
    if (frame.index >= manifest.steps.frames())
      throw std::out_of_range("frame " + std::to_string(frame.index) + " comes after the last");
  }
}

Manifest from_object(Json json) {
  Manifest manifest;
  json.at("name").get_to(manifest.name);
  take(json.at("steps"), "first", manifest.steps.first);
  take(json.at("steps"), "last", manifest.steps.last);
  take(json.at("steps"), "stride", manifest.steps.stride);
  take(json.at("size"), "width", manifest.size.width);
  take(json.at("size"), "height", manifest.size.height);
  take(json.at("shard"), "index", manifest.shard.index);
  take(json.at("shard"), "count", manifest.shard.count);
  json.at("complete").get_to(manifest.complete);
  for (const Json& frame : json.at("frames")) manifest.frames.push_back(frame_of(frame));
  check(manifest);
  for (const char* const rest : {"shard", "complete", "frames"}) json.erase(rest);
  manifest.header = json_text(json, -1);
  return manifest;
}

}  // namespace

std::uint32_t Manifest::wanted_frames() const {
  const std::uint32_t all = steps.frames();
  return all / shard.count + (shard.index < all % shard.count ? 1 : 0);
}

Manifest begin_manifest(const RenderRequest& request) {
  Json json = {{"format", kManifestFormat}, {"name", request.name}};
  json.update(origin_json(request));
  const StepRange& steps = request.steps;
  json["steps"] = {{"first", steps.first}, {"last", steps.last}, {"stride", steps.stride}};
  json["size"] = {{"width", request.size.width}, {"height", request.size.height}};
  json["layers"] = to_string(request.layers);
  json["camera"] = request.camera;
  json["camera_path"] = request.camera_path;
  json["samples"] = request.samples;
  if (request.beside) {
    json["beside"] = Json::array();
    for (const BroadPhaseChoice& choice : *request.beside) json["beside"].push_back(choice.name);
    json["timed"] = request.timed;
  }
  return {json_text(json, -1), request.name, steps, request.size, request.shard, false, {}};
}

std::string to_json(const Manifest& manifest) { return json_text(to_object(manifest), 1) + "\n"; }

void save(const Manifest& manifest, const std::filesystem::path& folder) {
  write_file_atomically(folder / kManifestName, to_json(manifest));
}

Manifest read_manifest(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / kManifestName;
  const std::string text = read_whole_file(path);
  try {
    Json json = Json::parse(text);
    if (json.at("format") == kManifestFormat) return from_object(std::move(json));
  } catch (const std::exception& error) {
    throw std::runtime_error(path.string() + " is damaged (" + error.what() + "): render anew");
  }
  throw std::runtime_error(path.string() + " is of another version of kerf: render anew");
}

std::string first_difference(const std::string& header, const std::string& other) {
  const Json a = Json::parse(header);
  const Json b = Json::parse(other);
  for (const auto& [key, value] : a.items())
    if (!b.contains(key) || b[key] != value)
      return key + ": " + json_text(value, -1) + " and " +
             (b.contains(key) ? json_text(b[key], -1) : "nothing");
  for (const auto& [key, value] : b.items())
    if (!a.contains(key)) return key + ": nothing and " + json_text(value, -1);
  return "";
}

std::string frame_file_name(const std::string& name, std::uint32_t frame) {
  return name + printed("_%06u.png", frame);
}

}  // namespace kerf
