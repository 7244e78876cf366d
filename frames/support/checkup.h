#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

namespace kerf {

/// Something that Kerf uses.
struct Part {
  std::string name;                   ///< "display"
  std::function<std::string()> look;  ///< says what is there; throws, with the reason, if nothing is
  std::string advice;                 ///< what to do if nothing is
  bool is_needed = false;             ///< for pictures and recordings; all else is for some commands
};

/// Thrown by `look` where something else than the advice of the part helps.
struct OtherProblem : std::runtime_error {
  OtherProblem(const std::string& what, std::string what_to_do)
      : std::runtime_error(what), advice(std::move(what_to_do)) {}
  std::string advice;
};

/// What was found of it.
struct Finding {
  std::string name;
  bool is_there = false;
  std::string what;    ///< or why nothing is
  std::string advice;  ///< empty if it is there
  bool is_needed = false;
};
Finding look_for(const Part& part);

/// What a program prints, and its first line. Throws std::runtime_error if it cannot be run or fails.
std::string output_of(const std::string& command);
std::string first_line_of(const std::string& command);

}  // namespace kerf
