#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/given_id.h"
#include "core/recording/theirs.h"
#include "frames/import/bound_writing.h"
#include "frames/import/coarse_writing.h"
#include "frames/support/csv_table.h"

namespace kerf {

/// A time with the text that gave it.
struct GivenStep {
  long double time = 0;
  std::string text;

  [[nodiscard]] bool is_date() const { return text.find(':') != std::string::npos; }
};

/// What keeps two steps from standing in one run: one is a date and the other is a number, or they differ,
/// but not in the 64 bits that count. Empty: nothing does.
std::string conflict_of(const GivenStep& a, const GivenStep& b);

/// One line of a table of boxes.
struct BoxLine {
  enum class Kind : std::uint8_t { box, removal, nothing };
  /// What is odd about the numbers, though they can be played.
  enum class Oddity : std::uint8_t { none, half_blank, not_a_number, inverted, infinite };

  Kind kind = Kind::box;  ///< `nothing`: the step has the line, and no object has it
  Oddity oddity = Oddity::none;
  std::size_t line = 0;
  GivenId object;
  std::array<double, 3> min{};  ///< those of a half blank box are NaN where they are blank
  std::array<double, 3> max{};
  std::optional<bool> fixed;  ///< none, here and of what follows: not said
  std::optional<std::uint64_t> category;
  std::optional<std::uint64_t> mask;
  /// How its shape is turned: in 2D an angle in radians, in 3D a quaternion w, x, y, z.
  std::optional<std::array<double, 4>> turn;
};

/// Reads step,object,min_x,max_x,min_y,max_y[,min_z,max_z][,fixed][,category][,mask]
/// [,angle, in 3D ,qw,qx,qy,qz], by the names of a
/// heading in any order, or without a heading in this order. Throws as CsvTable does, and UsageError if the
/// file is not the same in every pass.
class BoxLines {
 public:
  explicit BoxLines(const std::filesystem::path& path);

  [[nodiscard]] int dimension() const { return dimension_; }
  /// The names of the columns that are there.
  [[nodiscard]] std::string columns() const { return table_.names(); }

  bool next();
  void rewind() { table_.rewind(); }
  [[nodiscard]] GivenStep step() const;
  /// None: the line has no object.
  [[nodiscard]] std::optional<GivenId> object() const;
  [[nodiscard]] BoxLine read() const;
  /// Notes how the bounds of the line were written. Of those by which pairs are judged, what is no double is
  /// refused.
  void note_digits(TableWriting& written) const;
  void note_remainders(Remainders& remainders) const;
  void note_writing(BoundWriting& writing) const;
  [[noreturn]] void reject(const std::string& what) const { table_.reject(what); }
  /// The file has another text than in the pass before.
  [[noreturn]] void reject_change() const;
  [[nodiscard]] const CsvTable& table() const { return table_; }

 private:
  void find_dimension();
  void check_turn_columns() const;
  void set_order();
  void read_bounds(BoxLine& line) const;
  [[nodiscard]] std::string_view judged_bound(std::size_t column) const;
  [[nodiscard]] std::optional<std::array<double, 4>> read_turn() const;

  CsvTable table_;
  int dimension_ = 3;
  std::optional<std::uint64_t> fingerprint_;  ///< of the passes that have come to the end
};

/// The six columns of a box's bounds, min_x, max_x, min_y and so on.
std::vector<CsvColumn> bound_columns();
/// The column of steps, for every table that has one.
CsvColumn step_column();
/// The time of a step in a column. Throws UsageError that names the line if it is none.
GivenStep read_step(const CsvTable& table, std::size_t column);

}  // namespace kerf
