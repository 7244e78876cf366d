// The table of the hard cases: ours with each volume and the rivals, each trial in a process of its own.
// usage: kerf_hardcases [--overwrite] [FOLDER [CASE]]; CASE is a part of "V4_PointsAndFlatPlates".

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "frames/support/atomic_file.h"
#include "frames/support/outputs.h"
#include "tests/hard/report/output.h"
#include "tests/hard/report/picture.h"
#include "viz/image/png.h"

namespace {

using namespace kerf;
using namespace kerf::test;

/// What is wrong with ours, in cells of the table.
struct Faults {
  int wrong = 0;  ///< anything but exact
  int late = 0;   ///< exact as far as it came, which was not to the end

  void print(const std::filesystem::path& folder) const {
    if (wrong + late == 0) {
      std::printf("\nKerf is exact everywhere.");
    } else {
      std::printf("\nKERF IS WRONG %d TIMES, TOO SLOW %d TIMES.", wrong, late);
    }
    std::printf(" Files are in %s\n", std::filesystem::absolute(folder).c_str());
  }
};

void count(const Table& table, Faults& faults) {
  for (const Row& row : table.rows) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const Verdict verdict = row.cells[i].worst.verdict;
      if (!table.columns[i].ours || verdict == Verdict::exact) continue;
      ++(verdict == Verdict::time_out ? faults.late : faults.wrong);
    }
  }
}

/// False if no case has such a name.
bool report_cases(const std::filesystem::path& folder, std::string_view only, Faults& faults) {
  const unsigned at_once = std::max(1U, std::thread::hardware_concurrency());
  const Table table = make_table(only, {}, at_once, [](const HardCase& hard_case) {
    std::fprintf(stderr, "%s %s\n", hard_case.id.data(), hard_case.name.data());
  });
  if (table.rows.empty()) return false;
  print(table);
  std::fflush(stdout);
  write_json(folder / "hardcases.json", table);
  write_png(folder / "hardcases.png", draw_table(table));
  count(table, faults);
  return true;
}

int report(const std::filesystem::path& folder, std::string_view only, bool overwrite) {
  Outputs outputs({}, overwrite);
  outputs.add_folder(folder);
  for (const char* const file : {"hardcases.json", "hardcases.png"}) outputs.add_file(folder / file);
  make_writable_folder(folder);
  Faults faults;
  if (!report_cases(folder, only, faults)) {
    std::fprintf(stderr, "kerf_hardcases: no case is called \"%s\"\n", std::string(only).c_str());
    return 2;
  }
  faults.print(folder);
  return faults.wrong + faults.late == 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  std::vector<std::string> words(arguments + 1, arguments + count);
  const bool overwrite = !words.empty() && words.front() == "--overwrite";
  if (overwrite) words.erase(words.begin());
  words.resize(2);
  try {
    return report(words[0].empty() ? "out/hardcases" : words[0], words[1], overwrite);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "kerf_hardcases: %s\n", error.what());
    return 1;
  }
}
