#pragma once

#include <cstddef>
#include <cstdint>

namespace kerf::tuning {

// The numbers of the sweep by bytes (ByteSweep), each beside what it was measured on, as in
// core/base/tuning.h.

/// Sums or maxima side by side, each of which waits for its predecessor. Brownian, 4,250 objects: 51.1 ->
/// 46.4 ns in 3D (AVX-512), with bytes that are made faster.
inline constexpr std::size_t kChains = 4;
/// Rows of findings that are confirmed in one go, and findings where rows are spread over a list: what fits
/// into half of the first cache.
inline constexpr std::size_t kConfirmRows = 512;
inline constexpr std::size_t kConfirmListed = 1024;
/// Boxes of a leaf by which the bytes' scale is drawn in where a few boxes lie far away, and the least leaf
/// in which they are looked at. 1,000 objects of which one has left the scene, 2D and 3D: 1,400 -> 30 us.
inline constexpr std::size_t kScaleSample = 32;
inline constexpr std::size_t kLeastSampled = 64;
/// Sure pairs in a row of 64 entries above which they are separated from those that floats confirm. Scene
/// dense: above some ten pairs an object it pays, in scenes with four it does not.
inline constexpr float kSurePerRow = 7;
/// Rows of a leaf in which they are counted: by the mean lengths of boxes rods look dense, and rings sparse.
/// Below so many entries only leaves are counted that are dense by mean lengths.
inline constexpr std::uint32_t kDensityRows = 8;
inline constexpr std::uint32_t kLeastCrowd = 256;
/// kSurePerRow where few entries begin before another one ends. Boxes of one size on a line, 2D, with seven
/// pairs each: a step takes 13 % less time.
inline constexpr float kSurePerShortRow = 4;
/// So few entries, in the mean. Then rows are 32 long, where vectors of bytes are no longer than that.
/// Boxes on a line, 2D, 2,000 objects with 10 and 15 pairs each: 8 to 12 % (AVX2).
inline constexpr float kShortRow = 24;
/// Steps of the axis along which entries are ordered, where bytes are too coarse for it: where more entries
/// than so many begin at the byte at which another one ends and meet it on the other axes, so that floats
/// must confirm them. The same boxes: 15 to 20 %; where they fill a square or a cube nothing is gained.
inline constexpr std::size_t kFineSteps = 1024;
inline constexpr float kTooCoarse = 2;
/// Entries that meet an entry by bytes though they begin at the byte at which it ends, of all behind it:
/// above that boxes lie in clumps, which are looked for; where none is, floats are swept. Of 2,000 boxes at
/// the corners of a grid 3 do, and floats take 1.5 times as long as bytes.
inline constexpr float kClumped = 8;
/// Entries of a clump that is swept by itself; smaller ones share a part.
inline constexpr std::size_t kLeastClump = 24;
/// Entries of a part in the mean: with smaller ones floats are swept. Clumps of 25 and 60 far apart, 2D and
/// 3D: 5 to 10 % less time; of 150: up to 20 % more.
inline constexpr std::size_t kLeastMeanClump = 64;
/// Items from which on a radix sort takes digits of eleven bits instead of eight. The same, leaves of 1,000:
/// 1 to 5 %.
inline constexpr std::size_t kLeastLongDigits = 2000;
/// Boxes by which the axis is chosen along which floats are swept.
inline constexpr std::size_t kAxisSample = 64;
/// Boxes by whose bytes the size of clumps is estimated before anything is ordered. Clumps of 25: 10 to 15 %.
inline constexpr std::uint32_t kClumpSample = 48;
/// Boxes that are so many bytes long may reach across gaps, and so many of them at most are in each part.
inline constexpr int kLongBox = 32;
inline constexpr std::size_t kMostLong = 8;
/// Boxes shorter than so many bytes along each axis, in the mean, may lie in clumps: rows of leaves below
/// kLeastCrowd are counted then, too.
inline constexpr float kTinyBox = 3;

}  // namespace kerf::tuning
