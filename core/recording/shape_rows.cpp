#include "core/recording/shape_rows.h"

#include <array>
#include <cmath>

#include "core/base/counted.h"
#include "core/base/damage.h"
#include "core/recording/compression.h"

namespace kerf {
namespace {

template <int D>
void put_vectors(std::span<const Vector<D>> vectors, ByteWriter& out) {
  out.varint(vectors.size());
  for (const Vector<D>& vector : vectors)
    for (const Scalar x : vector.value) out.f32(x);
}

template <int D>
std::vector<Vector<D>> get_vectors(ByteReader& in) {
  std::vector<Vector<D>> vectors(in.count(sizeof(Vector<D>)));
  for (Vector<D>& vector : vectors) {
    for (Scalar& x : vector.value) x = in.f32();
    if (!is_finite(vector)) fail_damaged("a shape has a corner that is nowhere");
  }
  return vectors;
}

Scalar get_size(ByteReader& in) {
  const Scalar size = in.f32();
  if (!(size > 0) || !std::isfinite(size)) fail_damaged("a shape has a size of " + std::to_string(size));
  return size;
}

Bytes to_bytes(const ByteWriter& out) { return {out.bytes().begin(), out.bytes().end()}; }

ShapeText encode(const Ball& ball) {
  ByteWriter out;
  out.f32(ball.radius);
  return {"ball", to_bytes(out)};
}

template <int D>
ShapeText encode(const Brick<D>& brick) {
  ByteWriter out;
  for (const Scalar half : brick.half.value) out.f32(half);
  return {"brick", to_bytes(out)};
}

ShapeText encode(const Outline& outline) {
  ByteWriter out;
  put_vectors<2>(outline.corners, out);
  return {"outline", to_bytes(out)};
}

ShapeText encode(const std::shared_ptr<const Surface>& surface) {
  ByteWriter out;
  put_vectors<3>(surface->vertices, out);
  out.varint(surface->triangles.size());
  for (const auto& triangle : surface->triangles)
    for (const std::uint32_t corner : triangle) out.varint(corner);
  return {"surface", compress(out.bytes())};
}

template <int D>
Brick<D> decode_brick(ByteReader& in) {
  Brick<D> brick;
  for (Scalar& half : brick.half.value) half = get_size(in);
  return brick;
}

Outline decode_outline(ByteReader& in) {
  constexpr std::size_t kFewest = 3;
  Outline outline{get_vectors<2>(in)};
  if (outline.corners.size() < kFewest)
    fail_damaged("an outline has " + std::to_string(outline.corners.size()) + " corners");
  return outline;
}

std::shared_ptr<const Surface> decode_surface(std::span<const std::uint8_t> data) {
  constexpr std::size_t kLeast = 3;  // bytes of a triangle
  const Bytes plain = decompress(data);
  ByteReader in(plain);
  auto surface = std::make_shared<Surface>();
  surface->vertices = get_vectors<3>(in);
  surface->triangles.resize(in.count(kLeast));
  for (auto& triangle : surface->triangles)
    for (std::uint32_t& corner : triangle) {
      corner = in.number();
      if (corner >= surface->vertices.size()) fail_damaged("a surface has a triangle without a corner");
    }
  if (surface->triangles.empty()) fail_damaged("a surface has no triangle");
  if (!in.empty()) fail_damaged("a surface has more than its triangles");
  return surface;
}

}  // namespace

const char* const kShapeTable = R"sql(
CREATE TABLE shapes(shape INTEGER PRIMARY KEY, step INTEGER, kind TEXT, seal INTEGER, data BLOB);
)sql";

template <int D>
ShapeText encode_shape(const Shape<D>& shape) {
  return std::visit([](const auto& known) { return encode(known); }, shape);
}

template <int D>
Shape<D> decode_shape(std::string_view kind, std::span<const std::uint8_t> data) {
  if (D == 3 && kind == "surface") {
    if constexpr (D == 3) return decode_surface(data);
  }
  ByteReader in(data);
  Shape<D> shape;
  if (kind == "ball") {
    shape = Ball{get_size(in)};
  } else if (kind == "brick") {
    shape = decode_brick<D>(in);
  } else if (D == 2 && kind == "outline") {
    if constexpr (D == 2) shape = decode_outline(in);
  } else {
    fail_damaged("there is no shape '" + std::string(kind) + "' in " + std::to_string(D) + "D");
  }
  if (!in.empty()) fail_damaged("a shape has more numbers than its kind");
  return shape;
}

template <int D>
std::string count_shapes(std::span<const Shape<D>> shapes) {
  const std::array<const char*, 3> names{"ball", "brick", D == 2 ? "outline" : "surface"};
  std::array<std::uint64_t, names.size()> counts{};
  for (const Shape<D>& shape : shapes) ++counts[shape.index()];
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (counts[k] > 0) text += (text.empty() ? "" : ", ") + counted(counts[k], names[k]);
  return text;
}

template <int D>
std::uint32_t ShapeNumbers<D>::number_of(const Shape<D>& shape) {
  ShapeText text = encode_shape<D>(shape);
  const auto number = static_cast<std::uint32_t>(shapes_.size());
  const auto [known, is_new] = numbers_.try_emplace(std::move(text), number);
  if (is_new) {
    shapes_.push_back(shape);
    new_.emplace_back(number, known->first);
  }
  return known->second;
}

template <int D>
std::vector<std::pair<std::uint32_t, ShapeText>> ShapeNumbers<D>::take_new() {
  return std::exchange(new_, {});
}

#define KERF_INSTANTIATE(D)                                                           \
  template ShapeText encode_shape<D>(const Shape<D>&);                                \
  template Shape<D> decode_shape<D>(std::string_view, std::span<const std::uint8_t>); \
  template std::string count_shapes<D>(std::span<const Shape<D>>);                    \
  template class ShapeNumbers<D>;
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
