#include "tests/fuzz/tree/volume_reader.h"

namespace kerf::test {

template <int D>
Volume<D> VolumeReader<D>::read() {
  const std::uint32_t sort = bytes_.below(64);
  if (sort < 24) return enclose<D>(grid_box(), kind_);
  if (sort < 28) return make_box_volume(grid_box());  // whatever the kind: a caller may give just a box
  if (sort < 29) return any_numbers();
  if (sort < 30) hard_.begin_cluster();
  random_ = Random((std::uint64_t{bytes_.byte()} << 8U) | bytes_.byte());
  return hard_.next();
}

template <int D>
Box<D> VolumeReader<D>::grid_box() {
  Box<D> box;
  for (int i = 0; i < D; ++i) {
    const std::uint8_t both = bytes_.byte();
    box.min[i] = static_cast<Scalar>(both & 15U) - 8;
    box.max[i] = box.min[i] + static_cast<Scalar>((both >> 4U) & 7U) / 2;
  }
  return box;
}

template <int D>
Volume<D> VolumeReader<D>::any_numbers() {
  Volume<D> volume = enclose<D>(grid_box(), kind_);
  const int extra = extra_size<D>(kind_);
  const std::uint32_t count = 1 + bytes_.below(3);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto place = static_cast<int>(bytes_.below(static_cast<std::uint32_t>(2 * D + extra)));
    const Scalar value = bytes_.any_scalar();
    if (place < D)
      volume.box.min[place] = value;
    else if (place < 2 * D)
      volume.box.max[place - D] = value;
    else
      volume.extra[static_cast<std::size_t>(place - 2 * D)] = value;
  }
  return volume;
}

template class VolumeReader<2>;
template class VolumeReader<3>;

}  // namespace kerf::test
