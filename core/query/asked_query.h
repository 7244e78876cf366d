#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "core/spatial/query.h"

namespace kerf {

/// What can be asked of the boxes of a moment: which a ray hits, which overlap a box or a sphere, which are
/// the nearest to a point.
template <int D>
using AskedQuery = std::variant<Ray<D>, Box<D>, Sphere<D>, Nearest<D>>;

enum class QueryKind : std::uint8_t { ray, box, sphere, nearest };
inline constexpr std::array<std::string_view, 4> kQueryKindNames{"ray", "box", "sphere", "nearest"};

/// The numbers of a kind, for messages: "OX,OY,DX,DY".
template <int D>
std::string form_of(QueryKind kind);

/// Reads the numbers of a kind, with commas between them: of a ray its origin and its direction, of a box its
/// lower and its upper corner, of a sphere its centre and its radius, of the nearest a point and their count.
/// Throws std::invalid_argument that says which form is expected.
template <int D>
AskedQuery<D> parse_query(QueryKind kind, std::string_view numbers);

/// The same of a text that begins with the kind: "ray 0,2,1,0".
template <int D>
AskedQuery<D> parse_query(std::string_view text);

/// "the ray from (0, 2) along (1, 0)"
template <int D>
std::string to_text(const AskedQuery<D>& query);

}  // namespace kerf
