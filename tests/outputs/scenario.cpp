#include "tests/outputs/scenario.h"

#include <fstream>
#include <stdexcept>

#include "tests/frames/program.h"

namespace kerf::faults {
namespace {

using Path = std::filesystem::path;
using Words = std::vector<std::string>;

constexpr const char* kSplit = "op==split && kind==acted";

void run(const Words& arguments) {
  const test::RunOutcome outcome = test::run_kerf(arguments);
  if (outcome.exit != 0) throw std::runtime_error(arguments.front() + " failed: " + outcome.err);
}

void write(const Path& file, const std::string& text) { std::ofstream(file) << text; }

void record(const Path& file, const char* steps) {
  run({"record", "pile", "-o", file, "--steps", steps, "--objects", "30", "--grow", "8", "--config",
       "min_threshold=4,max_threshold=8,schedule_interval=2"});
}

Words render(const Path& source, const Path& out, const char* steps = "1:9:4") {
  return {"render", source, "--steps", steps, "--size", "64x64", "--workers", "0", "--out", out};
}

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

Scenario record_scenario() {
  return {"record",
          [](const Path& folder) { record(folder / "out.kerf", "7"); },
          [](const Path& folder) -> Words {
            return {"record", "pile",      "-o", folder / "out.kerf", "--steps",
                    "60",     "--objects", "30", "--overwrite"};
          },
          {{"out.kerf", Likeness::same_recording}}};
}

Scenario import_scenario() {
  return {"import",
          [](const Path& folder) {
            record(folder / "out.kerf", "20");
            run({"export", folder / "out.kerf", "--boxes", "-o", folder / "boxes.csv"});
            record(folder / "out.kerf.old", "7");
            std::filesystem::rename(folder / "out.kerf.old", folder / "out.kerf");
          },
          [](const Path& folder) -> Words {
            return {"import", folder / "boxes.csv", "-o", folder / "out.kerf", "--overwrite"};
          },
          {{"out.kerf", Likeness::same_recording}}};
}

Scenario rerun_scenario() {
  return {"rerun",
          [](const Path& folder) {
            record(folder / "in.kerf", "20");
            record(folder / "out.kerf", "7");
          },
          [](const Path& folder) -> Words {
            return {"rerun",    folder / "in.kerf", "-o", folder / "out.kerf", "--overwrite",
                    "--config", "max_threshold=6"};
          },
          {{"out.kerf", Likeness::same_recording}}};
}

Scenario render_scenario() {
  return {"render",
          [](const Path& folder) {
            record(folder / "pile.kerf", "12");
            run(render(folder / "pile.kerf", folder / "frames", "2:11:3"));
            record(folder / "out.kerf", "7");
            write(folder / "film.gif", "an earlier film");
            write(folder / "sheet.png", "an earlier sheet");
          },
          [](const Path& folder) {
            return with(render("pile", folder / "frames"),
                        {"--objects", "20", "--record", folder / "out.kerf", "--video", folder / "film.gif",
                         "--contact-sheet", folder / "sheet.png", "--overwrite"});
          },
          {{"frames/frames.json", Likeness::same_manifest},
           {"frames/pile_000000.png"},
           {"frames/pile_000001.png"},
           {"frames/pile_000002.png"},
           {"out.kerf", Likeness::same_recording},
           {"film.gif"},
           {"sheet.png"}}};
}

Scenario collect_scenario() {
  return {"collect",
          [](const Path& folder) {
            record(folder / "in.kerf", "12");
            run(with(render(folder / "in.kerf", folder / "a"), {"--shard", "1/2"}));
            run(with(render(folder / "in.kerf", folder / "b"), {"--shard", "2/2"}));
            run(render(folder / "in.kerf", folder / "all", "2:11:3"));
            write(folder / "film.gif", "an earlier film");
          },
          [](const Path& folder) -> Words {
            return {"collect",      folder / "a", folder / "b",        "--out",
                    folder / "all", "--video",    folder / "film.gif", "--overwrite"};
          },
          {{"all/frames.json", Likeness::same_manifest},
           {"all/in_000000.png"},
           {"all/in_000001.png"},
           {"all/in_000002.png"},
           {"film.gif"}}};
}

Scenario minimize_scenario() {
  return {"minimize",
          [](const Path& folder) {
            record(folder / "in.kerf", "12");
            record(folder / "out.kerf", "7");
            write(folder / "out.png", "an earlier picture");
            write(folder / "out.cpp", "// Made by `kerf minimize`: an earlier test");
          },
          [](const Path& folder) -> Words {
            return {"minimize", folder / "in.kerf",  "--when",     kSplit,
                    "-o",       folder / "out.kerf", "--overwrite"};
          },
          {{"out.kerf", Likeness::same_recording}, {"out.png"}, {"out.cpp"}}};
}

Scenario report_scenario() {
  return {"report",
          [](const Path& folder) {
            std::filesystem::create_directory(folder / "hard");
            write(folder / "hard/hardcases.json",
                  R"({"columns":[{"dimension":2,"who":"kerf","name":"box"}],"cases":[
{"id":"V1","name":"NotANumber","what":"","cells":[{"verdict":"exact","sign":"="}]}]})");
            write(folder / "page.html", "an earlier page");
          },
          [](const Path& folder) -> Words {
            return {"report",     "hardcases",   "lag",           "--objects", "40",
                    "--steps",    "12",          "--rounds",      "1",         "--seeds",
                    "1",          "--hardcases", folder / "hard", "--out",     folder / "page.html",
                    "--overwrite"};
          },
          {{"page.html", Likeness::same_end}, {"page.json", Likeness::same_end}}};
}

Scenario study_scenario() {
  return {"study",
          [](const Path& folder) {
            write(folder / "study.json",
                  R"({"matrices": [{"motions": "uniform", "dimensions": 2, "objects": 40,
                "seeds": [1, 2], "warm_up": 1, "steps": 2, "measure": "counts"}]})");
            run({"study", folder / "study.json", "--out", folder / "cells"});
            std::filesystem::create_directory(folder / "joined");
            for (const char* const name : {"cells.csv", "cells.sqlite", "index.html"})
              write(folder / "joined" / name, "an earlier one");
          },
          [](const Path& folder) -> Words {
            return {"study", folder / "study.json", "--join",     folder / "cells",
                    "--out", folder / "joined",     "--overwrite"};
          },
          {{"joined/cells.csv", Likeness::same_bytes},
           {"joined/cells.sqlite", Likeness::same_bytes},
           {"joined/index.html", Likeness::same_lines}}};
}

/// Three of its simulations are done.
Scenario experiment_scenario() {
  const auto arguments = [](const Path& folder) -> Words {
    return {"experiment", "--steps", "50", "--objects", "50", "--seeds", "1", "--out", folder, "--overwrite"};
  };
  return {
      "experiment",
      [arguments](const Path& folder) {
        run(arguments(folder));
        std::filesystem::remove(folder / "simulation-4-buckets-seed-1-repeat-1.csv");
        for (const char* const name : {"experiment.md", "experiment.html", "figure-12.svg", "figure-13.png"})
          write(folder / name, "an earlier one");
      },
      arguments,
      {{"experiment.md", Likeness::same_end},
       {"experiment.html", Likeness::same_end},
       {"figure-12.svg", Likeness::same_end},
       {"figure-13.png", Likeness::same_end},
       {"simulation-4-buckets-seed-1-repeat-1.csv", Likeness::same_lines}}};
}

Scenario step_scenario() {
  return {"step --picture",
          [](const Path& folder) {
            record(folder / "in.kerf", "12");
            write(folder / "out.png", "an earlier picture");
          },
          [](const Path& folder) -> Words {
            return {"step",      folder / "in.kerf", "--to",       "step==9",
                    "--picture", folder / "out.png", "--overwrite"};
          },
          {{"out.png"}}};
}

Scenario export_scenario() {
  return {"export",
          [](const Path& folder) {
            record(folder / "in.kerf", "12");
            write(folder / "out.csv", "an earlier table");
          },
          [](const Path& folder) -> Words {
            return {"export", folder / "in.kerf", "--boxes", "-o", folder / "out.csv", "--overwrite"};
          },
          {{"out.csv"}}};
}

/// Two sequences of which one frame differs.
void render_two(const Path& folder) {
  record(folder / "in.kerf", "12");
  run(render(folder / "in.kerf", folder / "a", "9:9:1"));
  run(with(render(folder / "in.kerf", folder / "b", "9:9:1"), {"--show", "none"}));
}

Scenario film_diff_scenario() {
  return {"film-diff",
          [](const Path& folder) {
            render_two(folder);
            write(folder / "film.gif", "an earlier film");
            write(folder / "sheet.png", "an earlier sheet");
          },
          [](const Path& folder) -> Words {
            return {"film-diff",         folder / "a",      folder / "b",         "-o",
                    folder / "film.gif", "--contact-sheet", folder / "sheet.png", "--overwrite"};
          },
          {{"film.gif"}, {"sheet.png"}}};
}

Scenario film_scenario() {
  return {"film",
          [](const Path& folder) {
            record(folder / "in.kerf", "12");
            write(folder / "film.gif", "an earlier film");
            write(folder / "still.png", "an earlier picture");
          },
          [](const Path& folder) -> Words {
            return {"film",       folder / "in.kerf",
                    "-o",         folder / "film.gif",
                    "--still",    folder / "still.png",
                    "--size",     "640x360",
                    "--seconds",  "2",
                    "--fps",      "2",
                    "--overwrite"};
          },
          {{"film.gif"}, {"still.png"}}};
}

Scenario approve_scenario() {
  return {"diff --approve",
          render_two,
          [](const Path& folder) -> Words {
            return {"diff", folder / "a", folder / "b", "--approve"};
          },
          {{"a/in_000000.png"}}};
}

Scenario diff_page_scenario() {
  return {"diff --report",
          [](const Path& folder) {
            render_two(folder);
            std::filesystem::create_directory(folder / "page");
            write(folder / "page/index.html", "an earlier page");
          },
          [](const Path& folder) -> Words {
            return {"diff", folder / "a", folder / "a", "--report", folder / "page", "--overwrite"};
          },
          {{"page/index.html", Likeness::same_end}}};
}

Scenario debug_scenario() {
  return {"debug",
          [](const Path& folder) {
            write(folder / "script", "key end\nscreenshot shot\n");
            record(folder / "out.kerf", "7");
            std::filesystem::create_directory(folder / "pictures");
            write(folder / "pictures/shot.png", "an earlier picture");
          },
          [](const Path& folder) -> Words {
            return {"debug",
                    "pile",
                    "--steps",
                    "12",
                    "--objects",
                    "20",
                    "--record",
                    folder / "out.kerf",
                    "--headless",
                    "--script",
                    folder / "script",
                    "-o",
                    folder / "pictures",
                    "--overwrite"};
          },
          {{"out.kerf", Likeness::same_recording}, {"pictures/shot.png", Likeness::same_end}}};
}

Scenario bench_scenario() {
  return {"bench",
          [](const Path& folder) { write(folder / "bench.json", "an earlier table"); },
          [](const Path& folder) -> Words {
            return {"bench",
                    "--scenes",
                    "uniform",
                    "--dims",
                    "2",
                    "--objects",
                    "40",
                    "--algorithms",
                    "kerf",
                    "--rounds",
                    "1",
                    "--steps",
                    "2",
                    "--warm-up",
                    "1",
                    "--json",
                    folder / "bench.json",
                    "--overwrite"};
          },
          {{"bench.json", Likeness::same_end}}};
}

Scenario advise_scenario() {
  return {"advise",
          [](const Path& folder) {
            record(folder / "in.kerf", "12");
            write(folder / "advice.json", "an earlier table");
            write(folder / "advice.svg", "an earlier picture");
          },
          [](const Path& folder) -> Words {
            return {
                "advise", folder / "in.kerf",     "--broad-phases", "kerf,columns",        "--rounds",   "2",
                "--json", folder / "advice.json", "--plot",         folder / "advice.svg", "--overwrite"};
          },
          {{"advice.json", Likeness::same_end}, {"advice.svg", Likeness::same_end}}};
}

}  // namespace

const std::vector<Scenario>& scenarios() {
  static const std::vector<Scenario> kAll{record_scenario(),  import_scenario(),     rerun_scenario(),
                                          render_scenario(),  collect_scenario(),    minimize_scenario(),
                                          report_scenario(),  experiment_scenario(), step_scenario(),
                                          export_scenario(),  film_diff_scenario(),  film_scenario(),
                                          approve_scenario(), diff_page_scenario(),  debug_scenario(),
                                          bench_scenario(),   study_scenario(),      advise_scenario()};
  return kAll;
}

}  // namespace kerf::faults
