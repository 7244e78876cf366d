#include "tests/house/include_rules.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <regex>
#include <stdexcept>
#include <string_view>

namespace kerf::house {
namespace {

/// What a header belongs to: a room of the house or a library outside of it.
struct Owner {
  std::string_view name;
  std::string_view prefix;  ///< what the included path begins with
};

constexpr auto kRooms =
    std::to_array<std::string_view>({"core", "viz", "sims2d", "sims3d", "frames", "tests"});

constexpr auto kLibraries = std::to_array<Owner>({
    {"Eigen", "Eigen/"},
    {"Eigen", "unsupported/Eigen/"},
    {"Kerf for C", "kerf"},
    {"C", "stddef.h"},
    {"C", "stdint.h"},
    {"xxHash", "xxhash.h"},
    {"xxHash", "xxh"},
    {"Highway", "hwy/"},
    {"oneTBB", "oneapi/"},
    {"oneTBB", "tbb/"},
    {"SQLite", "sqlite3.h"},
    {"Zstandard", "zstd.h"},
    {"Zstandard", "zstd_errors.h"},
    {"GL", "GL/"},
    {"GL", "EGL/"},
    {"GL", "GLES"},
    {"GL", "KHR/"},
    {"GL", "GLFW/"},
    {"X11", "X11/"},
    {"Dear ImGui", "imgui"},
    {"Dear ImGui", "imstb_"},
    {"Dear ImGui", "imconfig"},
    {"stb", "stb"},
    {"libpng", "png.h"},
    {"libdeflate", "libdeflate"},
    {"ISA-L", "isa-l/"},
    {"Box2D", "box2d/"},
    {"ODE", "ode/"},
    {"Bullet", "BulletCollision/"},
    {"Bullet", "LinearMath/"},
    {"Bullet", "btBulletDynamicsCommon.h"},
    {"FCL", "fcl/"},
    {"CGAL", "CGAL/"},
    {"Embree", "embree3/"},
    {"Embree", "embree4/"},
    {"CLI11", "CLI/"},
    {"nlohmann/json", "nlohmann/"},
    {"tinyobjloader", "tiny_obj_loader.h"},
    {"pybind11", "pybind11/"},
    {"GoogleTest", "gtest/"},
    {"GoogleTest", "gmock/"},
    {"x86 intrinsics", "immintrin.h"},
    {"POSIX", "unistd.h"},
    {"POSIX", "fcntl.h"},
    {"POSIX", "poll.h"},
    {"POSIX", "sched.h"},
    {"POSIX", "pthread.h"},
    {"POSIX", "signal.h"},
    {"POSIX", "spawn.h"},
    {"POSIX", "dlfcn.h"},
    {"POSIX", "malloc.h"},
    {"POSIX", "sys/"},
});

/// Allows the files whose path begins with `from` to include what `owner` owns.
struct Permission {
  std::string_view from;
  std::string_view owner;
};

/// A folder and how high it stands in its room. A file includes files of its own folder and of lower ones;
/// two folders of one height do not see each other. `kerf_architecture` draws the picture in
/// docs/ARCHITECTURE.md from this table.
constexpr auto kLayers = std::to_array<Layer>({
    {"core/base/", 0, "ids, `Config`, random numbers, lists, thread pool"},
    {"core/geometry/", 1, "vectors, boxes, planes, volumes, direction sets"},
    {"core/trace/", 2, "events, decisions, statistics, reporter"},
    {"core/objects/", 3, "the `BroadPhase` interface, object table, entries, skins"},
    {"core/kernels/", 4, "vector code: byte sweep, list division, moves"},
    {"core/tree/", 5, "tree, the five operators, scheduler, validator, hash"},
    {"core/bsp/", 6, "the semi-adjusting BSP tree as a broad phase"},
    {"core/spatial/", 6, "queries: overlaps, rays, swept boxes, nearest, frustum"},
    {"core/broad_phase/", 7, "the oracle, other algorithms, approximate modes"},
    {"core/related/", 8, "broad phases of the paper's related work"},
    {"core/world/", 8, "objects with handles, kinds and filters; begun and ended pairs"},
    {"core/c/", 9, "`kerf.h`: the C interface"},
    {"core/scene/", 8, "what a scene is: shapes, poses, needs, bounding"},
    {"core/files/", 9, "files read whole, or named when complete"},
    {"core/recording/", 10, "recordings: writer, reader, codecs"},
    {"core/replay/", 11, "replay, cursor, verification, what-if"},
    {"core/query/", 12, "conditions, search, explanations, comparison"},

    {"viz/image/", 0, "pictures: PNG, contact sheets, comparison, FLIP"},
    {"viz/gl/", 1, "OpenGL contexts, framebuffers, shaders"},
    {"viz/draw/", 2, "camera, layers, palette, frame renderer, draw list"},
    {"viz/debugger/gui/", 3, "Dear ImGui on our OpenGL layer, window"},
    {"viz/debugger/model/", 3, "runs, breakpoints, lanes, selection"},
    {"viz/debugger/window/", 4, "layout of the window, and what a user chose of it"},
    {"viz/debugger/scene/", 4, "the view of the scene: orbit, picking, visibility"},
    {"viz/debugger/session/", 4, "what a user did, kept in a file; files opened lately"},
    {"viz/debugger/panels/", 5, "one panel a file"},
    {"viz/debugger/", 6, "the debugger and its scripts"},

    {"frames/support/", 0, "files, processes, numbers from text, progress"},
    {"frames/page/", 0, "plots and pages that open offline"},
    {"frames/rivals/", 0, "broad phases of other libraries"},
    {"frames/catalog/", 1, "scenes and broad phases by name"},
    {"frames/sequence/", 2, "frame sequences: workers, manifest, film, shards"},
    {"frames/import/", 3, "`kerf import`: tables of boxes and pairs of another engine"},
    {"frames/bench/", 3, "`kerf bench`: motions, cells, rows"},
    {"frames/diff/", 3, "`kerf diff`: pages of differences, approval"},
    {"frames/report/", 4, "`kerf report`: speed against error"},
    {"frames/experiment/", 4, "`kerf experiment`: the paper's figures and claims"},
    {"frames/study/", 4, "`kerf study`: cells of a matrix, on one machine or a farm"},
    {"frames/advise/", 4, "`kerf advise`: which broad phase for a recording"},
    {"frames/story/", 4, "`kerf film`: a run as a short film to share"},
    {"frames/bench_frames/", 4, "`kerf bench-frames`: milliseconds a frame"},
    {"frames/python/", 5, "the Python module `kerf`"},
    {"frames/commands/", 5, "one subcommand a file"},
    {"frames/main.cpp", 6, "the program `kerf`"},
});

constexpr auto kPermissions = std::to_array<Permission>({
    {"core/", "core"},
    {"core/c/", "Kerf for C"},
    {"core/c/", "C"},
    {"core/tree/hash.cpp", "xxHash"},
    {"core/world/seal.cpp", "xxHash"},
    {"core/recording/chain.cpp", "xxHash"},
    {"core/kernels/", "x86 intrinsics"},
    {"core/kernels/", "Highway"},
    {"core/base/task_pool", "oneTBB"},
    {"core/files/", "POSIX"},
    {"core/recording/database.cpp", "SQLite"},
    {"core/recording/writer_lock.cpp", "POSIX"},
    {"core/recording/compression.cpp", "Zstandard"},

    {"viz/", "viz"},
    {"viz/", "core"},
    {"viz/", "Eigen"},
    {"viz/", "GL"},
    {"viz/", "Dear ImGui"},
    {"viz/", "stb"},
    {"viz/", "libpng"},
    {"viz/", "libdeflate"},
    {"viz/", "ISA-L"},
    {"viz/", "POSIX"},
    {"viz/debugger/session/", "nlohmann/json"},

    {"sims2d/", "sims2d"},
    {"sims2d/", "core"},
    {"sims2d/", "Box2D"},

    {"sims3d/", "sims3d"},
    {"sims3d/", "core"},
    {"sims3d/", "ODE"},
    {"sims3d/bullet/", "Bullet"},
    {"sims3d/fcl/", "FCL"},
});

bool is_any_of(std::string_view name, std::span<const std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Headers of the C++ library have neither a folder nor an ending.
bool is_standard(std::string_view header) { return header.find_first_of("/.") == std::string_view::npos; }

bool is_permitted(std::string_view file, std::string_view owner) {
  if (file.starts_with("tests/")) return true;
  if (file.starts_with("frames/")) return owner != "tests" && owner != "GoogleTest";
  return std::any_of(kPermissions.begin(), kPermissions.end(), [&](const Permission& permission) {
    return file.starts_with(permission.from) && permission.owner == owner;
  });
}

bool has_layers(std::string_view room) {
  return std::ranges::any_of(kLayers, [&](const Layer& layer) {
    return layer.folder.starts_with(room) && layer.folder[room.size()] == '/';
  });
}

/// The reason why the layers of a room forbid it; empty when they do not.
std::string layer_objection(const std::string& file, const std::string& header) {
  const std::string_view room = std::string_view(file).substr(0, file.find('/'));
  if (!has_layers(room) || !header.starts_with(std::string(room) + '/')) return {};
  const Layer* const from = layer_of(file);
  const Layer* const to = layer_of(header);
  if (from == nullptr) return file + " lies in no layer of its room";
  if (to == nullptr) return header + " lies in no layer of its room";
  if (from == to || to->height < from->height) return {};
  return std::string(from->folder) + " must not include " + std::string(to->folder) + " (" + header + ")";
}

/// The reason why `file` must not include `header`; empty when it may.
std::string objection(const std::string& file, const std::string& header, bool quoted) {
  if (!quoted && is_standard(header)) return {};
  const auto owner = owner_of(header);
  const bool in_house = owner && is_any_of(*owner, kRooms);
  if (quoted && !in_house) return "\"" + header + "\" is no header of the project, written from its root";
  if (!quoted && in_house) return "<" + header + "> is the project's own and takes quotes";
  if (!owner) return "<" + header + "> belongs to no library that the house knows";
  if (is_permitted(file, *owner)) return layer_objection(file, header);
  const std::string room = file.substr(0, file.find('/'));
  return room + " must not include " + std::string(*owner) + " (" + header + ")";
}

/// The header of a source's name, if there is one.
std::string own_header(const std::filesystem::path& root, const std::string& file) {
  if (!file.ends_with(".cpp")) return {};
  std::string header = file.substr(0, file.size() - 3) + "h";
  return std::filesystem::exists(root / header) ? header : "";
}

/// The reason why an #include line must not be there; empty when it may.
std::string objection(const std::string& file, const Include& include) {
  if (include.header.empty()) return "an #include names its header";
  return objection(file, include.header, include.quoted);
}

void check_file(const std::filesystem::path& root, const std::string& file, std::vector<Violation>& found) {
  std::string first = own_header(root, file);
  for (const Include& include : includes_of(root / file)) {
    std::string reason = objection(file, include);
    if (reason.empty() && !first.empty() && !(include.quoted && include.header == first))
      reason = "the source of " + first + " must include it first";
    first.clear();
    if (!reason.empty()) found.push_back({file, include.line, reason});
  }
}

}  // namespace

std::span<const std::string_view> rooms() { return kRooms; }

std::span<const Layer> layers() { return kLayers; }

const Layer* layer_of(std::string_view file) {
  const Layer* found = nullptr;
  for (const Layer& layer : kLayers)
    if (file.starts_with(layer.folder) && (found == nullptr || layer.folder.size() > found->folder.size()))
      found = &layer;
  return found;
}

std::optional<std::string_view> owner_of(std::string_view header) {
  const std::string_view folder = header.substr(0, std::min(header.find('/'), header.size()));
  if (folder.size() < header.size() && is_any_of(folder, kRooms)) return folder;
  for (const Owner& library : kLibraries)
    if (header.starts_with(library.prefix)) return library.name;
  return std::nullopt;
}

std::vector<Include> includes_of(const std::filesystem::path& file) {
  std::ifstream text(file);
  if (!text) throw std::runtime_error("cannot read " + file.string());
  static const std::regex kDirective(R"(^\s*#\s*(?:include|include_next|import)\b\s*(.*))");
  static const std::regex kNamed(R"re(^(?:<([^>]+)>|"([^"]+)").*)re");
  std::vector<Include> found;
  std::string line;
  for (int number = 1; std::getline(text, line); ++number) {
    std::smatch directive;
    if (!std::regex_match(line, directive, kDirective)) continue;
    const std::string target = directive[1];
    std::smatch header;
    if (std::regex_match(target, header, kNamed))
      found.push_back({number, header[header[2].matched ? 2 : 1], header[2].matched});
    else
      found.push_back({number, {}, false});
  }
  return found;
}

std::string to_string(const Violation& violation) {
  return violation.file + ":" + std::to_string(violation.line) + ": " + violation.reason;
}

std::vector<Violation> check_includes(const std::filesystem::path& root,
                                      std::span<const std::filesystem::path> files) {
  std::vector<Violation> found;
  for (const std::filesystem::path& file : files) check_file(root, file.generic_string(), found);
  return found;
}

}  // namespace kerf::house
