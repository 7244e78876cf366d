#include "frames/study/matrix.h"

namespace kerf {

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
