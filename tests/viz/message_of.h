#pragma once

#include <string>

namespace kerf::test {

/// The message of the exception that `act` throws; empty if it throws none.
template <class Error, class Act>
std::string message_of(Act act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace kerf::test
