#include "viz/image/flip_color.h"

#include <cmath>

namespace kerf::flip_color {
namespace {

// linear sRGB to CIE XYZ; the primaries of Rec. 709 as fractions, and the inverse.
constexpr double kXyz[3][3] = {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                               {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                               {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};
constexpr double kRgb[3][3] = {{3.241003275, -1.537398934, -0.498615861},
                               {-0.969224334, 1.875930071, 0.041554224},
                               {0.055639423, -0.204011202, 1.057148933}};
constexpr double kWhite[3] = {0.950428545, 1.0, 1.088900371};

Triple times(const double (&m)[3][3], const Triple& v) {
  Triple result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = static_cast<float>(m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2]);
  return result;
}

Triple relative_xyz(const Triple& linear_rgb) {
  Triple xyz = times(kXyz, linear_rgb);
  for (std::size_t i = 0; i < 3; ++i) xyz[i] = static_cast<float>(xyz[i] / kWhite[i]);
  return xyz;
}

Triple opponents(const Triple& xyz) {
  return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

float lab_curve(float t) {
  constexpr float kDelta = 6.0F / 29.0F;
  return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0F / 29.0F;
}

float linear(double srgb) {
  return static_cast<float>(srgb > 0.04045 ? std::pow((srgb + 0.055) / 1.055, 2.4) : srgb / 12.92);
}

std::array<float, 256> make_linear_table() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = linear(static_cast<double>(i) / 255.0);
  return table;
}

}  // namespace

Triple linear_rgb(const std::uint8_t* rgba) {
  static const std::array<float, 256> kTable = make_linear_table();
  if (rgba[3] == 255) return {kTable[rgba[0]], kTable[rgba[1]], kTable[rgba[2]]};
  Triple result;
  for (std::size_t c = 0; c < 3; ++c)
    result[c] = linear((rgba[c] * rgba[3] + 255.0 * (255 - rgba[3])) / (255.0 * 255.0));
  return result;
}

Triple ycxcz(const Triple& linear_rgb) { return opponents(relative_xyz(linear_rgb)); }

Triple linear_rgb_of_ycxcz(const Triple& ycxcz) {
  const float y = (ycxcz[0] + 16) / 116;
  const Triple relative{y + ycxcz[1] / 500, y, y - ycxcz[2] / 200};
  Triple xyz;
  for (std::size_t i = 0; i < 3; ++i) xyz[i] = static_cast<float>(relative[i] * kWhite[i]);
  return times(kRgb, xyz);
}

Triple hunt_lab(const Triple& linear_rgb) {
  Triple xyz = relative_xyz(linear_rgb);
  for (float& value : xyz) value = lab_curve(value);
  Triple lab = opponents(xyz);
  lab[1] *= 0.01F * lab[0];
  lab[2] *= 0.01F * lab[0];
  return lab;
}

float hyab(const Triple& a, const Triple& b) {
  const float da = a[1] - b[1];
  const float db = a[2] - b[2];
  return std::abs(a[0] - b[0]) + std::sqrt(da * da + db * db);
}

}  // namespace kerf::flip_color
