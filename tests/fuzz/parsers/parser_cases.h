#pragma once

#include <string>

#include "tests/fuzz/corpus.h"

namespace kerf::test {

// Each feeds a case to a parser and returns what is wrong with its answer; empty: nothing. Errors that the
// parser documents are no finding; others are thrown on.

/// `apply` of a configuration: what it accepts is valid and survives being written and read.
std::string config_case(CaseBytes bytes);

/// The options of `kerf render`, one a line: scene, steps, size, camera, layers, configuration and so on.
std::string request_case(CaseBytes bytes);

/// A PNG, as it is and with the checksums of its chunks put right: chance does not get past them.
std::string png_case(CaseBytes bytes);

/// A table of comma-separated values, as boxes and as pairs of another engine.
std::string csv_case(CaseBytes bytes);
/// A manifest of a sequence: what is accepted survives being written and read.
std::string manifest_case(CaseBytes bytes);
/// What lies beside a frame: what is in it.
std::string draw_list_case(CaseBytes bytes);
/// A script of the debugger, which is only read.
std::string script_case(CaseBytes bytes);
/// A camera that moves, in both dimensions.
std::string camera_path_case(CaseBytes bytes);

}  // namespace kerf::test
