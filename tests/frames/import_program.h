#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/frames/program.h"

namespace kerf::test {

/// Imports small files in the manner of bug reports; those of tests/frames/cases are one folder each.
class ImportProgram : public ::testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() / name; }
  static std::string given(const std::string& name) {
    return std::string(KERF_SOURCE_DIR) + "/tests/frames/cases/" + name;
  }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  /// Imports as NAME.kerf; `more` are further arguments.
  [[nodiscard]] RunOutcome import(const std::string& name, const std::string& boxes,
                                  const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"import", boxes, "-o", path(name + ".kerf"), "--overwrite"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_kerf(arguments);
  }
  /// What is printed of an import that works.
  [[nodiscard]] std::string imported(const std::string& name, const std::string& boxes,
                                     const std::vector<std::string>& more = {}) const {
    const RunOutcome outcome = import(name, boxes, more);
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    return outcome.out;
  }
  [[nodiscard]] std::string refused(const std::string& boxes,
                                    const std::vector<std::string>& more = {}) const {
    const RunOutcome outcome = import("refused", boxes, more);
    EXPECT_EQ(outcome.exit, 2) << outcome.out;
    EXPECT_FALSE(std::filesystem::exists(path("refused.kerf")));
    return outcome.err;
  }
  [[nodiscard]] std::string explained(const std::string& name, const std::string& step,
                                      const std::string& pair) const {
    const RunOutcome outcome = run_kerf({"explain", path(name + ".kerf"), "--step", step, "--pair", pair});
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    return outcome.out;
  }
  [[nodiscard]] std::string exported(const std::string& name, const std::string& what) const {
    const RunOutcome outcome = run_kerf({"export", path(name + ".kerf"), what});
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    return outcome.out;
  }
  [[nodiscard]] std::string stepped(const std::string& name, const std::string& condition) const {
    return run_kerf({"step", path(name + ".kerf"), "--to", condition}).out;
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace kerf::test
