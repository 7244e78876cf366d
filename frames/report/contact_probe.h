#pragma once

#include <type_traits>

#include "frames/report/contact_probe_2d.h"
#include "frames/report/contact_probe_3d.h"

namespace kerf {

template <int D>
using ContactProbe = std::conditional_t<D == 2, ContactProbe2, ContactProbe3>;

}  // namespace kerf
