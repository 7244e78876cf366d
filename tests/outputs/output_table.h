#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace kerf::test {

/// What an output option names.
enum class OutputKind {
  file,
  recording,
  folder,     ///< in which the command writes the file `inside`
  sequence,   ///< a folder of frames and their manifest
  temporary,  ///< a folder in which nothing stays
};

/// An option that names an output of a command, and a run that writes it.
///
/// In `arguments` OUT is the output, and these are inputs: RECORDING, FRAMES and OTHER (folders of
/// sequences), BOXES (CSV), STUDY, SCRIPT (takes a screenshot called shot), PICTURE and HARD (a folder with
/// the table of hard cases). SCRATCH is a name that is free.
struct OutputCase {
  std::string command;
  std::string option;  ///< as the help has it
  OutputKind kind = OutputKind::file;
  std::string name;  ///< the output's own; of a folder, followed by /inside
  std::vector<std::string> arguments;
  bool succeeds = true;  ///< false: such a run would take too long for a test
};

inline void PrintTo(const OutputCase& row, std::ostream* out) { *out << row.command << " " << row.option; }

/// All of them: a test compares the table with what `kerf COMMAND --help` shows.
const std::vector<OutputCase>& output_table();

/// Options that name an input of a command, "render --camera-path": what else takes a file or folder.
/// Two of them are kept, too, always on top of what they were: the debugger's session and its window.
const std::vector<std::string>& input_options();

}  // namespace kerf::test
