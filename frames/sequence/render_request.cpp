#include "frames/sequence/render_request.h"

#include <algorithm>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/counted.h"
#include "core/recording/unfinished.h"
#include "frames/sequence/recorded_steps.h"
#include "frames/sequence/recording_file.h"
#include "frames/support/errors.h"
#include "frames/support/parse_config.h"
#include "frames/support/parse_number.h"
#include "frames/support/suggest.h"
#include "frames/support/text_file.h"
#include "frames/support/utf8.h"
#include "viz/draw/camera.h"
#include "viz/draw/camera_path.h"
#include "viz/draw/frame_renderer.h"
#include "viz/draw/panes.h"

namespace kerf {
namespace {

/// Runs a parser of another room and turns its std::invalid_argument into an error of usage.
template <class Parse>
auto parse_option(std::string_view option, Parse parse) {
  try {
    return parse();
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string(option) + ": " + error.what());
  }
}

void check_camera(int dimension, const std::string& text) {
  parse_option("--camera", [&] {
    if (dimension == 2) {
      (void)parse_camera<2>(text);
    } else {
      (void)parse_camera<3>(text);
    }
    return 0;
  });
}

template <int D>
VolumeKind parse_volume(const std::string& text) {
  if (const auto kind = parse_volume_kind<D>(text)) return *kind;
  std::vector<std::string> names;
  for (const VolumeKind kind : volume_kinds<D>()) names.emplace_back(to_string(kind));
  throw UsageError("--volume: " + unknown_name_message("volume", text, names));
}

VolumeKind parse_volume(const CatalogScene& scene, const std::string& text) {
  return scene.dimension() == 2 ? parse_volume<2>(text) : parse_volume<3>(text);
}

Needs needs_of(const CatalogScene& scene) {
  return std::visit([](const auto* entry) { return entry->needs; }, scene.entry);
}

void check_growth(const CatalogScene& scene, const RenderTexts& texts) {
  if (!texts.grow.empty()) check_grows(scene, "--grow");
  if (!texts.recycle.empty()) check_grows(scene, "--recycle");
}

BroadPhaseChoice parse_broad_phase(const CatalogScene& scene, const RenderTexts& texts) {
  BroadPhaseChoice choice = choose_broad_phase(
      texts.broad_phase.empty() ? kPaperTree : std::string_view(texts.broad_phase), needs_of(scene));
  if (!texts.config.empty() && !choice.is_tree())
    throw UsageError("--config: " + choice.name + " has no parameters; only kerf and kerf-paper do");
  choice.config = parse_config("--config", texts.config, choice.config);
  if (texts.volume.empty()) return choice;
  choice.volume = parse_volume(scene, texts.volume);
  if (choice.volume != VolumeKind::box && !takes_volumes(choice.name))
    throw UsageError("--volume: " + choice.name +
                     " knows only boxes; kerf, kerf-paper and brute-force take other volumes");
  return choice;
}

std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> names;
  std::istringstream list(text);
  for (std::string name; std::getline(list, name, ',');) names.push_back(name);
  return names;
}

void check_panes(const RenderRequest& request, const RenderTexts& texts) {
  const std::size_t panes = 1 + request.beside->size();
  if (panes > kMostPanes)
    throw UsageError("--beside: a picture has at most " + std::to_string(kMostPanes) +
                     " panes, that of --broad-phase among them; leave out " +
                     std::to_string(panes - kMostPanes));
  std::vector<std::string> names{request.broad_phase.name};
  for (const BroadPhaseChoice& choice : *request.beside) {
    if (std::ranges::find(names, choice.name) != names.end())
      throw UsageError("--beside: " + choice.name + " would be in two panes; name it once");
    names.push_back(choice.name);
  }
  if (!have_room(request.size.width, request.size.height, panes))
    throw UsageError("--size: " + counted(panes, "pane has", "panes have") + " no room in " +
                     std::to_string(request.size.width) + "x" + std::to_string(request.size.height) +
                     " pixels; ask for a larger picture or name fewer in --beside");
  if (request.ids && panes > 1)
    throw UsageError(
        "--ids says what each pixel shows of one broad phase; leave it out, or give --beside none");
  if (!texts.record.empty())
    throw UsageError("--record takes the run of one broad phase; leave it or --beside out");
  if (request.broad_phase.volume != VolumeKind::box && !texts.volume.empty())
    throw UsageError("--volume: panes compare broad phases on the same boxes; leave it or --beside out");
}

/// Panes get boxes, whatever bounds the objects of the scene.
void parse_beside(const RenderTexts& texts, const Needs& needs, RenderRequest& request) {
  request.timed = texts.timed;
  if (texts.beside.empty()) {
    if (texts.timed) throw UsageError("--timed shows the times of panes; give --beside, too");
    return;
  }
  request.beside.emplace();
  if (texts.beside != "none")
    for (const std::string& name : split_list(texts.beside))
      request.beside->push_back(choose_broad_phase(name, needs, "--beside"));
  check_panes(request, texts);
  request.broad_phase.volume = VolumeKind::box;
  for (BroadPhaseChoice& choice : *request.beside) choice.volume = VolumeKind::box;
}

/// `--view` is the camera's direction, which `--camera` may still change.
std::string camera_text(const RenderTexts& texts, int dimension) {
  if (texts.view.empty()) return texts.camera;
  if (dimension == 2 || !is_direction(texts.view))
    throw UsageError("--view: " + (dimension == 2
                                       ? "a scene in 2D has no sides to be seen from"
                                       : "\"" + texts.view + "\" is none of iso, top, front, side"));
  return texts.camera.empty() ? texts.view : texts.view + "," + texts.camera;
}

std::string read_camera_path(int dimension, const std::string& file) {
  if (file.empty()) return "";
  std::string text = read_text_file(file);
  parse_option("--camera-path " + file, [&] {
    if (dimension == 2) {
      (void)CameraPath<2>(text);
    } else {
      (void)CameraPath<3>(text);
    }
    return 0;
  });
  return text;
}

int parse_samples(const RenderTexts& texts, PictureSize size) {
  if (texts.samples.empty()) return 0;
  if (texts.samples == "1") return 1;
  if (texts.samples == "4") return 4;
  if (texts.samples != "2x2")
    throw UsageError("--samples '" + texts.samples +
                     "': give 1 (jagged edges), 4 (smooth ones) or 2x2 (drawn at twice the size)");
  if (2 * std::max(size.width, size.height) > kMaxFrameSide)
    throw UsageError("--samples 2x2 draws at twice the size: no side may be above " +
                     std::to_string(kMaxFrameSide / 2) + " then");
  return kSupersampled;
}

/// The options of the pictures, for scenes and recordings alike.
void parse_pictures(const RenderTexts& texts, RenderRequest& request) {
  if (!texts.size.empty()) request.size = parse_picture_size(texts.size);
  if (!texts.show.empty())
    request.layers = parse_option("--show", [&] { return LayerSet::parse(texts.show); });
  request.camera = camera_text(texts, request.dimension());
  check_camera(request.dimension(), request.camera);
  request.camera_file = texts.camera_path;
  request.camera_path = read_camera_path(request.dimension(), texts.camera_path);
  request.samples = parse_samples(texts, request.size);
  if (!texts.backend.empty())
    request.backend = parse_option("--backend", [&] { return parse_gl_backend(texts.backend); });
  request.out =
      texts.out.empty() ? std::filesystem::path("out") / request.name : std::filesystem::path(texts.out);
  request.film = parse_film_request(texts.video, texts.fps, texts.contact_sheet, texts.overwrite);
  request.workers = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  if (!texts.workers.empty()) request.workers = parse_whole("--workers", texts.workers, 0, kMaxWorkers);
  request.ids = texts.ids;
  if (texts.ids && request.samples == kSupersampled)
    throw UsageError(
        "--ids says what each pixel shows, and with --samples 2x2 each shows four: leave one out");
  request.overwrite = texts.overwrite;
  request.resume = texts.resume;
}

void parse_shard_of_recording(const RenderTexts& texts, RenderRequest& request) {
  if (texts.shard.empty()) return;
  request.shard = parse_shard(texts.shard);
  if (!texts.video.empty() || !texts.contact_sheet.empty())
    throw UsageError(
        "a shard has not all frames that a film or a contact sheet needs; give --video and --contact-sheet "
        "to `kerf collect`");
  if (texts.out.empty())
    request.out +=
        "." + std::to_string(request.shard.index + 1) + "-of-" + std::to_string(request.shard.count);
}

RecordingSource open_source(const std::filesystem::path& path) {
  return with_recording(path, [&](const auto& reader) {
    if (reader->steps() == 0) throw UsageError(path.string() + " has no steps, so there is nothing to draw");
    return RecordingSource{path, reader->info(), reader->steps(), reader->rows().back().state_hash,
                           reader->chain_end()};
  });
}

/// A manifest has to contain it, and a number and an ending have to follow it: names of files may have 255
/// bytes.
std::string name_of_frames(const std::filesystem::path& recording) {
  constexpr std::size_t kLongest = 200;
  return valid_utf8(recording.stem().string().substr(0, kLongest));
}

}  // namespace

RenderRequest parse_request(const RenderTexts& texts) {
  RenderRequest request;
  request.scene = find_scene(texts.scene);
  request.name = request.scene.name;
  if (!texts.steps.empty()) request.steps = parse_steps(texts.steps);
  if (!texts.objects.empty()) {
    request.options.objects = parse_whole("--objects", texts.objects, 1U, kMaxRequestedObjects);
  }
  if (!texts.grow.empty()) request.options.steps = parse_whole("--grow", texts.grow, 1U, kMaxStep);
  check_growth(request.scene, texts);
  if (!texts.recycle.empty()) request.options.recycle = parse_whole("--recycle", texts.recycle, 1U, kMaxStep);
  if (!texts.seed.empty()) {
    request.options.seed = parse_whole<std::uint64_t>("--seed", texts.seed, 0, UINT64_MAX);
  }
  parse_pictures(texts, request);
  request.broad_phase = parse_broad_phase(request.scene, texts);
  parse_beside(texts, needs_of(request.scene), request);
  request.record = texts.record;
  if (request.resume && !request.record.empty())
    throw UsageError(
        "--record: a recording cannot be resumed; leave out --resume, or make it by `kerf record`");
  if (!texts.shard.empty())
    throw UsageError("--shard needs a recording: make one by `kerf record " + texts.scene +
                     " -o FILE` and render that");
  return request;
}

void check_recorded_steps(const std::string& text) {
  if (!text.empty() && !parse_number<std::uint64_t>(text))
    throw UsageError("--steps '" + text + "' is not how many, for example 1000: a recording has every step");
}

bool names_recording(const RenderTexts& texts) {
  try {
    (void)find_scene(texts.scene);
    return false;
  } catch (const UsageError&) {
    if (std::filesystem::is_regular_file(recording_at(texts.scene))) return true;
    // No scene has this name, so a file was meant.
    if (texts.scene.ends_with(".kerf") || texts.scene.find('/') != std::string::npos)
      throw std::runtime_error("there is no recording " + texts.scene +
                               "; `kerf record SCENE -o FILE` makes one, `kerf scenes` lists the scenes");
    return false;
  }
}

void refuse_of_recording(const RenderTexts& texts, const char* option, const std::string& text) {
  if (!text.empty())
    throw UsageError(std::string(option) + ": " + texts.scene +
                     " is a recording, of which that is settled; leave the option out");
}

/// "all" means all that there is.
void refuse_contacts(const RenderTexts& texts) {
  for (const std::string& layer : split_list(texts.show))
    if (layer.ends_with("contacts") && layer.find('-') == std::string::npos)
      throw UsageError("--show contacts: " + texts.scene +
                       " is a recording, which has no contacts; leave that layer out");
}

void refuse_scene_options(const RenderTexts& texts) {
  const std::pair<const char*, const std::string*> options[] = {
      {"--objects", &texts.objects}, {"--grow", &texts.grow},
      {"--recycle", &texts.recycle}, {"--broad-phase", &texts.broad_phase},
      {"--volume", &texts.volume},   {"--config", &texts.config},
      {"--seed", &texts.seed},       {"--record", &texts.record}};
  for (const auto& [option, text] : options) refuse_of_recording(texts, option, *text);
  refuse_contacts(texts);
}

RenderRequest parse_recording_request(const RenderTexts& texts) {
  refuse_scene_options(texts);
  RenderRequest request;
  request.recording = open_source(texts.scene);
  request.name = name_of_frames(request.recording->path);
  const std::uint32_t steps = request.recording->steps;
  request.steps.last = steps;
  if (!texts.steps.empty())
    request.steps = parse_recorded_steps(texts.steps, request.recording->info.names, steps);
  request.broad_phase.name = tree_of(request.recording->info);
  request.broad_phase.config = request.recording->info.config;
  request.broad_phase.volume = request.recording->info.volume;
  request.options = {request.recording->info.objects, request.recording->info.grow,
                     request.recording->info.recycle, request.recording->info.seed};
  parse_pictures(texts, request);
  Needs needs;
  needs.dimension = request.dimension();
  parse_beside(texts, needs, request);
  request.layers.set(Layer::contacts, false);  // a recording has no narrow phase
  parse_shard_of_recording(texts, request);
  return request;
}

}  // namespace kerf
