#include "frames/study/matrix.h"

#include <string>

namespace kerf {

void refuse_too_many(const JsonObject& matrix, double cells) {
  constexpr int kMost = 1'000'000;
  if (cells > kMost)
    matrix.refuse("repeats", "more than " + std::to_string(kMost) + " cells; make several studies");
}

std::vector<StudyCell> read_matrix(JsonObject& matrix, const std::filesystem::path& folder) {
  const bool runs = matrix.has("motions") || matrix.has("scenes");
  if (runs == matrix.has("recording") || (matrix.has("motions") && matrix.has("scenes")))
    matrix.refuse("motions",
                  "a matrix has one of \"motions\" (of kerf bench), \"scenes\" (of kerf scenes) and "
                  "\"recording\" (of which frames are rendered)");
  std::vector<StudyCell> cells = runs ? read_runs(matrix) : read_frames(matrix, folder);
  const auto patience = static_cast<double>(matrix.number("patience", 1, 1'000'000, 3600));
  matrix.refuse_the_rest();
  for (StudyCell& cell : cells) cell.patience = patience;
  return cells;
}

}  // namespace kerf
