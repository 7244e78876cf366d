#include "frames/sequence/farm/frame_parcel.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/base/overloaded.h"
#include "frames/support/raw_bytes.h"

namespace kerf {
namespace {

/// A body without the parts of its shape that have variable length.
template <int D>
struct FlatBody {
  std::uint32_t shape = 0;  ///< index in the variant
  std::uint32_t first = 0;  ///< outline: its first corner; surface: which one
  std::uint32_t count = 0;  ///< outline: corners
  Vector<D> size;           ///< ball: the radius; brick: half extents
  Pose<D> pose;
  Box<D> box;
  Mobility mobility = Mobility::moving;
  std::optional<Rgb> color;
};

template <int D>
class BodyPacker {
 public:
  void add(const Body<D>& body) {
    FlatBody<D> flat{static_cast<std::uint32_t>(body.shape.index()),
                     0,
                     0,
                     {},
                     body.pose,
                     body.box,
                     body.mobility,
                     body.color};
    std::visit(
        Overloaded{
            [&](const Ball& ball) { flat.size[0] = ball.radius; },
            [&](const Brick<D>& brick) { flat.size = brick.half; },
            [&](const Outline& outline) {
              flat.first = static_cast<std::uint32_t>(corners_.size());
              flat.count = static_cast<std::uint32_t>(outline.corners.size());
              corners_.insert(corners_.end(), outline.corners.begin(), outline.corners.end());
            },
            [&](const std::shared_ptr<const Surface>& surface) { flat.first = index_of(surface.get()); },
        },
        body.shape);
    bodies_.push_back(flat);
  }

  void write(RawWriter& out) const {
    out.put_list(std::span<const FlatBody<D>>(bodies_));
    out.put_list(std::span<const Vector<2>>(corners_));
    out.put(surfaces_.size());
    for (const Surface* surface : surfaces_) {
      out.put_list(std::span<const Vector<3>>(surface->vertices));
      out.put_list(std::span<const std::array<std::uint32_t, 3>>(surface->triangles));
    }
  }

 private:
  std::uint32_t index_of(const Surface* surface) {
    const auto [known, is_new] = index_.emplace(surface, static_cast<std::uint32_t>(surfaces_.size()));
    if (is_new) surfaces_.push_back(surface);
    return known->second;
  }

  std::vector<FlatBody<D>> bodies_;
  std::vector<Vector<2>> corners_;
  std::vector<const Surface*> surfaces_;
  std::map<const Surface*, std::uint32_t> index_;
};

template <int D>
Shape<D> shape_of(const FlatBody<D>& flat, const std::vector<Vector<2>>& corners,
                  const std::vector<std::shared_ptr<const Surface>>& surfaces) {
  if (flat.shape == 0) return Ball{flat.size[0]};
  if (flat.shape == 1) return Brick<D>{flat.size};
  if constexpr (D == 2) {
    const auto first = corners.begin() + flat.first;
    return Outline{{first, first + flat.count}};
  } else {
    return surfaces.at(flat.first);
  }
}

template <int D>
std::vector<Body<D>> read_bodies(RawReader& in) {
  const auto flats = in.get_list<FlatBody<D>>();
  const auto corners = in.get_list<Vector<2>>();
  std::vector<std::shared_ptr<const Surface>> surfaces(in.get<std::size_t>());
  for (auto& surface : surfaces) {
    Surface read{in.get_list<Vector<3>>(), {}};
    read.triangles = in.get_list<std::array<std::uint32_t, 3>>();
    surface = std::make_shared<const Surface>(std::move(read));
  }
  std::vector<Body<D>> bodies;
  bodies.reserve(flats.size());
  for (const FlatBody<D>& flat : flats)
    bodies.push_back({shape_of(flat, corners, surfaces), flat.pose, flat.box, flat.mobility, flat.color});
  return bodies;
}

void write(RawWriter& out, const Caption& caption) {
  out.put_text(caption.scene);
  out.put_text(caption.broad_phase);
  out.put_text(caption.step_name);
  out.put_text(caption.note);
  out.put(caption.step);
  out.put(caption.objects);
  out.put(caption.moving);
  out.put(caption.pairs);
  out.put(caption.contacts);
  out.put(caption.statistics);
  out.put(caption.knows_contacts);
  out.put(caption.knows_pairs);
  out.put(caption.is_run);
}

Caption read_caption(RawReader& in) {
  Caption caption;
  caption.scene = in.get_text();
  caption.broad_phase = in.get_text();
  caption.step_name = in.get_text();
  caption.note = in.get_text();
  caption.step = in.get<std::uint32_t>();
  caption.objects = in.get<std::uint32_t>();
  caption.moving = in.get<std::uint32_t>();
  caption.pairs = in.get<std::uint64_t>();
  caption.contacts = in.get<std::uint64_t>();
  caption.statistics = in.get<Statistics>();
  caption.knows_contacts = in.get<bool>();
  caption.knows_pairs = in.get<bool>();
  caption.is_run = in.get<bool>();
  return caption;
}

void write(RawWriter& out, const Polygon& polygon) {
  out.put(polygon.size());
  for (const Eigen::Vector3d& p : polygon) out.put(std::array{p.x(), p.y(), p.z()});
}

Polygon read_polygon(RawReader& in) {
  Polygon polygon(in.get<std::size_t>());
  for (Eigen::Vector3d& p : polygon) {
    const auto xyz = in.get<std::array<double, 3>>();
    p = {xyz[0], xyz[1], xyz[2]};
  }
  return polygon;
}

void write(RawWriter& out, const Highlight& highlight) {
  out.put(highlight.event);
  out.put(highlight.acted);
  out.put(highlight.age);
  out.put(highlight.lifetime);
  out.put(highlight.faces.size());
  for (const Polygon& face : highlight.faces) write(out, face);
  write(out, highlight.partitioner);
  write(out, highlight.old_partitioner);
  write(out, highlight.anchor ? Polygon{*highlight.anchor} : Polygon());
}

Highlight read_highlight(RawReader& in) {
  Highlight highlight;
  highlight.event = in.get<std::uint64_t>();
  highlight.acted = in.get<OperatorActed>();
  highlight.age = in.get<std::uint32_t>();
  highlight.lifetime = in.get<std::uint32_t>();
  highlight.faces.resize(in.get<std::size_t>());
  for (Polygon& face : highlight.faces) face = read_polygon(in);
  highlight.partitioner = read_polygon(in);
  highlight.old_partitioner = read_polygon(in);
  for (const Eigen::Vector3d& p : read_polygon(in)) highlight.anchor = p;
  return highlight;
}

template <int D>
void write(RawWriter& out, const FramePlan<D>& plan) {
  out.put(plan.bounds);
  out.put(plan.outside);
  out.put(plan.names_outside);
  out.put(plan.has_tree);
  out.put(plan.snapshot.root());
  out.put_list(plan.snapshot.nodes());
  out.put_list(plan.snapshot.planes());
  out.put_list(std::span<const Placement>(plan.placements));
  out.put_list(std::span<const Box<D>>(plan.crowds));
  out.put(plan.highlights.size());
  for (const Highlight& highlight : plan.highlights) write(out, highlight);
  out.put(plan.largest_population);
  out.put(plan.ramp_is_fixed);
  out.put(plan.samples);
}

template <int D>
FramePlan<D> read_plan(RawReader& in) {
  FramePlan<D> plan;
  plan.bounds = in.get<Box<D>>();
  plan.outside = in.get<std::uint32_t>();
  plan.names_outside = in.get<bool>();
  plan.has_tree = in.get<bool>();
  const auto root = in.get<NodeId>();
  auto nodes = in.get_list<TreeSnapshot::Node>();
  plan.snapshot.assign(root, std::move(nodes), in.get_list<Plane<D>>());
  plan.placements = in.get_list<Placement>();
  plan.crowds = in.get_list<Box<D>>();
  plan.highlights.resize(in.get<std::size_t>());
  for (Highlight& highlight : plan.highlights) highlight = read_highlight(in);
  plan.largest_population = in.get<std::uint32_t>();
  plan.ramp_is_fixed = in.get<bool>();
  plan.samples = in.get<int>();
  return plan;
}

}  // namespace

template <int D>
std::vector<std::uint8_t> pack(const FrameInput<D>& input, const FramePlan<D>& plan) {
  RawWriter out;
  BodyPacker<D> bodies;
  for (const Body<D>& body : input.bodies) bodies.add(body);
  bodies.write(out);
  out.put_list(input.pairs);
  out.put_list(input.contacts);
  write(out, input.caption);
  write(out, plan);
  return out.take();
}

template <int D>
FrameParcel<D> unpack(std::span<const std::uint8_t> bytes) {
  RawReader in(bytes);
  FrameParcel<D> parcel;
  parcel.bodies = read_bodies<D>(in);
  parcel.pairs = in.get_list<Pair>();
  parcel.contacts = in.get_list<Pair>();
  parcel.caption = read_caption(in);
  parcel.plan = read_plan<D>(in);
  return parcel;
}

template std::vector<std::uint8_t> pack<2>(const FrameInput<2>&, const FramePlan<2>&);
template std::vector<std::uint8_t> pack<3>(const FrameInput<3>&, const FramePlan<3>&);
template FrameParcel<2> unpack<2>(std::span<const std::uint8_t>);
template FrameParcel<3> unpack<3>(std::span<const std::uint8_t>);

}  // namespace kerf
