#pragma once

#include <functional>
#include <string>
#include <vector>

namespace kerf {

/// Something that Kerf uses.
struct Part {
  std::string name;                   ///< "display"
  std::function<std::string()> look;  ///< says what is there; throws, with the reason, if nothing is
  std::string advice;                 ///< what to do if nothing is
  bool is_needed = false;             ///< for pictures and recordings; all else is for some commands
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

/// Processors that this process may use, which may be fewer than the machine has.
unsigned usable_processors();

/// Encoders of films that `encoders`, the list that ffmpeg prints, does not have, by the endings of their
/// files.
std::vector<std::string> films_without_encoder(const std::string& encoders);

}  // namespace kerf
