#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "frames/support/shard.h"

namespace kerf {

/// The options of `kerf report` as the user typed them; empty: not given.
struct ReportTexts {
  std::vector<std::string> sections;
  std::string out = "out/report.html";
  std::string hardcases = "out/hardcases";
  std::string objects;
  std::string steps;
  std::string rounds;
  std::string seeds;
  std::string shard;
  bool full = false;
  bool fresh = false;
  bool overwrite = false;
};

/// The size and length of the measurements.
struct ReportSizes {
  std::uint32_t objects = 1000;       ///< boxes of motions, and bricks
  std::uint32_t steps = 100;          ///< that count, after a warm-up
  std::uint32_t rounds = 3;           ///< the least counts for each step
  std::uint32_t scene_objects = 500;  ///< moving objects of a recorded scene
  std::uint32_t need_objects = 2000;  ///< where needs are switched on: more than a leaf holds
  std::uint32_t loop_objects = 120;   ///< moving objects of a scene in which the pairs decide the motion
  std::uint32_t loop_steps = 250;     ///< of these, the objects come in the first two fifths
  std::uint32_t seeds = 16;           ///< of such scenes
};

/// What to show, every part of it checked.
struct ReportRequest {
  std::vector<std::string> sections;  ///< by name, in the order of the page
  ReportSizes sizes;
  std::filesystem::path out;        ///< the page
  std::filesystem::path kept;       ///< the figures, beside it
  Shard shard;                      ///< of the measurements; of several, none writes the page
  std::filesystem::path hardcases;  ///< the folder of `./run hardcases`
  bool fresh = false;               ///< figures of an earlier run are discarded
  bool overwrite = false;           ///< so are those of another machine or version, and the page is replaced
  std::string options;              ///< the options that decide what is measured, as typed
};

/// `known` are the names of all sections. Throws UsageError that says what to do.
ReportRequest parse_report_request(const ReportTexts& texts, const std::vector<std::string>& known);

}  // namespace kerf
