#include "viz/debugger/session/session_text.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "core/query/asked_query.h"

namespace kerf {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "kerf-session";
constexpr int kVersion = 1;

[[noreturn]] void fail(const std::string& what) { throw SessionError("the session is damaged: " + what); }

/// Without the "[json.exception.out_of_range.403] " before it.
std::string without_number(const std::string& message) {
  const std::size_t end = message.find("] ");
  return end == std::string::npos ? message : message.substr(end + 2);
}

// Writing.

Json json_of(const Position& moment) {
  Json json{{"step", moment.step}};
  if (!moment.is_end()) json["event"] = moment.event;
  return json;
}

template <class Things>
Json numbers_of(const Things& things) {
  Json json = Json::array();
  for (const auto& thing : things) json.push_back(thing.value);
  return json;
}

Json json_of(const Selection& selection) {
  return std::visit(Overloaded{[](std::monostate) { return Json(); },
                               [](NodeId node) {
                                 return Json{{"node", node.value}};
                               },
                               [](ObjectId object) {
                                 return Json{{"object", object.value}};
                               },
                               [](const Pair& pair) {
                                 return Json{{"pair", {pair.a.value, pair.b.value}}};
                               }},
                    selection);
}

template <class Point>
Json json_of_point(const Point& point) {
  return Json(std::vector<double>(point.data(), point.data() + point.size()));
}

Json json_of(const CameraChoice<2>& camera) {
  Json json{{"dimension", 2}, {"everything", camera.framing == Framing::everything}};
  if (camera.center) json["center"] = json_of_point(*camera.center);
  if (camera.width) json["width"] = *camera.width;
  return json;
}

Json json_of(const CameraChoice<3>& camera) {
  Json json{{"dimension", 3},
            {"everything", camera.framing == Framing::everything},
            {"yaw", camera.yaw},
            {"pitch", camera.pitch},
            {"fov", camera.fov}};
  if (camera.distance) json["distance"] = *camera.distance;
  if (camera.target) json["target"] = json_of_point(*camera.target);
  return json;
}

Json json_of(const ViewSettings& view) {
  Json json{{"layers", to_string(view.layers)},
            {"colour", kTintNames[static_cast<std::size_t>(view.tint)]},
            {"depths", {view.least_depth, view.greatest_depth}},
            {"hidden_nodes", numbers_of(view.hidden_nodes)},
            {"hidden_objects", numbers_of(view.hidden_objects)}};
  if (view.isolated) json["isolated"] = view.isolated->value;
  if (view.theirs) json["theirs"] = true;
  if (!view.query.empty()) json["query"] = view.query;
  return json;
}

Json json_of(const DebuggerSession::Lanes& lanes) {
  Json json{{"from", lanes.first},  {"to", lanes.last},     {"lane", lanes.lane},
            {"clips", lanes.clips}, {"loops", lanes.loops}, {"kind", to_string(lanes.kind)}};
  if (lanes.range) json["range"] = {lanes.range->first, lanes.range->last};
  return json;
}

Json json_of(const DebuggerSession::Watch& watch) {
  Json json{{"expression", watch.expression}};
  if (watch.stop) json["stops_when"] = *watch.stop == Change::any ? "changed" : "true";
  return json;
}

// Reading. nlohmann::json says by itself what has another type or is missing.

template <class Number = std::uint32_t>
Number whole(const Json& json) {
  if (!json.is_number_unsigned() || !std::in_range<Number>(json.get<std::uint64_t>()))
    fail(json.dump() + " is no number of a step, an event, a node or an object");
  return json.get<Number>();
}

double finite(const Json& json) {
  const double value = json.get<double>();
  if (!std::isfinite(value)) fail(json.dump() + " is no finite number");
  return value;
}

/// A length in the scene.
double length(const Json& json) {
  const double value = finite(json);
  if (value <= 0) fail(json.dump() + " is no positive number");
  return std::clamp(value, 1e-6, 1e12);
}

template <class Name>
Name name_in(const Json& json, std::span<const std::string_view> names) {
  const auto found = std::ranges::find(names, json.get<std::string>());
  if (found == names.end()) fail(json.dump() + " is no name that is known here");
  return static_cast<Name>(found - names.begin());
}

Position moment_of(const Json& json) {
  Position moment = Position::end_of(whole(json.at("step")));
  if (json.contains("event")) moment.event = whole<std::uint64_t>(json.at("event"));
  return moment;
}

Selection selection_of(const Json& json) {
  if (json.is_null()) return {};
  if (json.contains("node")) return NodeId{whole(json.at("node"))};
  if (json.contains("object")) return ObjectId{whole(json.at("object"))};
  return Pair{{whole(json.at("pair").at(0))}, {whole(json.at("pair").at(1))}};
}

template <class Point>
Point point_of(const Json& json) {
  Point point;
  for (Eigen::Index k = 0; k < point.size(); ++k) point[k] = finite(json.at(static_cast<std::size_t>(k)));
  return point;
}

AnyCamera camera_of(const Json& json) {
  const Framing framing = json.at("everything").get<bool>() ? Framing::everything : Framing::most;
  if (whole(json.at("dimension")) == 2) {
    CameraChoice<2> camera{.center = {}, .width = {}, .framing = framing};
    if (json.contains("center")) camera.center = point_of<Eigen::Vector2d>(json.at("center"));
    if (json.contains("width")) camera.width = length(json.at("width"));
    return camera;
  }
  CameraChoice<3> camera{.yaw = finite(json.at("yaw")),
                         .pitch = std::clamp(finite(json.at("pitch")), -90.0, 90.0),
                         .fov = std::clamp(finite(json.at("fov")), 1.0, 170.0),
                         .distance = {},
                         .target = {},
                         .framing = framing};
  if (json.contains("distance")) camera.distance = length(json.at("distance"));
  if (json.contains("target")) camera.target = point_of<Eigen::Vector3d>(json.at("target"));
  return camera;
}

template <int D>
bool is_query(const std::string& text) {
  try {
    static_cast<void>(parse_query<D>(text));
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

std::string query_of(const Json& json) {
  auto text = json.get<std::string>();
  if (!is_query<2>(text) && !is_query<3>(text)) fail("'" + text + "' is no query such as ray 0,2,1,0");
  return text;
}

ViewSettings view_of(const Json& json) {
  ViewSettings view;
  view.layers = LayerSet::parse(json.at("layers").get<std::string>(), LayerSet::none());
  view.tint = name_in<Tint>(json.at("colour"), kTintNames);
  view.least_depth = whole<int>(json.at("depths").at(0));
  view.greatest_depth = whole<int>(json.at("depths").at(1));
  for (const Json& node : json.at("hidden_nodes")) view.hidden_nodes.insert(NodeId{whole(node)});
  for (const Json& object : json.at("hidden_objects")) view.hidden_objects.insert(ObjectId{whole(object)});
  if (json.contains("isolated")) view.isolated = NodeId{whole(json.at("isolated"))};
  view.theirs = json.value("theirs", false);
  if (json.contains("query")) view.query = query_of(json.at("query"));
  return view;
}

DebuggerSession::Lanes lanes_of(const Json& json) {
  DebuggerSession::Lanes lanes{finite(json.at("from")),
                               finite(json.at("to")),
                               json.at("lane").get<std::string>(),
                               json.at("clips").get<bool>(),
                               {},
                               json.at("loops").get<bool>(),
                               name_in<EventKind>(json.at("kind"), kEventKindNames)};
  if (!json.contains("range")) return lanes;
  lanes.range = StepSpan{whole(json.at("range").at(0)), whole(json.at("range").at(1))};
  if (lanes.range->first < 1 || lanes.range->last < lanes.range->first) fail("the range has no steps");
  return lanes;
}

DebuggerSession::Watch watch_of(const Json& json) {
  DebuggerSession::Watch watch{json.at("expression").get<std::string>(), {}};
  (void)Expression::parse_value(watch.expression);
  constexpr std::array<std::string_view, 2> kChanges{"changed", "true"};  // as in Change
  if (json.contains("stops_when")) watch.stop = name_in<Change>(json.at("stops_when"), kChanges);
  return watch;
}

DebuggerSession session_in(const Json& json) {
  DebuggerSession session;
  const Json& recording = json.at("recording");
  session.recording = {recording.at("scene").get<std::string>(), recording.at("dimension").get<int>(),
                       whole(recording.at("steps")), recording.at("hash").get<std::string>()};
  for (const Json& stop : json.at("breakpoints")) {
    session.breakpoints.push_back({stop.at("condition").get<std::string>(), stop.at("enabled").get<bool>()});
    (void)Expression::parse(session.breakpoints.back().condition);
  }
  for (const Json& watch : json.at("watches")) session.watches.push_back(watch_of(watch));
  for (const Json& mark : json.at("bookmarks"))
    session.bookmarks[moment_of(mark)] = mark.at("note").get<std::string>();
  session.view = view_of(json.at("view"));
  session.camera = camera_of(json.at("camera"));
  session.selection = selection_of(json.at("selection"));
  session.position = moment_of(json.at("moment"));
  session.lanes = lanes_of(json.at("lanes"));
  return session;
}

}  // namespace

std::string write_session(const DebuggerSession& session) {
  const RecordingMark& mark = session.recording;
  Json json{
      {"format", kFormat},
      {"version", kVersion},
      {"recording",
       {{"scene", mark.scene}, {"dimension", mark.dimension}, {"steps", mark.steps}, {"hash", mark.hash}}},
      {"breakpoints", Json::array()},
      {"watches", Json::array()},
      {"bookmarks", Json::array()}};
  for (const DebuggerSession::Stop& stop : session.breakpoints)
    json["breakpoints"].push_back({{"condition", stop.condition}, {"enabled", stop.enabled}});
  for (const DebuggerSession::Watch& watch : session.watches) json["watches"].push_back(json_of(watch));
  for (const auto& [moment, note] : session.bookmarks) {
    json["bookmarks"].push_back(json_of(moment));
    json["bookmarks"].back()["note"] = note;
  }
  json["view"] = json_of(session.view);
  json["camera"] = std::visit([](const auto& camera) { return json_of(camera); }, session.camera);
  json["selection"] = json_of(session.selection);
  json["moment"] = json_of(session.position);
  json["lanes"] = json_of(session.lanes);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

DebuggerSession read_session(std::string_view text) {
  try {
    const Json json = Json::parse(text);
    if (!json.is_object() || json.value("format", "") != kFormat)
      throw SessionError("it is no session of kerf debug");
    if (json.at("version") != kVersion)
      throw SessionError("its version is " + json.at("version").dump() + ", and this kerf reads version " +
                         std::to_string(kVersion));
    return session_in(json);
  } catch (const nlohmann::json::parse_error& error) {
    fail("it is no JSON from byte " + std::to_string(error.byte) + " on");
  } catch (const nlohmann::json::out_of_range& error) {
    fail(without_number(error.what()));  // such as "key 'note' not found"
  } catch (const nlohmann::json::exception&) {
    fail("a part of it is of another kind than in a session, such as a list where there should be a number");
  } catch (const std::invalid_argument& error) {
    fail(error.what());
  }
}

}  // namespace kerf
