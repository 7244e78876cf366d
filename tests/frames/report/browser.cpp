#include "tests/frames/report/browser.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/frames/program.h"

namespace kerf::test {
namespace {

constexpr std::string_view kBegin = "SIGHT{{{";
constexpr std::string_view kEnd = "}}}SIGHT";

/// Writes what it sees into the page, where --dump-dom finds it.
constexpr std::string_view kScript = R"(
addEventListener("load", () => {
  const answer = act();
  const pictures = [...document.querySelectorAll("svg")].map(svg => {
    const box = svg.getBoundingClientRect();
    const shapes = [...svg.querySelectorAll("path,text,circle,polygon,use,rect")].filter(shape => {
      const size = shape.getBoundingClientRect();
      return size.width > 0 || size.height > 0;
    });
    return {width: box.width, height: box.height, shapes: shapes.length};
  });
  const sight = {
    pictures: pictures,
    resources: performance.getEntriesByType("resource").map(entry => entry.name),
    images: [...document.images].map(image => image.naturalWidth),
    answer: String(answer || ""),
    fits: document.documentElement.scrollWidth <= document.documentElement.clientWidth,
  };
  const note = document.createElement("pre");
  note.textContent = "SIGHT{{{" + JSON.stringify(sight) + "}}}SIGHT";
  document.body.append(note);
});
</script>)";

std::vector<std::string> console_lines(const std::string& log) {
  std::vector<std::string> lines;
  std::istringstream stream(log);
  for (std::string line; std::getline(stream, line);)
    if (line.find(":CONSOLE") != std::string::npos) lines.push_back(line);
  return lines;
}

void read(const std::string& text, Sight& sight) {
  const auto seen = nlohmann::json::parse(text);
  for (const auto& picture : seen.at("pictures"))
    sight.pictures.push_back({picture.at("width"), picture.at("height"), picture.at("shapes")});
  sight.resources = seen.at("resources").get<std::vector<std::string>>();
  sight.fits = seen.at("fits");
  sight.images = seen.at("images").get<std::vector<int>>();
  sight.answer = seen.at("answer");
}

}  // namespace

Sight look_at(const std::filesystem::path& page, const std::string& act) {
  const TemporaryFolder folder;
  std::string text = read_text(page);
  text.insert(text.find("<style>"), "<script>function act() {" + act + "}" + std::string(kScript));
  const std::filesystem::path copy = folder.path() / "page.html";
  std::ofstream(copy) << text;
  // No name is found and nothing answers, so that only what the page brings along can be there.
  Process chromium({"chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                    "--host-resolver-rules=MAP * ~NOTFOUND", "--user-data-dir=" + folder.path().string(),
                    "--window-size=1200,900", "--enable-logging=stderr", "--dump-dom",
                    "file://" + copy.string()});
  const RunOutcome outcome = chromium.wait();
  Sight sight;
  sight.console = console_lines(outcome.err);
  const std::size_t begin = outcome.out.rfind(kBegin);
  const std::size_t end = outcome.out.rfind(kEnd);
  if (outcome.exit != 0 || begin == std::string::npos || end == std::string::npos) {
    sight.trouble = "chromium ended with " + std::to_string(outcome.exit) + ": " + outcome.err;
    return sight;
  }
  read(outcome.out.substr(begin + kBegin.size(), end - begin - kBegin.size()), sight);
  return sight;
}

}  // namespace kerf::test
