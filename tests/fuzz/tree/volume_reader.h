#pragma once

#include "core/base/random.h"
#include "core/geometry/volume.h"
#include "tests/fuzz/tree/byte_reader.h"
#include "tests/property/hard_volumes.h"

namespace kerf::test {

/// Makes volumes of the bytes of a fuzz case: boxes on a small grid, whose faces meet all the time, hard
/// volumes near each other, and numbers of any bit pattern, which need not be a volume at all.
template <int D>
class VolumeReader {
 public:
  VolumeReader(VolumeKind kind, ByteReader& bytes)
      : kind_(kind), bytes_(bytes), random_(bytes.byte()), hard_(kind, random_) {}

  Volume<D> read();

 private:
  Box<D> grid_box();
  Volume<D> any_numbers();

  VolumeKind kind_;
  ByteReader& bytes_;
  Random random_;
  HardVolumes<D> hard_;
};

}  // namespace kerf::test
