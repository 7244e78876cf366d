#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "frames/page/cell.h"

namespace kerf {

/// Reads the values of a JSON object one by one, checks each, and refuses the keys that are left. All errors
/// are UsageErrors that begin with the place in the file: "study.json: matrices[0].objects[2]: ...".
class JsonObject {
 public:
  /// `prefix` is what errors write before the name of a key: "study.json: matrices[0].". The object must
  /// outlive this.
  JsonObject(const Json& object, std::string prefix);

  [[nodiscard]] bool has(const std::string& key) const { return object_.contains(key); }
  /// One value, or the list of them, each of which is a whole number from `least` to `most` and stands once;
  /// `usual` without the key.
  std::vector<std::uint64_t> numbers(const std::string& key, std::uint64_t least, std::uint64_t most,
                                     std::vector<std::uint64_t> usual);
  std::uint64_t number(const std::string& key, std::uint64_t least, std::uint64_t most, std::uint64_t usual);
  /// The same of words.
  std::vector<std::string> words(const std::string& key, std::vector<std::string> usual);
  std::string word(const std::string& key, std::string usual);
  /// The list of objects under that key, which must be there.
  std::vector<JsonObject> objects(const std::string& key);
  /// Refuses what nothing has asked for.
  void refuse_the_rest() const;

  [[noreturn]] void refuse(const std::string& key, const std::string& what) const;
  [[noreturn]] void refuse(const std::string& key, std::size_t item, const std::string& what) const;

 private:
  /// The value's items; a value that is no list is its only item. None without the key.
  std::vector<Json> items(const std::string& key);
  const Json* find(const std::string& key);
  [[nodiscard]] std::string place_of(const std::string& key, std::size_t item) const;

  const Json& object_;
  std::string prefix_;
  std::vector<std::string> asked_;
};

/// The object of a file, in which comments ("//" and "/* */") may stand. Throws UsageError that names the
/// file, and line and column or key, if it is no JSON, no object, or has a key twice.
Json read_json_object(const std::string& file);

}  // namespace kerf
