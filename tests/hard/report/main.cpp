// The table of the hard cases: ours with each volume and the rivals, each trial in a process of its own.
// usage: kerf_hardcases [FOLDER [CASE]]; CASE is a part of "V4_PointsAndFlatPlates".

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "frames/atomic_file.h"
#include "tests/hard/report/output.h"
#include "tests/hard/report/picture.h"
#include "viz/image/png.h"

namespace {

using namespace kerf;
using namespace kerf::test;

constexpr unsigned kAtOnce = 2;
constexpr std::uint32_t kBricks = 3000;

/// 0 if nothing of ours is wrong.
int faults(const Table& table, std::span<const VolumeFigure> figures) {
  int count = 0;
  for (const Row& row : table.rows)
    for (std::size_t i = 0; i < row.cells.size(); ++i)
      if (table.columns[i].ours && row.cells[i].worst.verdict != Verdict::exact) ++count;
  for (const VolumeFigure& figure : figures)
    if (figure.missed > 0) ++count;
  return count;
}

int report(const std::filesystem::path& folder, std::string_view only) {
  make_writable_folder(folder);
  const Table table = make_table(only, {}, kAtOnce, [](const HardCase& hard_case) {
    std::fprintf(stderr, "%s %s\n", hard_case.id.data(), hard_case.name.data());
  });
  if (table.rows.empty()) {
    std::fprintf(stderr, "kerf_hardcases: no case is called \"%s\"\n", std::string(only).c_str());
    return 2;
  }
  print(table);
  write_json(folder / "hardcases.json", table);
  write_png(folder / "hardcases.png", draw_table(table));
  std::vector<VolumeFigure> figures;
  if (only.empty()) {
    figures = measure_volumes(kBricks);
    print(figures);
    write_json(folder / "volumes.json", figures);
  }
  const int wrong = faults(table, figures);
  std::printf("\n%s. In %s: hardcases.json, hardcases.png%s\n",
              wrong == 0 ? "Kerf is exact everywhere" : (std::to_string(wrong) + " FAULTS OF KERF").c_str(),
              std::filesystem::absolute(folder).c_str(), only.empty() ? ", volumes.json" : "");
  return wrong == 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    return report(count > 1 ? arguments[1] : "out/hardcases", count > 2 ? arguments[2] : "");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "kerf_hardcases: %s\n", error.what());
    return 1;
  }
}
