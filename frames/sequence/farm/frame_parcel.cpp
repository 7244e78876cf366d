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
    out(bodies_, corners_);
    out.each(surfaces_, [&](const Surface* surface) { out(surface->vertices, surface->triangles); });
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
  const auto flats = in.get<std::vector<FlatBody<D>>>();
  const auto corners = in.get<std::vector<Vector<2>>>();
  std::vector<std::shared_ptr<const Surface>> surfaces;
  in.each(surfaces, [&](std::shared_ptr<const Surface>& surface) {
    Surface read;
    in(read.vertices, read.triangles);
    surface = std::make_shared<const Surface>(std::move(read));
  });
  std::vector<Body<D>> bodies;
  bodies.reserve(flats.size());
  for (const FlatBody<D>& flat : flats)
    bodies.push_back({shape_of(flat, corners, surfaces), flat.pose, flat.box, flat.mobility, flat.color});
  return bodies;
}

// Each takes a RawWriter and what it writes, or a RawReader and what it reads.

void caption_fields(auto& bytes, auto& of) {
  bytes(of.scene, of.broad_phase, of.step_name, of.note, of.step, of.objects, of.moving, of.pairs,
        of.contacts, of.statistics, of.knows_contacts, of.knows_pairs, of.is_run, of.theirs);
}

void point_fields(auto& bytes, auto& p) { bytes(p.x(), p.y(), p.z()); }

void polygon_fields(auto& bytes, auto& polygon) {
  bytes.each(polygon, [&](auto& p) { point_fields(bytes, p); });
}

void highlight_fields(auto& bytes, auto& of) {
  bytes(of.event, of.acted, of.age, of.lifetime);
  bytes.each(of.faces, [&](auto& face) { polygon_fields(bytes, face); });
  polygon_fields(bytes, of.partitioner);
  polygon_fields(bytes, of.old_partitioner);
  bytes.maybe(of.anchor, [&](auto& p) { point_fields(bytes, p); });
}

void plan_fields(auto& bytes, auto& of) {
  bytes(of.bounds, of.outside, of.names_outside, of.has_tree, of.placements, of.crowds, of.largest_population,
        of.ramp_is_fixed, of.samples);
  bytes.each(of.highlights, [&](auto& highlight) { highlight_fields(bytes, highlight); });
}

}  // namespace

template <int D>
std::vector<std::uint8_t> pack(const FrameInput<D>& input, const FramePlan<D>& plan) {
  RawWriter out;
  BodyPacker<D> bodies;
  for (const Body<D>& body : input.bodies) bodies.add(body);
  bodies.write(out);
  out(input.pairs, input.contacts, input.missed, input.extra, plan.snapshot.root(), plan.snapshot.nodes(),
      plan.snapshot.planes());
  caption_fields(out, input.caption);
  plan_fields(out, plan);
  return out.take();
}

template <int D>
FrameParcel<D> unpack(std::span<const std::uint8_t> bytes) {
  RawReader in(bytes);
  FrameParcel<D> parcel;
  parcel.bodies = read_bodies<D>(in);
  in(parcel.pairs, parcel.contacts, parcel.missed, parcel.extra);
  const auto root = in.get<NodeId>();
  auto nodes = in.get<std::vector<TreeSnapshot::Node>>();
  parcel.plan.snapshot.assign(root, std::move(nodes), in.get<std::vector<Plane<D>>>());
  caption_fields(in, parcel.caption);
  plan_fields(in, parcel.plan);
  return parcel;
}

template std::vector<std::uint8_t> pack<2>(const FrameInput<2>&, const FramePlan<2>&);
template std::vector<std::uint8_t> pack<3>(const FrameInput<3>&, const FramePlan<3>&);
template FrameParcel<2> unpack<2>(std::span<const std::uint8_t>);
template FrameParcel<3> unpack<3>(std::span<const std::uint8_t>);

}  // namespace kerf
