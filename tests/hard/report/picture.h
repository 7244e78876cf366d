#pragma once

#include "tests/hard/report/table.h"
#include "viz/image/image.h"

namespace kerf::test {

/// The table as a heat map: a row a case, a column a volume of ours or a rival, the verdict as colour and as
/// a sign. The colours are distinct with any kind of colour vision.
Image draw_table(const Table& table);

}  // namespace kerf::test
