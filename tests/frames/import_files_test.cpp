// Imports of files that change while they are read, are not whole, or do not name objects alike.

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <charconv>

#include "core/files/part_file.h"
#include "tests/frames/import_program.h"
#include "tests/support/recorded_crowd.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Words = std::vector<std::string>;

const std::string kHead = "step,object,min_x,max_x,min_y,max_y\n";

class ImportFiles : public test::ImportProgram {
 protected:
  /// More than a reader buffers: two objects that overlap in each step.
  [[nodiscard]] static std::string long_run() {
    std::string text = kHead;
    for (int step = 1; step <= 8000; ++step)
      text += std::to_string(step) + ",1,0,1,0,1\n" + std::to_string(step) + ",2,0,1,0,1\n";
    return text;
  }

  /// Writes `later` to the boxes after they were read once: then an import opens its table of objects, here a
  /// pipe.
  [[nodiscard]] RunOutcome import_of_changing(const std::string& later) const {
    const std::string boxes = write("boxes.csv", long_run());
    const std::string pipe = path("objects");
    EXPECT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    Process process(test::kerf_command({"import", boxes, "--objects", pipe, "-o", path("a.kerf")}));
    int writer = -1;
    EXPECT_TRUE(test::holds_within_a_minute([&] {
      writer = open(pipe.c_str(), O_WRONLY | O_NONBLOCK);
      return writer >= 0;
    })) << "the table of objects is not read";
    (void)write("boxes.csv", later);
    const std::string objects = "object,name\n1,one\n";
    EXPECT_EQ(::write(writer, objects.data(), objects.size()), static_cast<ssize_t>(objects.size()));
    close(writer);
    return process.wait();
  }

  void expect_refused(const std::string& later) const {
    const RunOutcome outcome = import_of_changing(later);
    EXPECT_EQ(outcome.exit, 2) << outcome.out;
    EXPECT_THAT(outcome.err, HasSubstr("boxes.csv changed while it was read; import a copy of it"));
    EXPECT_FALSE(std::filesystem::exists(path("a.kerf")));
    EXPECT_TRUE(parts_of(path("a.kerf")).empty());
  }
};

TEST_F(ImportFiles, AFileThatStaysIsImported) { EXPECT_EQ(import_of_changing(long_run()).exit, 0); }

TEST_F(ImportFiles, AFileThatIsCutMeanwhileIsRefused) {
  const std::string all = long_run();
  expect_refused(all.substr(0, all.rfind("4000,1,")));
}

TEST_F(ImportFiles, AFileThatGrowsMeanwhileIsRefused) { expect_refused(long_run() + "8001,1,0,1,0,1\n"); }

TEST_F(ImportFiles, AFileThatGetsAnotherObjectMeanwhileIsRefused) {
  expect_refused(long_run() + "8000,50000,0,1,0,1\n");
}

TEST_F(ImportFiles, AFileOfWhichANumberChangesMeanwhileIsRefused) {
  std::string later = long_run();
  later.replace(later.rfind("7000,2,0,1"), 10, "7000,2,5,9");
  expect_refused(later);
}

/// "1,12,1" may be the beginning of "1,12,123".
TEST_F(ImportFiles, ALastLineWithoutAnEndIsOdd) {
  const std::string boxes = kHead + "1,1,0,1,0,1\n1,12,0,1,0,1\n1,123,0,1,0,1";
  const std::string pairs = "step,a,b\n1,1,12\n1,1,123\n1,12,1";
  const std::string odd = "odd: 1 table whose last line does not end: is the file cut off?\n  ";
  const std::string whole = write("whole.csv", boxes + "\n");
  const std::string cut = write("cut.csv", pairs);
  const std::string out = imported("a", whole, {"--pairs", cut});
  EXPECT_THAT(out, HasSubstr("1 missed, 0 extra, 1 twice"));
  EXPECT_THAT(out, HasSubstr(odd + cut + ", line 4\n"));
  EXPECT_THAT(refused(whole, {"--pairs", cut, "--strict"}), HasSubstr(odd));
  EXPECT_THAT(refused(write("boxes.csv", boxes), {"--strict"}), HasSubstr("boxes.csv, line 4\n"));
  EXPECT_THAT(refused(whole, {"--pairs", write("no_pairs.csv", "step,a,b\n"), "--ignore",
                              write("ignore.csv", "1,12"), "--strict"}),
              HasSubstr("ignore.csv, line 1\n"));
  EXPECT_THAT(refused(whole, {"--objects", write("objects.csv", "object,name\n1,on"), "--strict"}),
              HasSubstr("objects.csv, line 2\n"));
  EXPECT_THAT(refused(whole, {"--structure",
                              write("nodes.csv",
                                    "step,node,parent,min_x,max_x,min_y,max_y,object\n"
                                    "1,0,-1,0,1,0,1,1 12 12"),
                              "--strict"}),
              HasSubstr("nodes.csv, line 2\n"));
}

TEST_F(ImportFiles, ATableWithoutAnyPairIsOddIfBoxesOverlap) {
  const std::string none = write("none.csv", "step,a,b\n");
  const std::string boxes = write("boxes.csv", kHead + "1,1,0,1,0,1\n1,2,0,1,0,1\n2,2,0,1,0,1\n");
  const std::string odd = none + ": there is no pair at all\n";
  const std::string out = imported("a", boxes, {"--pairs", none});
  EXPECT_THAT(out, HasSubstr("2 missed, 0 extra"));
  EXPECT_THAT(
      out, HasSubstr("odd: 1 table of pairs that ends before the boxes: later overlaps count as missed\n  " +
                     odd));
  EXPECT_THAT(refused(boxes, {"--pairs", none, "--strict"}), HasSubstr(odd));
  const std::string apart = write("apart.csv", kHead + "1,1,0,1,0,1\n1,2,3,4,0,1\n");
  EXPECT_THAT(imported("b", apart, {"--pairs", none, "--strict"}), HasSubstr("0 missed, 0 extra"));
}

/// As an earlier Kerf left a recording when it was killed: with a last step that was not judged.
TEST_F(ImportFiles, AStepWithoutThePairsOfTheOtherEngineIsNamed) {
  const std::string boxes = kHead + "1,1,0,1,0,1\n1,2,0,1,0,1\n2,2,0,1,0,1\n";
  (void)imported("a", write("boxes.csv", boxes), {"--pairs", write("pairs.csv", "step,a,b\n1,1,2\n2,1,2\n")});
  for (const std::string table : {"their_steps", "their_pairs", "their_seals"})
    test::change_recording(path("a.kerf"), "DELETE FROM " + table + " WHERE step = 2");
  test::change_recording(path("a.kerf"), "DELETE FROM meta WHERE key = 'end'");
  test::change_recording(path("a.kerf"), "UPDATE meta SET value = '0' WHERE key = 'complete'");
  EXPECT_THAT(explained("a", "2", "1,2"),
              HasSubstr("the other engine's pairs of step 2 are not in the recording\n"));
  EXPECT_THAT(explained("a", "1", "1,2"), Not(HasSubstr("not in the recording")));
  const RunOutcome verified = test::run_kerf({"verify", path("a.kerf")});
  EXPECT_EQ(verified.exit, 0);
  EXPECT_THAT(verified.out,
              HasSubstr("not checked: the other engine's pairs of step 2: they are not in the recording\n"));
}

TEST_F(ImportFiles, WholeFilesWithOtherEndsOfLinesAreNotOdd) {
  for (const std::string end : {"\n", "\r", "\r\n", "\n\n", "\n# that was all\n"}) {
    const std::string boxes = write("boxes.csv", "1,1,0,1,0,1\n1,2,3,4,0,1" + end);
    EXPECT_THAT(imported("a", boxes, {"--strict"}), Not(HasSubstr("odd")));
  }
}

/// A right engine that writes a handle with a sign in one table missed all pairs of that object.
TEST_F(ImportFiles, ObjectsWithASignInOneTableOnlyAreRefused) {
  const auto said = [&](const std::string& of_boxes, const std::string& of_pairs) {
    const std::string boxes = write("boxes.csv", kHead + "1," + of_boxes + ",0,1,0,1\n1,7,0,1,0,1\n");
    const std::string pairs = write("pairs.csv", "step,a,b\n1,7," + of_pairs + "\n");
    return refused(boxes, {"--pairs", pairs});
  };
  EXPECT_THAT(
      said("18446744073709551614", "-2"),
      HasSubstr("pairs.csv, line 2: there is no object -2, but 18446744073709551614 has the same 64 bits: "
                "write objects with a sign in all tables, or in none"));
  EXPECT_THAT(said("-9223372036854775808", "9223372036854775808"), HasSubstr("has the same 64 bits"));
  EXPECT_THAT(said("4294967294", "-2"), HasSubstr("has the same 32 bits"));
  EXPECT_THAT(said("-2147483648", "2147483648"), HasSubstr("has the same 32 bits"));
  const std::string boxes = write("boxes.csv", kHead + "1,4294967294,0,1,0,1\n1,7,0,1,0,1\n");
  EXPECT_THAT(refused(boxes, {"--structure", write("nodes.csv",
                                                   "step,node,parent,min_x,max_x,min_y,max_y,object\n"
                                                   "1,0,,0,1,0,1,7 -2\n")}),
              HasSubstr("nodes.csv, line 2: there is no object -2"));
  EXPECT_THAT(refused(boxes, {"--pairs", write("no_pairs.csv", "step,a,b\n"), "--ignore",
                              write("ignore.csv", "a,b\n7,-2\n")}),
              HasSubstr("ignore.csv, line 2: there is no object -2"));
  const std::string both = write("both.csv", kHead + "1,4294967294,0,1,0,1\n1,-2,0,1,0,1\n1,7,9,9,9,9\n");
  EXPECT_THAT(imported("a", both, {"--pairs", write("pairs.csv", "step,a,b\n1,-2,4294967294\n")}),
              HasSubstr(": 0 missed, 0 extra"))
      << "two objects";
  EXPECT_THAT(imported("a", boxes, {"--pairs", write("pairs.csv", "step,a,b\n1,4294967294,7\n1,9,7\n")}),
              HasSubstr("odd: 1 pair with an object that is not there"));
}

/// As printf writes a time.
struct TimeWriting {
  std::chars_format format;
  int digits;
  std::string before{};

  [[nodiscard]] std::string text(double time) const {
    std::array<char, 40> text{};
    return before +
           std::string(text.begin(), std::to_chars(text.begin(), text.end(), time, format, digits).ptr);
  }
};

/// The pairs of a right engine were missed in its steps and extra in others.
TEST_F(ImportFiles, StepsOfFewerDigitsInOneTableAreRefused) {
  const auto tables = [&](const TimeWriting& of_boxes, const TimeWriting& of_pairs, double length) {
    std::string boxes = kHead;
    std::string pairs = "step,a,b\n";
    double time = 0;
    for (int step = 0; step < 60; ++step, time += length) {
      const std::string at = of_boxes.text(time);
      boxes += at + ",1,0,2,0,1\n" + at + ",2,1," + std::to_string(3 + step) + ",0,1\n";
      pairs += of_pairs.text(time) + ",1,2\n";
    }
    write("pairs.csv", pairs);
    return write("boxes.csv", boxes);
  };
  const TimeWriting all{std::chars_format::general, 17};
  const TimeWriting six{std::chars_format::general, 6};
  const TimeWriting six_decimals{std::chars_format::fixed, 6};
  const TimeWriting microseconds{std::chars_format::fixed, 6, "2024-05-01T12:00:0"};
  const TimeWriting milliseconds{std::chars_format::fixed, 3, "2024-05-01T12:00:0"};
  const Words with_pairs{"--pairs", path("pairs.csv")};
  const auto said = [&](const TimeWriting& of_boxes, const TimeWriting& of_pairs, double length) {
    return refused(tables(of_boxes, of_pairs, length), with_pairs);
  };
  EXPECT_THAT(
      said(all, six, 0.1),
      HasSubstr("pairs.csv, line 3: step 0.1 is no step of the boxes, but step 0.10000000000000001 is "
                "the same in as many digits: write steps alike in all tables"));
  EXPECT_THAT(said(all, six_decimals, 1.0 / 60), HasSubstr("0.016667 is no step of the boxes"));
  EXPECT_THAT(said(all, six, 1e8 / 3), HasSubstr("step 3.33333e+07 is no step of the boxes"));
  EXPECT_THAT(said(six, all, 0.1), HasSubstr("but step 0.1 is the same in as many digits"));
  EXPECT_THAT(said(microseconds, milliseconds, 1.0 / 60), HasSubstr("is the same in as many digits"));
  for (const TimeWriting& both : {all, six, six_decimals, milliseconds})
    EXPECT_THAT(imported("a", tables(both, both, 1.0 / 60), with_pairs), HasSubstr(": 0 missed, 0 extra"));
}

/// Where nothing moves there need be no boxes.
TEST_F(ImportFiles, PairsBetweenStepsOfBoxesAreNoStepsOfFewerDigits) {
  const auto plays = [&](const Words& box_steps, const Words& pair_steps) {
    std::string boxes = kHead;
    for (const std::string& step : box_steps) boxes += step + ",1,0,2,0,1\n" + step + ",2,1,3,0,1\n";
    std::string pairs = "step,a,b\n";
    for (const std::string& step : pair_steps) pairs += step + ",1,2\n";
    const Words with_pairs{"--pairs", write("pairs.csv", pairs)};
    EXPECT_THAT(imported("a", write("boxes.csv", boxes), with_pairs), HasSubstr(" missed, 0 extra"));
  };
  plays({"1", "2", "3"}, {"1", "2", "2.25", "3"});
  plays({"1", "2", "3"}, {"1", "2", "3", "4"});
  plays({"0.5", "1.5", "2.5", "3.5", "4.5"}, {"2", "3", "4"});
  plays({"0.95", "0.966667", "0.983333", "1.01667"}, {"0.95", "0.966667", "0.983333", "1", "1.01667"});
  plays({"0.01", "0.02", "0.05"}, {"0.01", "0.03", "0.04", "0.05"});
  plays({"100000", "100010"}, {"100000", "100001", "100010"});
  plays({"7"}, {"7.1"});
}

}  // namespace
}  // namespace kerf::test
