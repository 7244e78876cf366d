#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "frames/study/study.h"
#include "frames/support/errors.h"
#include "tests/frames/study/study_files.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

Study read(const std::string& text) { return read_study(StudyFolder(text).path("study.json")); }

std::string refusal(const std::string& text) {
  try {
    (void)read(text);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

/// A matrix of the file, with more keys.
std::string matrix(const std::string& keys) { return "{\"matrices\": [{" + keys + "}]}"; }

TEST(ReadStudy, EveryCombinationIsACell) {
  const Study study = read(StudyFolder::kSmall);
  EXPECT_EQ(study.name, "study");
  ASSERT_EQ(study.cells.size(), 2U * 2 * 2 * 3);
  std::set<std::string> ids;
  for (const StudyCell& cell : study.cells) ids.insert(cell.id);
  EXPECT_EQ(ids.size(), study.cells.size());
  const auto& cell = std::get<RunCell>(study.cells.back().work);
  EXPECT_EQ(cell.broad_phase, "columns");
  EXPECT_EQ(cell.options.objects, 60U);
  EXPECT_EQ(cell.options.seed, 2U);
  EXPECT_EQ(cell.steps, 3U);
  EXPECT_EQ(cell.warm_up, 2U);
  EXPECT_TRUE(cell.measures.errors);
}

TEST(ReadStudy, BroadPhasesAlternateWithinARepeat) {
  const Study study = read(matrix(R"("motions": "falling", "dimensions": 2, "repeats": 2)"));
  std::vector<std::string> order;
  for (const StudyCell& cell : study.cells) order.push_back(std::get<RunCell>(cell.work).broad_phase);
  EXPECT_EQ(order, (std::vector<std::string>{"kerf", "kerf-paper", "kerf", "kerf-paper"}));
}

TEST(ReadStudy, OnlyTreesTakeTheParameters) {
  const Study study = read(matrix(R"("motions": ["falling"], "dimensions": [3], "broad_phases":
    ["kerf", "columns"], "parameters": ["", "skin=0,byte_sweep=0"])"));
  std::vector<std::string> names;
  for (const StudyCell& cell : study.cells) names.push_back(std::get<RunCell>(cell.work).broad_phase);
  EXPECT_EQ(names, (std::vector<std::string>{"kerf", "kerf:skin=0:byte_sweep=0", "columns"}));
}

TEST(ReadStudy, WhatADimensionDoesNotHaveIsLeftOut) {
  const Study study =
      read(matrix(R"("motions": ["falling"], "broad_phases": ["kerf", "box2d-broad-phase"])"));
  EXPECT_EQ(study.cells.size(), 3U);
}

/// A study that is extended keeps the cells that are there, and one whose steps change has none of them.
TEST(ReadStudy, AnIdDependsOnTheSettingsAlone) {
  const std::string common = R"("motions": ["falling"], "dimensions": [2], "seeds": )";
  const Study small = read(matrix(common + R"([7], "steps": 5)"));
  const Study large = read(matrix(common + R"([1, 7], "steps": 5)"));
  const Study longer = read(matrix(common + R"([7], "steps": 6)"));
  ASSERT_EQ(small.cells.size(), 2U);
  EXPECT_EQ(small.cells[0].id, large.cells[2].id);
  EXPECT_EQ(small.cells[1].id, large.cells[3].id);
  EXPECT_NE(small.cells[0].id, longer.cells[0].id);
}

TEST(ReadStudy, CommentsMayStandInTheFile) {
  EXPECT_EQ(read("// why\n" + matrix("/* all */ \"motions\": [\"falling\"]")).cells.size(), 4U);
}

struct Fault {
  const char* text;
  const char* words;
};

TEST(ReadStudy, ErrorsNameTheLineOrTheKey) {
  const Fault faults[] = {
      {"{\"matrices\": [\n  {\"motions\" [1]}]}", "line 2"},
      {"[]", "must hold an object"},
      {"{}", "matrices: this must be a list"},
      {R"({"matrices": [], "name": 1})", "matrices: this must be a list"},
      {R"({"matrices": [3]})", "matrices[0]: this must be an object"},
      {R"({"matrices": [{"motions": ["falling"]}], "nme": 1})", "nme: unknown key 'nme'"},
      {R"({"matrices": [{"motions": ["falling"], "step": 3}]})",
       "matrices[0].step: unknown key 'step'; did you mean 'steps'"},
      {R"({"matrices": [{"motions": ["falling"], "steps": 3, "steps": 4}]})", "\"steps\" stands twice"},
      {R"({"matrices": [{"motions": ["falling"]}, {"motions": ["fallin"]}]})",
       "matrices[1].motions[0]: unknown scene 'fallin'; did you mean 'falling'"},
      {R"({"matrices": [{"scenes": ["pile", "pil"]}]})", "matrices[0].scenes[1]: unknown scene 'pil'"},
      {R"({"matrices": [{"motions": ["falling"], "objects": [100, 5]}]})",
       "matrices[0].objects[1]: 5 is not a whole number from 20 to 4000000"},
      {R"({"matrices": [{"motions": ["falling"], "objects": -1}]})", "matrices[0].objects: -1 is not"},
      {R"({"matrices": [{"motions": ["falling"], "objects": 1e3}]})", "matrices[0].objects: 1000.0 is not"},
      {R"({"matrices": [{"motions": ["falling"], "seeds": [1, 1]}]})",
       "matrices[0].seeds[1]: 1 stands twice"},
      {R"({"matrices": [{"motions": ["falling"], "seeds": []}]})", "matrices[0].seeds: the list is empty"},
      {R"({"matrices": [{"motions": ["falling"], "steps": [3, 4]}]})",
       "matrices[0].steps: this is one number"},
      {R"({"matrices": [{"motions": ["falling"], "broad_phases": ["kerf", "colums"]}]})",
       "matrices[0].broad_phases[1]: unknown algorithm 'colums'; did you mean 'columns'"},
      {R"({"matrices": [{"motions": ["falling"], "parameters": ["", "skn=0"]}]})",
       "matrices[0].parameters[1]: 'kerf:skn=0': unknown parameter 'skn'"},
      {R"({"matrices": [{"motions": ["falling"], "broad_phases": ["columns"], "parameters": ["skin=0"]}]})",
       "matrices[0].parameters: none of the broad phases takes any"},
      {R"({"matrices": [{"motions": ["falling"], "measure": ["time"]}]})",
       "matrices[0].measure[0]: choose from"},
      {R"({"matrices": [{"motions": ["falling"], "dimensions": [4]}]})",
       "matrices[0].dimensions[0]: 4 is not"},
      {R"({"matrices": [{"motions": ["falling"], "grow": 4}]})", "matrices[0].grow: motions have all"},
      {R"({"matrices": [{"scenes": ["attractors"], "grow": 4}]})",
       "matrices[0].grow: none of the scenes grows"},
      {R"({"matrices": [{"motions": ["falling"], "patience": 1e999}]})", "number overflow"},
      {R"({"matrices": [{"motions": ["falling"], "repeats": 10000, "seeds": [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11],
                         "objects": [20, 21, 22, 23, 24, 25, 26, 27, 28, 29]}]})",
       "matrices[0].repeats: more than 1000000 cells"},
      {R"({"matrices": [{"motions": ["falling"], "scenes": ["pile"]}]})", "a matrix has one of"},
      {R"({"matrices": [{"steps": 3}]})", "a matrix has one of"},
      {R"({"matrices": [{"recording": "none.kerf"}]})", "matrices[0].recording: there is no recording"},
      {R"({"matrices": [{"motions": ["falling"]}, {"motions": ["falling"]}]})", "is in this file twice"},
      {R"({"matrices": [{"motions": ["falling"], "dimensions": [3], "broad_phases": ["box2d-broad-phase"]}]})",
       "none of them exists"},
  };
  for (const Fault& fault : faults) {
    const std::string message = refusal(fault.text);
    EXPECT_THAT(message, HasSubstr(fault.words)) << fault.text;
    EXPECT_THAT(message, HasSubstr("study.json: ")) << fault.text;
  }
}

TEST(ReadStudy, TextsStandInQuotesAndOnce) {
  EXPECT_THAT(refusal(matrix(R"("motions": 3)")),
              HasSubstr("study.json: matrices[0].motions: 3 is not a text in quotes"));
  EXPECT_THAT(refusal(matrix(R"("motions": ["falling", null])")),
              HasSubstr("study.json: matrices[0].motions[1]: null is not a text in quotes"));
  EXPECT_THAT(refusal(matrix(R"("motions": "falling", "measure": ["times", "counts", "times"])")),
              HasSubstr(R"(study.json: matrices[0].measure[2]: "times" stands twice)"));
}

TEST(ReadStudy, AListIsRefusedWhereOneTextIsAsked) {
  EXPECT_THAT(refusal(matrix(R"("recording": ["none.kerf", "other.kerf"])")),
              HasSubstr("study.json: matrices[0].recording: this is one text, not a list"));
  EXPECT_THAT(refusal(matrix(R"("recording": "none.kerf", "size": ["80x60", "160x120"])")),
              HasSubstr("study.json: matrices[0].size: this is one text, not a list"));
}

TEST(ReadStudy, AFileThatIsNotThereIsSaid) {
  try {
    (void)read_study("nowhere/study.json");
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), HasSubstr("nowhere/study.json"));
  }
}

}  // namespace
}  // namespace kerf::test
