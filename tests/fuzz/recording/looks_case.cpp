#include <stdexcept>

#include "core/recording/compression.h"
#include "core/recording/look_codec.h"
#include "core/recording/shape_rows.h"
#include "tests/fuzz/recording/recording_cases.h"

namespace kerf::test {
namespace {

template <class Work>
std::string try_to(Work work) {
  try {
    return work();
  } catch (const std::runtime_error& error) {
    return error.what()[0] == '\0' ? "an error without a message" : "";
  }
}

template <int D>
std::string shape_case(const char* kind, CaseBytes bytes) {
  return try_to([&]() -> std::string {
    const Shape<D> shape = decode_shape<D>(kind, bytes);
    const ShapeText text = encode_shape<D>(shape);
    const Shape<D> again = decode_shape<D>(text.kind, text.data);
    return encode_shape<D>(again) == text ? "" : "written again, a shape is another";
  });
}

template <int D>
std::string keyframe_looks_case(CaseBytes bytes) {
  constexpr std::size_t kObjects = 200;
  return try_to([&]() -> std::string {
    const Looks<D> looks = decode_looks<D>(compress(bytes), kObjects);
    return decode_looks<D>(encode_looks(looks), kObjects) == looks ? "" : "written again, looks are others";
  });
}

template <int D>
std::string looks_case_in(CaseBytes bytes) {
  for (const char* const kind : {"ball", "brick", D == 2 ? "outline" : "surface"}) {
    const Bytes packed = compress(bytes);
    const bool is_packed = kind == std::string_view("surface");
    if (std::string wrong = shape_case<D>(kind, is_packed ? CaseBytes(packed) : bytes); !wrong.empty())
      return wrong;
  }
  return keyframe_looks_case<D>(bytes);
}

}  // namespace

std::string looks_case(CaseBytes bytes) {
  std::string wrong = looks_case_in<2>(bytes);
  return wrong.empty() ? looks_case_in<3>(bytes) : wrong;
}

}  // namespace kerf::test
