#include "frames/support/utf8.h"

#include <nlohmann/json.hpp>

namespace kerf {

std::string valid_utf8(const std::string& text) {
  using Json = nlohmann::json;
  constexpr std::string_view kReplacement = "\xef\xbf\xbd";  // U+FFFD
  std::string valid = Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace));
  for (std::size_t at = 0; (at = valid.find(kReplacement, at)) != std::string::npos;)
    valid.replace(at, kReplacement.size(), "_");
  return valid;
}

}  // namespace kerf
