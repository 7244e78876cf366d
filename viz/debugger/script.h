#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/part_file.h"
#include "viz/debugger/debugger.h"

namespace kerf {

/// A line of a script cannot be understood or done; the message names the line.
class ScriptError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a line expects does not hold.
class ExpectationFailed : public ScriptError {
 public:
  using ScriptError::ScriptError;
};

/// One line: its words; quotes make several words one.
struct ScriptLine {
  int number = 0;
  std::vector<std::string> words;
};

/// Lines without comments and empty ones. Throws ScriptError.
std::vector<ScriptLine> parse_script(std::string_view text);

/// The folder of the pictures, and whether they replace earlier ones.
struct PictureFolder {
  std::filesystem::path path;
  Replace replace = Replace::nothing;
};

/// Drives a debugger as a user would, line by line. docs/DEBUGGING.md has the commands.
class ScriptPlayer {
 public:
  /// The folder is made when the first picture is taken; one that a script takes twice replaces the first.
  /// `present` is called after each frame, so that a window can show it.
  ScriptPlayer(Debugger& debugger, int width, int height, PictureFolder folder,
               std::function<void()> present = {});

  /// Throws ScriptError, or std::runtime_error if a picture cannot be written.
  void play(const std::vector<ScriptLine>& lines);

 private:
  struct Point {
    float x = 0;
    float y = 0;
  };

  void play(const ScriptLine& line);
  void frames(int count);
  void click(const Point& point, int button, int times);
  void drag(const ScriptLine& line);
  void turn_wheel(const ScriptLine& line);
  void press(const ScriptLine& line, const std::string& text);
  void use_session(const ScriptLine& line);
  void take_picture(const std::string& name);
  void expect(const ScriptLine& line);
  [[nodiscard]] std::string fact(const ScriptLine& line, const std::string& name);
  [[nodiscard]] Point place(const ScriptLine& line, const std::string& word);

  Debugger& debugger_;
  int width_;
  int height_;
  PictureFolder folder_;
  std::set<std::string> taken_;
  std::function<void()> present_;
  DebuggerInput input_;
  std::map<std::string, std::string> remembered_;
};

}  // namespace kerf
