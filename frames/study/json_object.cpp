#include "frames/study/json_object.h"

#include <algorithm>
#include <set>
#include <utility>

#include "frames/support/errors.h"
#include "frames/support/suggest.h"
#include "frames/support/text_file.h"

namespace kerf {
namespace {

/// Finds keys that stand twice in an object while a file is parsed; the parser keeps the last one.
class DoubleKeys {
 public:
  bool operator()(int /*depth*/, Json::parse_event_t event, const Json& parsed) {
    if (event == Json::parse_event_t::object_start) keys_.emplace_back();
    if (event == Json::parse_event_t::object_end) keys_.pop_back();
    if (event == Json::parse_event_t::key && !keys_.back().insert(parsed.get<std::string>()).second)
      throw UsageError("the key \"" + parsed.get<std::string>() + "\" stands twice in an object");
    return true;
  }

 private:
  std::vector<std::set<std::string>> keys_;
};

std::string range_of(std::uint64_t least, std::uint64_t most) {
  return "a whole number from " + std::to_string(least) + " to " + std::to_string(most);
}

}  // namespace

JsonObject::JsonObject(const Json& object, std::string prefix)
    : object_(object), prefix_(std::move(prefix)) {}

const Json* JsonObject::find(const std::string& key) {
  asked_.push_back(key);
  const auto found = object_.find(key);
  return found == object_.end() ? nullptr : &*found;
}

std::vector<Json> JsonObject::items(const std::string& key) {
  const Json* const value = find(key);
  if (value == nullptr) return {};
  if (!value->is_array()) return {*value};
  if (value->empty()) refuse(key, "the list is empty; leave the key out for its default");
  return {value->begin(), value->end()};
}

std::vector<std::uint64_t> JsonObject::numbers(const std::string& key, std::uint64_t least,
                                               std::uint64_t most, std::vector<std::uint64_t> usual) {
  std::vector<std::uint64_t> found;
  for (const Json& item : items(key)) {
    const std::size_t place = found.size();
    if (!item.is_number_unsigned() || item.get<std::uint64_t>() < least || item.get<std::uint64_t>() > most)
      refuse(key, place, item.dump() + " is not " + range_of(least, most));
    if (std::ranges::find(found, item.get<std::uint64_t>()) != found.end())
      refuse(key, place, item.dump() + " stands twice");
    found.push_back(item.get<std::uint64_t>());
  }
  return found.empty() ? usual : found;
}

std::uint64_t JsonObject::number(const std::string& key, std::uint64_t least, std::uint64_t most,
                                 std::uint64_t usual) {
  const auto found = numbers(key, least, most, {usual});
  if (found.size() > 1) refuse(key, "this is one number, not a list");
  return found.front();
}

std::vector<std::string> JsonObject::words(const std::string& key, std::vector<std::string> usual) {
  std::vector<std::string> found;
  for (const Json& item : items(key)) {
    if (!item.is_string()) refuse(key, found.size(), item.dump() + " is not a text in quotes");
    if (std::ranges::find(found, item.get<std::string>()) != found.end())
      refuse(key, found.size(), item.dump() + " stands twice");
    found.push_back(item.get<std::string>());
  }
  return found.empty() ? usual : found;
}

std::string JsonObject::word(const std::string& key, std::string usual) {
  const auto found = words(key, {std::move(usual)});
  if (found.size() > 1) refuse(key, "this is one text, not a list");
  return found.front();
}

std::vector<JsonObject> JsonObject::objects(const std::string& key) {
  const Json* const value = find(key);
  if (value == nullptr || !value->is_array() || value->empty())
    refuse(key, "this must be a list of objects, [{ ... }, ...]");
  std::vector<JsonObject> found;
  for (std::size_t k = 0; k < value->size(); ++k) {
    if (!(*value)[k].is_object()) refuse(key, k, "this must be an object, { ... }");
    found.emplace_back((*value)[k], place_of(key, k) + ".");
  }
  return found;
}

void JsonObject::refuse_the_rest() const {
  for (const auto& [key, value] : object_.items())
    if (std::ranges::find(asked_, key) == asked_.end()) refuse(key, unknown_name_message("key", key, asked_));
}

std::string JsonObject::place_of(const std::string& key, std::size_t item) const {
  const auto value = object_.find(key);
  const bool is_list = value != object_.end() && value->is_array();
  return prefix_ + key + (is_list ? "[" + std::to_string(item) + "]" : "");
}

void JsonObject::refuse(const std::string& key, const std::string& what) const {
  throw UsageError(prefix_ + key + ": " + what);
}

void JsonObject::refuse(const std::string& key, std::size_t item, const std::string& what) const {
  throw UsageError(place_of(key, item) + ": " + what);
}

Json read_json_object(const std::string& file) {
  const std::string read = read_text_file(file);
  try {
    Json json = Json::parse(read, DoubleKeys(), true, true);
    if (!json.is_object()) throw UsageError("the file must hold an object, { ... }");
    return json;
  } catch (const Json::exception& error) {
    const std::string text = error.what();  // "[json.exception.parse_error.101] parse error at line 3, ..."
    throw UsageError(file + ": " + text.substr(std::min(text.size(), text.find("] ") + 2)));
  } catch (const UsageError& error) {
    throw UsageError(file + ": " + error.what());
  }
}

}  // namespace kerf
