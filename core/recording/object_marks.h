#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/ids.h"
#include "core/base/rgb.h"

namespace kerf {

class Database;

/// A name and a colour of an object, beside its number.
struct ObjectMark {
  std::string label;  ///< "left wheel"; empty: none
  std::optional<Rgb> color;
  friend bool operator==(const ObjectMark&, const ObjectMark&) = default;
};

/// Whether a label can be shown: up to 200 bytes, and none of them a control character.
bool is_label(std::string_view text);

/// The marks of a run's objects.
class ObjectMarks {
 public:
  /// None: nothing is said of it.
  [[nodiscard]] const ObjectMark* find(ObjectId object) const;
  [[nodiscard]] std::optional<Rgb> color(ObjectId object) const;
  /// "12 left wheel": the number, or what stands for it, and the label if there is one.
  [[nodiscard]] std::string title(ObjectId object, const std::string& number) const;
  /// The objects whose labels contain the text, without regard to capitals, in the order of their numbers.
  [[nodiscard]] std::vector<ObjectId> called(std::string_view text) const;

  void set(ObjectId object, ObjectMark mark) { marks_[object] = std::move(mark); }
  [[nodiscard]] const std::map<ObjectId, ObjectMark>& all() const { return marks_; }
  friend bool operator==(const ObjectMarks&, const ObjectMarks&) = default;

 private:
  std::map<ObjectId, ObjectMark> marks_;
};

extern const char* const kMarkTable;

void write_marks(Database& database, const ObjectMarks& marks);
/// Throws std::runtime_error for a label or colour that is none, or an object that cannot be.
ObjectMarks read_marks(const Database& database);

}  // namespace kerf
