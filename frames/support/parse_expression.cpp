#include "frames/support/parse_expression.h"

#include <stdexcept>

#include "frames/support/errors.h"

namespace kerf {

Expression parse_expression(const std::string& option, const std::string& text) {
  try {
    return Expression::parse(text);
  } catch (const std::invalid_argument& error) {
    throw UsageError(option + ": " + error.what());
  }
}

}  // namespace kerf
