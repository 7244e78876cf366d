#include "tests/fuzz/parsers/parser_cases.h"
#include "viz/debugger/script.h"

namespace kerf::test {

std::string script_case(CaseBytes bytes) {
  try {
    int last = 0;
    for (const ScriptLine& line : parse_script({reinterpret_cast<const char*>(bytes.data()), bytes.size()})) {
      if (line.words.empty()) return "a line without words";
      if (line.number <= last) return "lines that do not count up";
      last = line.number;
    }
    return "";
  } catch (const ScriptError& error) {
    return error.what()[0] == '\0' ? "an error without a message" : "";
  }
}

}  // namespace kerf::test
