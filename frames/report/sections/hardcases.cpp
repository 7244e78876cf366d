#include <algorithm>
#include <array>
#include <stdexcept>

#include "core/files/whole_file.h"
#include "frames/page/plot.h"
#include "frames/report/section.h"
#include "frames/support/errors.h"

namespace kerf {
namespace {

/// In the order of tests/hard/report and of the colours of plots; inapplicable cells are grey.
constexpr std::array kVerdicts{"exact", "extra", "twice", "broken", "missed", "time-out", "n.a.", "crash"};

int kind_of(const std::string& verdict) {
  const auto found = std::find(kVerdicts.begin(), kVerdicts.end(), verdict);
  if (found == kVerdicts.end()) throw std::runtime_error("the verdict '" + verdict + "' is unknown");
  return static_cast<int>(found - kVerdicts.begin());
}

/// The table of one dimension; without columns if there are none.
HeatMap map_of(const Json& table, int dimension) {
  HeatMap map;
  map.kind_names.assign(kVerdicts.begin(), kVerdicts.end());
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < table.at("columns").size(); ++k) {
    const Json& column = table["columns"][k];
    if (column.at("dimension") != dimension) continue;
    columns.push_back(k);
    map.columns.push_back((column.at("who") == "kerf" ? "kerf " : "") + column.at("name").get<std::string>());
  }
  for (const Json& row : table.at("cases")) {
    map.rows.push_back(row.at("id").get<std::string>() + " " + row.at("name").get<std::string>());
    map.kinds.emplace_back();
    for (const std::size_t k : columns)
      map.kinds.back().push_back(kind_of(row.at("cells").at(k).at("verdict").get<std::string>()));
  }
  return map;
}

/// In 2D and 3D. Throws std::runtime_error for a table that is not as `./run hardcases` makes it.
std::array<HeatMap, 2> maps_of(const Json& table) {
  if (!table.at("columns").is_array() || !table.at("cases").is_array() || table["cases"].empty())
    throw std::runtime_error("columns and cases are two lists");
  std::array<HeatMap, 2> maps{map_of(table, 2), map_of(table, 3)};
  if (maps[0].columns.empty() && maps[1].columns.empty())
    throw std::runtime_error("there is no column of 2D or 3D");
  return maps;
}

/// Throws UsageError with the file for one that `maps_of` refuses.
std::array<HeatMap, 2> read_maps(const Json& table, const std::filesystem::path& file) {
  std::string why;
  try {
    return maps_of(table);
  } catch (const Json::exception&) {
    why = "a part is missing or of another kind";
  } catch (const std::runtime_error& error) {
    why = error.what();
  }
  throw UsageError(file.string() + " is no table of hard cases: " + why + "; ./run hardcases makes it anew");
}

void write_maps(const std::array<HeatMap, 2>& maps, Page& page) {
  page.paragraph(
      "What a broad phase must survive (docs/HARD_CASES.md), for kerf with each volume and for other "
      "libraries. Grey cells do not apply.");
  for (std::size_t k = 0; k < maps.size(); ++k) {
    const HeatMap& map = maps[k];
    if (map.columns.empty()) continue;
    const std::string dimension = std::to_string(k + 2);
    page.heading(dimension + "D");
    page.figure(draw(map, "hardcases" + dimension),
                "Verdicts by case and broad phase; the worst of all attempts counts.");
  }
}

void write(const ReportRequest& request, const CellStore& /*store*/, Page& page) {
  const std::filesystem::path file = request.hardcases / "hardcases.json";
  const Json table = Json::parse(read_whole_file_if_there(file).value_or(""), nullptr, false);
  if (table.is_object() && table.contains("columns") && table.contains("cases")) {
    write_maps(read_maps(table, file), page);
  } else {
    page.paragraph("There is no table of hard cases in " + file.string() +
                   ". Make it with ./run hardcases, which takes some minutes, and make this page again; "
                   "--hardcases FOLDER names another place.");
  }
  page.command("./run hardcases && " + command_of(request, "hardcases"));
}

}  // namespace

Section hardcases_section() {
  return {"hardcases", "Hard cases", [](const ReportRequest&) { return std::vector<Cell>{}; }, write};
}

}  // namespace kerf
