#pragma once

#include "viz/draw/color.h"

namespace kerf {

/// The contrast of two colours by the Web Content Accessibility Guidelines 2.2: 1 (none) to 21. Text
/// needs 4.5, a mark 3.
double contrast(Color a, Color b);

}  // namespace kerf
