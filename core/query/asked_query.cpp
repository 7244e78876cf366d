#include "core/query/asked_query.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "core/base/counted.h"
#include "core/base/float_mode.h"
#include "core/base/number_text.h"
#include "core/base/overloaded.h"
#include "core/query/text.h"

namespace kerf {
namespace {

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

std::optional<Scalar> parse_coordinate(std::string_view text) {
  const auto number = read_number<Scalar>(trimmed(text));
  return number && std::isfinite(*number) ? number : std::nullopt;
}

/// None if one of them is none.
std::optional<std::vector<Scalar>> parse_coordinates(std::string_view text) {
  std::vector<Scalar> numbers;
  while (true) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const auto number = parse_coordinate(text.substr(0, comma));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    if (comma == text.size()) return numbers;
    text.remove_prefix(comma + 1);
  }
}

template <int D>
Vector<D> vector_at(const std::vector<Scalar>& numbers, std::size_t first) {
  Vector<D> v;
  for (std::size_t i = 0; i < D; ++i) v.value[i] = numbers[first + i];
  return v;
}

template <int D>
std::size_t numbers_of(QueryKind kind) {
  return kind == QueryKind::ray || kind == QueryKind::box ? 2 * D : D + 1;
}

template <int D>
[[noreturn]] void refuse(QueryKind kind, std::string_view numbers) {
  throw std::invalid_argument("'" + std::string(numbers) + "' is not of the form " + form_of<D>(kind));
}

template <int D>
std::string vector_text(const Vector<D>& v) {
  std::string text = "(";
  for (int i = 0; i < D; ++i) text += (i == 0 ? "" : ", ") + number_text(static_cast<double>(v[i]));
  return text + ")";
}

}  // namespace

template <int D>
std::string form_of(QueryKind kind) {
  switch (kind) {
    case QueryKind::ray:
      return D == 2 ? "OX,OY,DX,DY, for example 0,1.5,1,0" : "OX,OY,OZ,DX,DY,DZ, for example 0,1.5,2,1,0,0";
    case QueryKind::box:
      return D == 2 ? "MIN_X,MIN_Y,MAX_X,MAX_Y, for example 0,0,2,1"
                    : "MIN_X,MIN_Y,MIN_Z,MAX_X,MAX_Y,MAX_Z, for example 0,0,0,2,1,1";
    case QueryKind::sphere:
      return D == 2 ? "X,Y,RADIUS, for example 0,1.5,2" : "X,Y,Z,RADIUS, for example 0,1.5,0,2";
    case QueryKind::nearest:
      break;
  }
  return D == 2 ? "X,Y,COUNT, for example 0,1.5,4" : "X,Y,Z,COUNT, for example 0,1.5,0,4";
}

template <int D>
AskedQuery<D> parse_query(QueryKind kind, std::string_view numbers) {
  const DefaultFloats floats;
  const auto parsed = parse_coordinates(numbers);
  if (!parsed || parsed->size() != numbers_of<D>(kind)) refuse<D>(kind, numbers);
  const Vector<D> first = vector_at<D>(*parsed, 0);
  const Scalar last = parsed->back();
  switch (kind) {
    case QueryKind::ray:
      return Ray<D>{first, vector_at<D>(*parsed, D)};
    case QueryKind::box:
      return Box<D>{first, vector_at<D>(*parsed, D)};
    case QueryKind::sphere:
      return Sphere<D>{first, last};
    case QueryKind::nearest:
      break;
  }
  constexpr Scalar kMost = 1'000'000;
  if (last < 1 || last > kMost || last != std::floor(last)) refuse<D>(kind, numbers);
  return Nearest<D>{first, static_cast<std::size_t>(last)};
}

template <int D>
AskedQuery<D> parse_query(std::string_view text) {
  text = trimmed(text);
  const std::size_t blank = std::min(text.find(' '), text.size());
  const auto kind = std::ranges::find(kQueryKindNames, text.substr(0, blank));
  if (kind == kQueryKindNames.end())
    throw std::invalid_argument("'" + std::string(text) +
                                "' asks for nothing: begin with ray, box, sphere or nearest");
  return parse_query<D>(static_cast<QueryKind>(kind - kQueryKindNames.begin()), trimmed(text.substr(blank)));
}

template <int D>
std::string to_text(const AskedQuery<D>& query) {
  const DefaultFloats floats;
  return std::visit(
      Overloaded{[](const Ray<D>& ray) {
                   return "the ray from " + vector_text(ray.origin) + " along " + vector_text(ray.direction);
                 },
                 [](const Box<D>& box) {
                   return "the box from " + vector_text(box.min) + " to " + vector_text(box.max);
                 },
                 [](const Sphere<D>& sphere) {
                   if (sphere.radius == 0) return "the point " + vector_text(sphere.center);
                   return "the sphere around " + vector_text(sphere.center) + " of radius " +
                          number_text(static_cast<double>(sphere.radius));
                 },
                 [](const Nearest<D>& nearest) { return "the point " + vector_text(nearest.point); }},
      query);
}

#define KERF_INSTANTIATE(D)                                           \
  template std::string form_of<D>(QueryKind);                         \
  template AskedQuery<D> parse_query<D>(QueryKind, std::string_view); \
  template AskedQuery<D> parse_query<D>(std::string_view);            \
  template std::string to_text<D>(const AskedQuery<D>&);
KERF_INSTANTIATE(2)
KERF_INSTANTIATE(3)
#undef KERF_INSTANTIATE

}  // namespace kerf
