#include <fstream>

#include "frames/import/given_nodes.h"
#include "frames/import/given_objects.h"
#include "frames/import/given_pairs.h"
#include "frames/import/survey.h"
#include "frames/support/errors.h"
#include "frames/support/scratch_folder.h"
#include "tests/fuzz/parsers/parser_cases.h"

namespace kerf::test {
namespace {

/// Reads the table with a function; errors name the file.
template <class Read>
std::string try_table(const std::filesystem::path& file, Read read) {
  try {
    read();
    return "";
  } catch (const UsageError& error) {
    return std::string(error.what()).find(file.filename()) == std::string::npos
               ? "an error that does not name the file: " + std::string(error.what())
               : "";
  }
}

/// Every line is read twice, as an import does.
void read_boxes(const std::filesystem::path& file, Oddities& oddities) {
  BoxLines boxes(file);
  const Survey all = survey(boxes, {}, "", {}, "", oddities);
  boxes.rewind();
  while (boxes.next())
    if (const auto object = boxes.object()) (void)all.object(*object);
  boxes.rewind();
  while (boxes.next()) (void)boxes.read();
}

}  // namespace

std::string csv_case(CaseBytes bytes) {
  static const ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "table.csv";
  std::ofstream(file, std::ios::binary) << std::string(bytes.begin(), bytes.end());
  using Read = void (*)(const std::filesystem::path& file, Oddities& oddities);
  for (const Read read :
       {Read{read_boxes}, Read{[](const auto&it, auto&odd) { (void)read_given_pairs(it, odd); }},
        Read{[](const auto&it, auto&odd) { (void)read_given_nodes(it, 2, odd); }},
        Read{[](const auto&it, auto&odd) { (void)read_given_objects<2>(it, odd); }},
        Read{[](const auto&it, auto&odd) { (void)read_given_objects<3>(it, odd); }}}) {
    Oddities oddities;
    std::string complaint = try_table(file, [&] { read(file, oddities); });
    if (!complaint.empty()) return complaint;
  }
  return "";
}

}  // namespace kerf::test
